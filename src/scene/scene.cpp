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

std::vector<bool> used_materials(const Scene& scene) {
    std::vector<bool> used(scene.materials.size());
    for (const std::uint32_t material : scene.mesh.material) used[material] = true;
    if (!scene.spheres.empty()) used[scene.sphere_material] = true;
    return used;
}

}  // namespace ctpbench
