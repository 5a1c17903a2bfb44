// A small furnished room that has a little of everything: for quick tests and for trying the program out.
#include "scene/recipes/builders.h"
#include "scene/recipes/cloth.h"
#include "scene/recipes/foliage.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/walls.h"

namespace ctpbench::recipe {

namespace {

constexpr float hx = 3.2f, hz = 2.6f, height = 3.0f;

void stool(Mesh& mesh, const Frame& frame, MaterialId wood, MaterialId cover) {
    for (int i = 0; i < 4; ++i) {
        const Frame leg = frame * at({0, 0, 0}, 0.25f * static_cast<float>(i) + 0.125f);
        const Vec3 path[] = {leg.point({0.21f, 0.003f, 0}), leg.point({0.16f, 0.44f, 0})};
        tube(mesh, path, 0.015f, 0.02f, 6, wood);
    }
    cushion(mesh, frame * at({0, 0.46f, 0}), {0.2f, 0.05f, 0.2f}, 4, cover);
}

}  // namespace

void build_smoke(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed) {
    reserve(mesh, smoke_triangles, smoke_triangles);
    const MaterialId plaster = add_matte(materials, "plaster", {0.76f, 0.72f, 0.64f});
    const MaterialId floor = add_plastic(materials, "floor", {0.42f, 0.28f, 0.17f}, 0.06f, 60);
    const MaterialId stone = add_matte(materials, "stone", {0.62f, 0.60f, 0.56f});
    const MaterialId wood = add_plastic(materials, "wood", {0.45f, 0.26f, 0.13f}, 0.06f, 80);
    const MaterialId cover = add_matte(materials, "cover", {0.50f, 0.10f, 0.10f});
    const MaterialId curtain = add_matte(materials, "curtain", {0.15f, 0.25f, 0.50f});
    const MaterialId lamp = add_emissive(materials, "lamp", {3.0f, 2.3f, 1.4f});
    const MaterialId ceiling = add_emissive(materials, "ceiling", {0.62f, 0.60f, 0.56f});
    const MaterialId silver = add_mirror(materials, "silver", {0.88f, 0.87f, 0.85f});
    const MaterialId clay = add_plastic(materials, "clay", {0.60f, 0.33f, 0.20f}, 0.04f, 30);
    const MaterialId green = add_matte(materials, "leaf", {0.16f, 0.40f, 0.10f});
    Random random(seed, 0);

    add_quad(mesh, {-hx, 0, hz}, {hx, 0, hz}, {hx, 0, -hz}, {-hx, 0, -hz}, floor);
    add_quad(mesh, {-hx, height, -hz}, {hx, height, -hz}, {hx, height, hz}, {-hx, height, hz}, ceiling);
    add_quad(mesh, {hx, 0, hz}, {-hx, 0, hz}, {-hx, height, hz}, {hx, height, hz}, plaster);
    add_quad(mesh, {-hx, 0, hz}, {-hx, 0, -hz}, {-hx, height, -hz}, {-hx, height, hz}, plaster);
    add_quad(mesh, {hx, 0, -hz}, {hx, 0, hz}, {hx, height, hz}, {hx, height, -hz}, plaster);
    const Opening window[] = {{2.2f, 4.2f, 0.9f, 2.3f}};
    pierced_wall(mesh, at({-hx, 0, -hz}), 2 * hx, height, window, 0.3f, plaster);
    for (const float x : {-2.4f, -0.8f, 0.8f, 2.4f}) {
        column(mesh, at({x * 1.05f, 0, -1.7f}), {0.14f, height, 12, 6}, stone, stone);
    }

    box(mesh, {-0.7f, 0.7f, -0.45f}, {0.7f, 0.75f, 0.45f}, wood);
    for (const float x : {-0.6f, 0.6f}) {
        for (const float z : {-0.36f, 0.36f})
            box(mesh, {x - 0.04f, 0.002f, z - 0.04f}, {x + 0.04f, 0.71f, z + 0.04f}, wood);
    }
    constexpr ProfilePoint bowl[] = {
        {0, 0.002f}, {0.06f, 0.002f}, {0.15f, 0.09f}, {0.14f, 0.09f}, {0, 0.012f}};
    lathe(mesh, at({0.1f, 0.75f, 0}), bowl, 32, lamp);
    for (int i = 0; i < 4; ++i) {
        const auto [c, s] = circle(0.25 * i + random.between(0.1f, 0.15f));
        stool(mesh, at({1.05f * c, 0, 0.85f * s}, random.unit()), wood, cover);
        torus(mesh, at({0.1f + 0.4f * c, 0.77f, 0.25f * s}), 0.05f, 0.015f, 16, 8, silver);
    }
    const MaterialId greens[] = {green};
    const auto stems = potted_stems(mesh, at({2.5f, 0, -0.3f}), 0.24f, 0.9f, 8, clay, green, random);
    scatter_leaves(mesh, stems, 1200, {0.16f, 0.06f, 0.12f, {0, 0, 0}, greens}, random);

    const std::size_t left = remaining(mesh, smoke_triangles, 2 * 200);
    for (std::size_t i = 0; i < 2; ++i) {
        const float x = i == 0 ? -1.6f : 0.6f;
        hang_cloth(mesh, at({x, 2.7f, -hz + 0.15f}), {1.0f, 2.5f, 0.08f, 6, 0.4f, 0.4f}, share(left, i, 2),
                   curtain, random);
    }
}

}  // namespace ctpbench::recipe
