#include <array>

#include "scene/recipes/courtyard_parts.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

void turned_post(Mesh& mesh, const Frame& frame, float height, MaterialId wood) {
    const float h = height;
    const ProfilePoint profile[] = {{0.014f, 0.003f},    {0.02f, 0.06f * h},
                                    {0.014f, 0.12f * h}, {0.022f, 0.3f * h},
                                    {0.018f, 0.55f * h}, {0.024f, 0.6f * h},
                                    {0.018f, 0.64f * h}, {0.02f, 0.92f * h},
                                    {0.012f, 0.97f * h}, {0, h}};
    lathe(mesh, frame, profile, 12, wood);
}

void plate(Mesh& mesh, const Frame& frame, float radius, MaterialId china) {
    const float r = radius;
    const ProfilePoint profile[] = {{0, 0.003f}, {0.6f * r, 0.003f}, {0.7f * r, 0.01f},  {r, 0.02f},
                                    {r, 0.024f}, {0.7f * r, 0.015f}, {0.6f * r, 0.008f}, {0, 0.008f}};
    lathe(mesh, frame, profile, 32, china);
}

void wine_glass(Mesh& mesh, const Frame& frame, MaterialId glass) {
    constexpr ProfilePoint profile[] = {{0, 0.002f},     {0.034f, 0.003f}, {0.005f, 0.01f}, {0.004f, 0.08f},
                                        {0.03f, 0.1f},   {0.038f, 0.13f},  {0.032f, 0.18f}, {0.030f, 0.18f},
                                        {0.035f, 0.13f}, {0, 0.092f}};
    lathe(mesh, frame, profile, 20, glass);
}

void cutlery(Mesh& mesh, const Frame& frame, MaterialId silver) {
    for (const float x : {-0.17f, 0.16f, 0.19f}) {
        std::array<Vec3, 6> handle;
        for (std::size_t i = 0; i < handle.size(); ++i) {
            const float t = static_cast<float>(i) / 5;
            handle[i] = frame.point({x, 0.006f + 0.006f * t * (1 - t), -0.09f + 0.13f * t});
        }
        tube(mesh, handle, 0.005f, 0.003f, 6, silver);
        cushion(mesh, frame * at({x, 0.008f, 0.06f}), {0.011f, 0.004f, 0.026f}, 4, silver);
    }
}

}  // namespace

void patio_chair(Mesh& mesh, const CourtyardPalette& p) {
    for (const float x : {-0.2f, 0.2f}) {
        turned_post(mesh, at({x, 0, 0.2f}), 0.47f, p.wood);
        turned_post(mesh, at({x, 0, -0.2f}), 1.02f, p.wood);
        for (const float y : {0.14f, 0.28f}) {
            const Vec3 rung[] = {{x, y, -0.2f}, {x, y, 0.2f}};
            tube(mesh, rung, 0.011f, 0.011f, 8, p.wood);
        }
    }
    for (const float y : {0.18f, 0.32f}) {
        for (const float z : {-0.2f, 0.2f}) {
            const Vec3 rung[] = {{-0.2f, y, z}, {0.2f, y, z}};
            tube(mesh, rung, 0.011f, 0.011f, 8, p.wood);
        }
    }
    for (const float y : {0.6f, 0.75f, 0.9f}) {  // ladder back
        surface(mesh, 10, 2, p.wood, [&](float u, float v) {
            return Vec3{-0.2f + 0.4f * u, y + 0.075f * v, -0.2f - 0.1f * u * (1 - u)};
        });
    }
    // A seat woven of rush: strands over and under.
    constexpr int strands = 16;
    for (int i = 0; i < strands; ++i) {
        const float a = -0.2f + 0.4f * (static_cast<float>(i) + 0.08f) / strands,
                    b = a + 0.4f * 0.84f / strands;
        for (const bool lengthwise : {false, true}) {
            surface(mesh, 1, strands, p.straw, [&](float u, float v) {
                const int k = static_cast<int>(v * strands + 0.5f);
                const float y = 0.45f + ((i + k) % 2 == (lengthwise ? 1 : 0) ? 0.004f : -0.004f);
                const float across = a + (b - a) * u, along = 0.2f - 0.4f * v;
                return lengthwise ? Vec3{-along, y, -across} : Vec3{across, y, along};
            });
        }
    }
}

