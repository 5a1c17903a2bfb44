// The conference room: one long table with its chairs, walls and ceiling of few huge triangles, furniture
// of very many small ones.
#include "scene/recipes/builders.h"
#include "scene/recipes/cloth.h"
#include "scene/recipes/conference_parts.h"
#include "scene/recipes/foliage.h"
#include "scene/recipes/shapes.h"

namespace ctpbench::recipe {

ConferencePalette::ConferencePalette(std::vector<Material>& materials)
    : wall(add_matte(materials, "wall", {0.80f, 0.77f, 0.70f})),
      carpet(add_matte(materials, "carpet", {0.22f, 0.25f, 0.32f})),
      ceiling(add_emissive(materials, "ceiling_panel", {0.62f, 0.60f, 0.56f})),
      wood(add_plastic(materials, "wood", {0.52f, 0.30f, 0.15f}, 0.06f, 80)),
      dark_wood(add_plastic(materials, "dark_wood", {0.27f, 0.14f, 0.07f}, 0.08f, 120)),
      upholstery(add_matte(materials, "upholstery", {0.48f, 0.09f, 0.10f})),
      metal(add_mirror(materials, "metal", {0.78f, 0.79f, 0.80f})),
      black(add_plastic(materials, "black_plastic", {0.05f, 0.05f, 0.05f}, 0.06f, 60)),
      white(add_plastic(materials, "white_paint", {0.86f, 0.86f, 0.84f}, 0.05f, 40)),
      paper(add_matte(materials, "paper", {0.90f, 0.89f, 0.83f})),
      glass(add_mirror(materials, "glass", {0.86f, 0.90f, 0.91f})),
      daylight(add_emissive(materials, "daylight", {1.0f, 1.0f, 1.0f})),
      fabric(add_matte(materials, "curtain", {0.66f, 0.58f, 0.40f})),
      lamp(add_emissive(materials, "lamp", {3.0f, 2.9f, 2.6f})),
      blue(add_plastic(materials, "blue", {0.10f, 0.20f, 0.55f}, 0.06f, 100)),
      red(add_plastic(materials, "red", {0.65f, 0.10f, 0.08f}, 0.06f, 100)),
      green(add_matte(materials, "green", {0.10f, 0.45f, 0.18f})),
      leaf(add_matte(materials, "leaf", {0.16f, 0.38f, 0.10f})),
      clay(add_plastic(materials, "clay", {0.60f, 0.32f, 0.20f}, 0.04f, 30)) {}

namespace {

constexpr float hx = conference_half_length, hz = conference_half_width;
constexpr float table_length = 9.6f, table_width = 2.7f, table_height = 0.74f;

void seats_at_table(Mesh& mesh, const Mesh& chair, const ConferencePalette& p, Random& random) {
    Mesh phone;
    telephone(phone, p);
    for (int side = 0; side < 2; ++side) {
        for (int i = 0; i < 11; ++i) {
            const float x = -4.1f + 0.82f * i;
            const float t = 2 * x / table_length;
            const float edge = table_width / 2 * (1 - 0.3f * t * t);
            const float sign = side == 0 ? -1.0f : 1.0f;
            const float facing = side == 0 ? 0.0f : 0.5f;
            const float away = edge + random.between(0.2f, 0.42f);
            place(mesh, chair, at({x, 0, sign * away}, facing + random.between(-0.06f, 0.06f)));
            Mesh setting;
            place_setting(setting, p, random.below(3) == 0, random);
            place(mesh, setting, at({x, table_height, sign * (edge - 0.3f)}, facing));
            if (i % 5 == 2) {
                place(mesh, phone, at({x + 0.41f, table_height, sign * (edge - 0.75f)}, facing + 0.03f));
            }
        }
    }
    for (const float sign : {-1.0f, 1.0f}) {
        const float x = sign * (table_length / 2 + 0.35f);
        place(mesh, chair, at({x, 0, 0}, sign < 0 ? 0.25f : 0.75f));
    }
}

void seats_along_walls(Mesh& mesh, const Mesh& chair, Random& random) {
    for (int i = 0; i < 16; ++i) {
        if (i == 13 || i == 12) continue;  // the door
        const Vec3 spot{-hx + 0.95f + 0.92f * i, 0, hz - 0.5f - random.between(0.0f, 0.1f)};
        place(mesh, chair, at(spot, 0.5f + random.between(-0.04f, 0.04f)));
    }
    for (int i = 0; i < 5; ++i) {
        const Vec3 spot{-hx + 0.5f, 0, -2.6f + 1.1f * i};
        place(mesh, chair, at(spot, 0.25f + random.between(-0.04f, 0.04f)));
    }
}

void corner_plants(Mesh& mesh, const ConferencePalette& p, Random& random) {
    const MaterialId greens[] = {p.leaf, p.green};
    for (const Vec3 spot : {Vec3{hx - 0.6f, 0, -hz + 0.7f}, Vec3{hx - 0.6f, 0, hz - 0.6f}}) {
        const auto stems = potted_stems(mesh, at(spot), 0.24f, 1.1f, 12, p.clay, p.leaf, random);
        scatter_leaves(mesh, stems, 4800, {0.16f, 0.06f, 0.12f, {0, 0, 0}, greens}, random);
    }
}

}  // namespace

void build_conference_like(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed) {
    reserve(mesh, conference_like_triangles, conference_like_triangles);
    const ConferencePalette p(materials);
    Random random(seed, 0);
    conference_walls(mesh, p);
    conference_ceiling(mesh, p);
    conference_windows(mesh, p, random);
    whiteboard(mesh, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {hx - 0.03f, 0, 0}}, p, random);
    conference_table(mesh, p, table_length, table_width, table_height);
    table_middle(mesh, p, table_height, random);

    Mesh chair;
    swivel_chair(chair, p);
    seats_at_table(mesh, chair, p, random);
    seats_along_walls(mesh, chair, random);
    corner_plants(mesh, p, random);

    for (const Opening& window : conference_window_openings()) {
        const Vec3 rail[] = {{-hx + window.x0 - 0.55f, 3.03f, -hz + 0.2f},
                             {-hx + window.x1 + 0.55f, 3.03f, -hz + 0.2f}};
        tube(mesh, rail, 0.02f, 0.02f, 12, p.metal);
    }
    // A pair of curtains for each window, tied back, from the triangles that are left.
    const std::size_t left = remaining(mesh, conference_like_triangles, 8 * 500);
    for (std::size_t i = 0; i < 8; ++i) {
        const Opening& window = conference_window_openings()[i / 2];
        const float x = -hx + (i % 2 == 0 ? window.x0 - 0.45f : window.x1 - 0.15f);
        const Cloth curtain{0.6f, 2.95f, 0.06f, 6, 0.5f, 0.4f};
        hang_cloth(mesh, at({x, 3.0f, -hz + 0.2f}), curtain, share(left, i, 8), p.fabric, random);
    }
}

}  // namespace ctpbench::recipe
