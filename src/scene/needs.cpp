#include "scene/needs.h"

#include "kernels/materials/list.h"
#include "kernels/primitives/list.h"

namespace ctpbench {
namespace {

std::uint32_t primitives_of(const Scene& scene) {
    GeometryView geometry{};  // as far as counts go
    geometry.triangle_count = static_cast<std::uint32_t>(scene.mesh.triangles.size());
    geometry.sphere_count = static_cast<std::uint32_t>(scene.spheres.size());
    return primitives_in(geometry);
}

}  // namespace

SceneNeeds needs_of(const Scene& scene) {
    SceneNeeds needs;
    needs.primitives = primitives_of(scene);
    const std::vector<bool> used = used_materials(scene);
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const MaterialDescription& look = scene.materials[i].look;
        needs.materials |= 1u << look.type;
        needs.textured = needs.textured || look.texture.exists();
    }
    return needs;
}

}  // namespace ctpbench