void patio_table(Mesh& mesh, const CourtyardPalette& p, Random& random) {
    constexpr float r = 0.55f, h = 0.75f;
    constexpr ProfilePoint foot[] = {{0.3f, 0.003f}, {0.3f, 0.03f},  {0.08f, 0.07f}, {0.05f, 0.2f},
                                     {0.09f, 0.38f}, {0.05f, 0.55f}, {0.1f, 0.68f},  {0.1f, 0.72f}};
    lathe(mesh, {}, foot, 24, p.wood);
    constexpr ProfilePoint top[] = {
        {0, h - 0.035f}, {r - 0.01f, h - 0.035f}, {r - 0.01f, h - 0.008f}, {0, h - 0.008f}};
    lathe(mesh, {}, top, 48, p.wood);
    constexpr ProfilePoint cloth[] = {{r + 0.004f, h - 0.005f}, {0.3f, h}, {0, h}};
    lathe(mesh, {}, cloth, 96, p.cloth);
    const float phase = random.unit();
    surface(mesh, 96, 14, p.cloth, [&](float u, float v) {
        const float drop = 1 - v;
        const auto [c, s] = circle(u);
        const float fold = circle(9.0 * u + phase).sin + 0.4f * circle(14.0 * u).cos;
        const float radius = r + 0.004f + 0.03f * drop + 0.035f * drop * fold;
        return Vec3{radius * c, h - 0.005f - 0.32f * drop - 0.03f * drop * circle(4.0 * u + 0.5).sin,
                    -radius * s};
    });
    for (int i = 0; i < 4; ++i) {
        const Frame seat =
            at({0, h + 0.001f, 0}, 0.25f * static_cast<float>(i) + random.between(-0.02f, 0.02f));
        plate(mesh, seat * at({0, 0, -0.36f}), 0.13f, p.china);
        plate(mesh, seat * at({0, 0.01f, -0.36f}), 0.085f, p.china);
        plate(mesh, seat * at({-0.24f, 0, -0.3f}), 0.06f, p.china);
        wine_glass(mesh, seat * at({0.13f, 0, -0.2f}), p.glass);
        cutlery(mesh, seat * at({0, 0.002f, -0.37f}), p.silver);
        cushion(mesh, seat * at({0, 0.05f, -0.36f}, random.unit()), {0.04f, 0.03f, 0.05f}, 4, p.napkin);
    }
    constexpr ProfilePoint vase[] = {{0, 0.002f},     {0.045f, 0.002f}, {0.06f, 0.06f}, {0.03f, 0.13f},
                                     {0.045f, 0.17f}, {0.04f, 0.17f},   {0, 0.1f}};
    lathe(mesh, at({0, h + 0.001f, 0}), vase, 24, p.clay);
    std::vector<Twig> stems;
    for (int i = 0; i < 7; ++i) {
        const Vec3 lean{random.between(-0.1f, 0.1f), 0.33f, random.between(-0.1f, 0.1f)};
        stems.push_back({{0, h + 0.15f, 0}, Vec3{0, h, 0} + lean});
        const Vec3 path[] = {{lean.x * 0.1f, h + 0.11f, lean.z * 0.1f}, stems.back().to};
        tube(mesh, path, 0.003f, 0.002f, 4, p.leaves[0]);
        cushion(mesh, at(stems.back().to), {0.022f, 0.018f, 0.022f}, 4, p.flower);
    }
    scatter_leaves(mesh, stems, 240, {0.05f, 0.025f, 0.03f, {0, 0, 0}, {p.leaves, 2}}, random);
}

void fountain(Mesh& mesh, const CourtyardPalette& p) {
    constexpr ProfilePoint basin[] = {{2.2f, 0.002f}, {2.2f, 0.1f},   {2.05f, 0.14f},
                                      {2.0f, 0.5f},   {2.12f, 0.56f}, {2.12f, 0.66f},
                                      {1.8f, 0.66f},  {1.78f, 0.3f},  {0, 0.2f}};
    lathe(mesh, {}, basin, 96, p.stone);
    constexpr ProfilePoint stem[] = {
        {0.45f, 0.2f},  {0.45f, 0.5f},  {0.25f, 0.6f},  {0.2f, 1.0f},   {0.3f, 1.12f}, {0.22f, 1.2f},
        {0.95f, 1.42f}, {1.05f, 1.52f}, {1.0f, 1.55f},  {0.85f, 1.46f}, {0.2f, 1.36f}, {0.15f, 1.6f},
        {0.13f, 1.9f},  {0.5f, 2.06f},  {0.54f, 2.12f}, {0.48f, 2.12f}, {0.1f, 2.02f}, {0.09f, 2.3f},
        {0.16f, 2.4f},  {0.1f, 2.52f},  {0, 2.6f}};
    lathe(mesh, {}, stem, 64, p.stone);
    const auto water = [&](float inner, float outer, float level) {
        surface(mesh, 128, 28, p.water, [&](float u, float v) {
            const auto [c, s] = circle(u);
            const float r = outer + (inner - outer) * v;
            const float ripple = circle(5.0 * r).sin * 0.012f + circle(8.0 * u + 3.0 * r).sin * 0.004f;
            return Vec3{r * c, level + ripple, -r * s};
        });
    };
    water(0.4f, 1.79f, 0.5f);
    water(0.17f, 0.93f, 1.5f);
    for (int i = 0; i < 12; ++i) {  // jets from the upper bowls into the lower
        const auto [c, s] = circle(i / 12.0);
        const bool high = i % 2 == 0;
        std::vector<Vec3> jet;
        for (int k = 0; k <= 16; ++k) {
            const float t = static_cast<float>(k) / 16;
            const float r = high ? 0.5f + 0.3f * t : 1.0f + 0.45f * t;
            const float y = high ? 2.12f - 0.62f * t * t : 1.53f - 1.0f * t * t;
            jet.push_back({r * c, y, r * s});
        }
        tube(mesh, jet, 0.012f, 0.02f, 8, p.water);
    }
}

}  // namespace ctpbench::recipe
