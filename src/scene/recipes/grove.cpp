// A walled court with trees, awnings and rough ground, at any number of triangles. Its surfaces are the same
// at every size and the leaves cover as much, so that rays meet as much and go as deep: only the triangles
// get smaller. That is for asking what a ray costs as triangles grow.
#include <array>
#include <cmath>

#include "scene/recipes/builders.h"
#include "scene/recipes/cloth.h"
#include "scene/recipes/foliage.h"
#include "scene/recipes/shapes.h"

namespace ctpbench::recipe {

namespace {

constexpr float half = 6.0f, height = 5.0f;

void walls(Mesh& mesh, MaterialId plaster, MaterialId lamp, MaterialId glass) {
    constexpr float h = half, y = height, w = 0.4f * half;
    add_quad(mesh, {-h, -0.05f, -h}, {h, -0.05f, -h}, {h, y, -h}, {-h, y, -h}, plaster);
    add_quad(mesh, {h, -0.05f, h}, {-h, -0.05f, h}, {-h, y, h}, {h, y, h}, plaster);
    add_quad(mesh, {-h, -0.05f, h}, {-h, -0.05f, -h}, {-h, y, -h}, {-h, y, h}, plaster);
    add_quad(mesh, {h, -0.05f, -h}, {h, -0.05f, h}, {h, y, h}, {h, y, -h}, plaster);
    add_quad(mesh, {-w, 3.4f, 0.02f - h}, {w, 3.4f, 0.02f - h}, {w, 3.9f, 0.02f - h}, {-w, 3.9f, 0.02f - h},
             lamp);
    for (const float x : {-0.7f * h, 0.35f * h}) {
        const float z = 0.02f - h, end = x + 0.35f * h;
        add_quad(mesh, {x, 0.6f, z}, {end, 0.6f, z}, {end, 2.6f, z}, {x, 2.6f, z}, glass);
    }
}

void ground(Mesh& mesh, std::size_t triangles, MaterialId soil) {
    exact_surface(mesh, triangles, 1.0f, soil, [](float u, float v) {
        const float x = 2 * u - 1, z = 1 - 2 * v;
        const float swell = circle(1.3 * x + 0.7 * z).sin * circle(0.4 + 1.1 * z).sin;
        const float furrow = circle(5.1 * x).sin * circle(0.3 + 4.7 * z).sin;
        const float edge = (1 - x * x) * (1 - z * z);
        return Vec3{half * x, edge * (0.05f * swell + 0.03f * furrow), half * z};
    });
}

}  // namespace

void build_grove(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed, std::size_t triangles) {
    reserve(mesh, triangles, triangles * 3 / 2);
    const MaterialId plaster = add_matte(materials, "plaster", {0.74f, 0.66f, 0.52f});
    const MaterialId soil = add_matte(materials, "soil", {0.46f, 0.38f, 0.28f});
    const MaterialId bark = add_plastic(materials, "bark", {0.30f, 0.21f, 0.14f}, 0.04f, 20);
    const MaterialId glass = add_mirror(materials, "glass", {0.85f, 0.88f, 0.88f});
    const MaterialId lamp = add_emissive(materials, "lamp", {3.0f, 2.5f, 1.8f});
    const MaterialId awning = add_matte(materials, "awning", {0.62f, 0.22f, 0.14f});
    const MaterialId greens[] = {add_matte(materials, "leaf_dark", {0.14f, 0.34f, 0.09f}),
                                 add_matte(materials, "leaf_light", {0.28f, 0.48f, 0.13f})};
    Random random(seed, 0);
    walls(mesh, plaster, lamp, glass);
    std::vector<Twig> twigs;
    for (const Vec3& root : {Vec3{-2.9f, -0.02f, -1.2f}, Vec3{1.1f, -0.02f, -2.9f}, Vec3{3.1f, -0.02f, 1.4f},
                             Vec3{-1.4f, -0.02f, 3.0f}}) {
        const auto tree = grow_tree(mesh, root, {4.2f, 0.14f, 2}, bark, random);
        twigs.insert(twigs.end(), tree.begin(), tree.end());
    }

    // A quarter each to ground and awnings, the rest to leaves.
    const std::size_t left = remaining(mesh, triangles, triangles / 2);
    ground(mesh, left / 4, soil);
    constexpr std::array<Vec3, 3> hooks{Vec3{-5.2f, 3.6f, -3.9f}, Vec3{-4.9f, 3.4f, 1.2f},
                                        Vec3{2.2f, 3.7f, -0.6f}};
    for (std::size_t i = 0; i < hooks.size(); ++i) {
        hang_cloth(mesh, at(hooks[i]), {2.6f, 2.4f, 0.12f, 5, 0.2f, 0.5f}, share(left / 4, i, hooks.size()),
                   awning, random);
    }
    const std::size_t leaves = triangles - mesh.triangles.size();
    const float length = 13.0f / std::sqrt(static_cast<float>(leaves));
    scatter_leaves(mesh, twigs, leaves, {length, 0.45f * length, 0.45f, {0, 0, 0}, greens}, random);
}

}  // namespace ctpbench::recipe
