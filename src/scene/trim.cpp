#include "scene/trim.h"

#include <array>
#include <bit>
#include <map>
#include <utility>

#include "kernels/materials/list.h"
#include "scene/needs.h"

namespace ctpbench {
namespace {

using Words = std::vector<std::uint32_t>;

template <class T>
constexpr auto words_of(const T& object) {
    return std::bit_cast<std::array<std::uint32_t, sizeof(T) / sizeof(std::uint32_t)>>(object);
}

// The type and the object that shading would ask: what tells materials apart.
Words behaviour(const MaterialDescription& look) {
    Words behaviour{look.type};
    visit_type<Materials>(look.type, [&](auto tag) {
        using T = typename decltype(tag)::type;
        // No constant if T had padding, whose bits would make equal objects differ.
        static_assert(words_of(T{}).size() > 0);
        const auto words = words_of(T::make(look));
        behaviour.insert(behaviour.end(), words.begin(), words.end());
    });
    return behaviour;
}

void trim_materials(Scene& scene) {
    const std::vector<bool> used = used_materials(scene);
    std::vector<Material> kept;
    std::map<Words, std::uint32_t> known;
    // Of an unused material 0, which only the sphere_material of a scene without spheres can come to.
    std::vector<std::uint32_t> number(used.size(), 0);
    std::size_t merged = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const auto [first, added] =
            known.try_emplace(behaviour(scene.materials[i].look), static_cast<std::uint32_t>(kept.size()));
        if (added)
            kept.push_back(scene.materials[i]);
        else
            ++merged;
        number[i] = first->second;
    }
    if (kept.empty()) kept.push_back(scene.materials.front());
    scene.savings.merged_materials += merged;
    scene.savings.unused_materials += used.size() - kept.size() - merged;
    for (std::uint32_t& material : scene.mesh.material) material = number[material];
    scene.sphere_material = number[scene.sphere_material];
    scene.materials = std::move(kept);
}

void trim_texcoords(Scene& scene) {
    if (needs_of(scene).textured) return;
    scene.savings.unused_texcoords += scene.mesh.texcoords.size();
    scene.mesh.texcoords = {};
    scene.texels = {};
}

void trim_vertices(Scene& scene) {
    Mesh& mesh = scene.mesh;
    std::vector<bool> used(mesh.positions.size());
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) used[vertex] = true;
    std::vector<std::uint32_t> number(used.size());
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
        number[i] = kept;
        if (used[i]) mesh.positions[kept++] = mesh.positions[i];  // downwards or in place
    }
    if (kept == used.size()) return;
    scene.savings.unused_vertices += used.size() - kept;
    mesh.positions.resize(kept);
    mesh.positions.shrink_to_fit();
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& vertex : triangle) vertex = number[vertex];
}

}  // namespace

void trim(Scene& scene) {
    trim_materials(scene);
    trim_texcoords(scene);
    trim_vertices(scene);
}

}  // namespace ctpbench
