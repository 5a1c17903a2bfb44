// The hacienda's courtyard: buildings and laid tables of middling triangles under trees and ivy whose leaves
// are nine tenths of the scene.
#include "scene/recipes/builders.h"
#include "scene/recipes/courtyard_parts.h"
#include "scene/recipes/shapes.h"

namespace ctpbench::recipe {

CourtyardPalette::CourtyardPalette(std::vector<Material>& materials)
    : ochre(add_matte(materials, "ochre_plaster", {0.74f, 0.50f, 0.24f})),
      rose(add_matte(materials, "rose_plaster", {0.70f, 0.36f, 0.26f})),
      white(add_matte(materials, "lime_wash", {0.80f, 0.76f, 0.66f})),
      stone(add_matte(materials, "stone", {0.60f, 0.55f, 0.48f})),
      trim(add_matte(materials, "trim", {0.70f, 0.65f, 0.56f})),
      tile_red(add_plastic(materials, "tile_red", {0.52f, 0.28f, 0.19f}, 0.06f, 60)),
      tile_sand(add_plastic(materials, "tile_sand", {0.58f, 0.42f, 0.28f}, 0.06f, 60)),
      grout(add_matte(materials, "grout", {0.38f, 0.33f, 0.28f})),
      roof(add_matte(materials, "roof_tile", {0.58f, 0.27f, 0.15f})),
      wood(add_plastic(materials, "wood", {0.33f, 0.20f, 0.11f}, 0.05f, 50)),
      iron(add_plastic(materials, "iron", {0.09f, 0.09f, 0.10f}, 0.06f, 40)),
      cloth(add_matte(materials, "table_cloth", {0.86f, 0.84f, 0.78f})),
      napkin(add_matte(materials, "napkin", {0.62f, 0.14f, 0.12f})),
      china(add_plastic(materials, "china", {0.88f, 0.88f, 0.86f}, 0.12f, 180)),
      glass(add_mirror(materials, "glass", {0.88f, 0.90f, 0.90f})),
      silver(add_mirror(materials, "silver", {0.88f, 0.87f, 0.85f})),
      straw(add_matte(materials, "straw", {0.66f, 0.52f, 0.28f})),
      water(add_mirror(materials, "water", {0.55f, 0.68f, 0.72f})),
      clay(add_plastic(materials, "clay", {0.62f, 0.34f, 0.20f}, 0.04f, 30)),
      bark(add_matte(materials, "bark", {0.28f, 0.20f, 0.13f})),
      flower(add_matte(materials, "flower", {0.78f, 0.16f, 0.30f})),
      leaves{add_matte(materials, "leaf_dark", {0.12f, 0.30f, 0.07f}),
             add_matte(materials, "leaf_mid", {0.18f, 0.40f, 0.10f}),
             add_matte(materials, "leaf_light", {0.30f, 0.50f, 0.13f}),
             add_matte(materials, "leaf_yellow", {0.42f, 0.52f, 0.16f})},
      ivy{add_matte(materials, "ivy_dark", {0.08f, 0.24f, 0.07f}),
          add_matte(materials, "ivy_mid", {0.13f, 0.33f, 0.10f}),
          add_matte(materials, "ivy_young", {0.26f, 0.44f, 0.14f})} {}

namespace {

using Size = CourtyardSize;

// Towards the court from the left, right and near walls.
constexpr std::size_t wall_count = 3;
Frame wall_frame(std::size_t i) {
    constexpr float x = Size::half_x, z = Size::half_z;
    if (i == 0) return at({-x, -0.01f, z}, 0.25f);
    if (i == 1) return at({x, -0.01f, -z}, 0.75f);
    return at({x, -0.01f, z}, 0.5f);
}
float wall_width(std::size_t i) { return 2 * (i == 2 ? Size::half_x : Size::half_z); }

void furniture(Mesh& mesh, const CourtyardPalette& p, Random& random) {
    constexpr Vec3 spots[] = {{-8.5f, 0, 2.2f},  {-9.3f, 0, -1.6f}, {-8.9f, 0, -5.4f}, {-4.2f, 0, -2.2f},
                              {-3.3f, 0, -6.6f}, {3.8f, 0, -2.6f},  {3.6f, 0, -6.6f},  {8.9f, 0, -6.0f},
                              {8.6f, 0, -1.8f},  {5.2f, 0, 0.6f},   {9.2f, 0, 2.0f},   {4.0f, 0, 3.4f},
                              {9.0f, 0, 6.6f},   {3.4f, 0, 6.8f},   {0.4f, 0, 4.6f},   {-0.6f, 0, 7.3f},
                              {-5.6f, 0, 3.4f},  {-6.2f, 0, 7.2f}};
    Mesh chair;
    patio_chair(chair, p);
    for (const Vec3& spot : spots) {
        const Frame frame = at(spot, random.unit());
        Mesh table;
        patio_table(table, p, random);
        place(mesh, table, frame);
        for (int i = 0; i < 4; ++i) {
            const Frame seat = frame * at({0, 0.002f, 0}, 0.25f * static_cast<float>(i));
            const float away = random.between(0.78f, 0.95f), aside = random.bell() * 0.1f;
            place(mesh, chair, seat * at({aside, 0, -away}, random.between(-0.06f, 0.06f)));
        }
    }
}

void potted_plants(Mesh& mesh, const CourtyardPalette& p, Random& random) {
    const auto pot = [&](Vec3 spot) {
        const float size = random.between(0.22f, 0.36f);
        const auto stems =
            potted_stems(mesh, at(spot), size, random.between(0.6f, 1.2f), 14, p.clay, p.bark, random);
        scatter_leaves(mesh, stems, 6000, {0.11f, 0.045f, 0.16f, {0, 0, 0}, p.leaves}, random);
        if (random.below(2) == 0) {
            const MaterialId petals[] = {p.flower};
            scatter_leaves(mesh, stems, 800, {0.05f, 0.05f, 0.22f, {0, 0, 0}, petals}, random);
        }
    };
    for (int i = 0; i < 12; ++i) pot({-11.4f, 0.002f, -8.0f + 1.3f * static_cast<float>(i)});
    for (int i = 0; i < 13; ++i) pot({11.4f, 0.002f, -8.0f + 1.3f * static_cast<float>(i)});
    for (int i = 0; i < 7; ++i) pot({-9.0f + 3.0f * static_cast<float>(i), 0.002f, -8.35f});
    for (int i = 0; i < 8; ++i) {
        const auto [c, s] = circle(i / 8.0 + 0.06);
        pot({2.65f * c, 0.002f, 2.65f * s});
    }
}

struct Foliage {
    std::vector<Twig> twigs;
    LeafStyle style;
    std::size_t weight;  // its part of the leaves
};

std::vector<Foliage> grow(Mesh& mesh, const CourtyardPalette& p, Random& random) {
    std::vector<Foliage> all;
    constexpr Vec3 roots[] = {{-6.2f, -0.02f, -4.0f},
                              {6.2f, -0.02f, -4.2f},
                              {6.5f, -0.02f, 4.4f},
                              {-3.2f, -0.02f, 5.2f},
                              {0.4f, -0.02f, -6.0f}};
    for (std::size_t i = 0; i < std::size(roots); ++i) {
        const TreeShape shape{random.between(5.2f, 6.2f), random.between(0.16f, 0.24f), 5};
        const std::span<const MaterialId> hues(p.leaves + i % 2, 3);
        all.push_back(
            {grow_tree(mesh, roots[i], shape, p.bark, random), {0.085f, 0.04f, 0.3f, {0, 0, 0}, hues}, 13});
    }
    for (std::size_t i = 0; i < wall_count; ++i) {
        const Frame wall = wall_frame(i);
        const int vines = i == 0 ? 64 : 34;
        all.push_back({grow_vines(mesh, wall, wall_width(i), Size::wall - 0.2f, vines, p.bark, random),
                       {0.085f, 0.085f, 0.38f, wall.z, p.ivy},
                       8});
    }
    // Climbing the arcade's columns and trailing from the gallery's rail.
    std::vector<Twig> climbing, trailing;
    for (int i = 0; i <= Size::bays; ++i) {
        const float x = -Size::half_x + Size::bay * static_cast<float>(i);
        if (i % 2 == 0) {
            const auto twigs = grow_vines(mesh, at({x - 0.3f, 0, -Size::half_z + 0.35f}), 0.6f,
                                          Size::storey + 0.8f, 6, p.bark, random);
            climbing.insert(climbing.end(), twigs.begin(), twigs.end());
        }
        for (int k = 0; k < 14; ++k) {
            const float tx = x + random.between(-1.0f, 1.0f), drop = random.between(0.2f, 1.0f);
            if (tx < -Size::half_x + 0.1f || tx > Size::half_x - 0.1f) continue;
            trailing.push_back(
                {{tx, Size::storey + 0.3f, -Size::half_z + 0.4f},
                 {tx + random.between(-0.2f, 0.2f), Size::storey - drop, -Size::half_z + 0.5f}});
        }
    }
    all.push_back({std::move(climbing), {0.08f, 0.08f, 0.25f, {0, 0, 1}, p.ivy}, 4});
    all.push_back({std::move(trailing), {0.07f, 0.05f, 0.2f, {0, 0, 1}, p.ivy}, 3});
    return all;
}

}  // namespace

void build_san_miguel_like(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed) {
    reserve(mesh, san_miguel_like_triangles, san_miguel_like_triangles * 3 / 2);
    const CourtyardPalette p(materials);
    Random random(seed, 0);
    courtyard_floor(mesh, p, random);
    courtyard_arcade(mesh, p);
    courtyard_gallery(mesh, p);
    for (std::size_t i = 0; i < wall_count; ++i) {
        courtyard_wall(mesh, wall_frame(i), wall_width(i), i == 2 ? p.rose : p.ochre, p);
    }
    fountain(mesh, p);
    furniture(mesh, p, random);
    potted_plants(mesh, p, random);

    const std::vector<Foliage> foliage = grow(mesh, p, random);
    std::size_t weights = 0, before = 0;
    for (const Foliage& f : foliage) weights += f.weight;
    const std::size_t left = remaining(mesh, san_miguel_like_triangles, san_miguel_like_triangles / 2);
    for (const Foliage& f : foliage) {
        const std::size_t begin = left * before / weights, end = left * (before + f.weight) / weights;
        scatter_leaves(mesh, f.twigs, end - begin, f.style, random);
        before += f.weight;
    }
}

}  // namespace ctpbench::recipe
