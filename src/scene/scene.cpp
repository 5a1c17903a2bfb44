#include "scene/scene.h"

namespace ctpbench {

// Over the triangles rather than the vertices: a mesh may hold vertices that no triangle uses, anywhere.
Box scene_bounds(const Scene& scene) {
    Box bounds = Box::empty();
    for (const auto& triangle : scene.mesh.triangles) {
        for (const std::uint32_t vertex : triangle) bounds.extend(scene.mesh.positions[vertex]);
    }
    for (const SphereShape& sphere : scene.spheres) {
        const Vec3 radius{sphere.radius, sphere.radius, sphere.radius};
        bounds.extend(Box{sphere.center - radius, sphere.center + radius});
    }
    return bounds;
}

}  // namespace ctpbench
