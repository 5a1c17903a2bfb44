#include "measure/scene_result.h"

#include "scene/content_hash.h"

namespace ctpbench {

SceneResult describe(const Scene& scene, std::uint32_t spheres) {
    SceneResult r;
    r.name = scene.name, r.spheres = spheres;
    r.source = scene.source == SceneSource::mesh ? "mesh" : "stand-in";
    r.triangles = scene.mesh.triangles.size(), r.dropped_triangles = scene.dropped_triangles;
    r.hash = scene.content_hash, r.base_hash = base_hash(scene);
    r.needs = needs_of(scene), r.savings = scene.savings, r.columns = columns_of(scene);
    return r;
}

}  // namespace ctpbench
