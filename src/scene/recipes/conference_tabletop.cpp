#include <array>

#include "scene/recipes/conference_parts.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

void cup_and_saucer(Mesh& mesh, const Frame& frame, const ConferencePalette& p) {
    constexpr ProfilePoint saucer[] = {{0, 0.002f},      {0.04f, 0.002f}, {0.075f, 0.014f},
                                       {0.075f, 0.017f}, {0.04f, 0.006f}, {0, 0.006f}};
    lathe(mesh, frame, saucer, 24, p.white);
    constexpr ProfilePoint cup[] = {{0, 0.009f},      {0.022f, 0.009f}, {0.032f, 0.03f}, {0.038f, 0.075f},
                                    {0.035f, 0.075f}, {0.03f, 0.034f},  {0, 0.014f}};
    lathe(mesh, frame, cup, 24, p.white);
    std::array<Vec3, 9> handle;
    for (std::size_t i = 0; i < handle.size(); ++i) {
        const auto [c, s] = circle(0.25 - 0.5 * static_cast<double>(i) / 8);
        handle[i] = frame.point({0.034f + 0.022f * c, 0.044f + 0.02f * s, 0});
    }
    tube(mesh, handle, 0.004f, 0.004f, 6, p.white);
}

void laptop_computer(Mesh& mesh, const Frame& frame, const ConferencePalette& p) {
    box(mesh, frame, {-0.17f, 0.003f, -0.12f}, {0.17f, 0.018f, 0.12f}, p.metal);
    for (int row = 0; row < 5; ++row) {
        for (int key = 0; key < 13; ++key) {
            const Vec3 low{-0.15f + 0.0232f * key, 0.017f, -0.03f + 0.023f * row};
            box(mesh, frame, low, low + Vec3{0.019f, 0.005f, 0.019f}, p.black);
        }
    }
    const Frame lid = frame * tipped({0, 0.016f, 0.125f}, 0.04f);
    box(mesh, lid, {-0.17f, 0, 0}, {0.17f, 0.23f, 0.008f}, p.metal);
    box(mesh, lid, {-0.16f, 0.012f, -0.002f}, {0.16f, 0.22f, 0.002f}, p.blue);
}

void drinking_glass(Mesh& mesh, const Frame& frame, const ConferencePalette& p) {
    constexpr ProfilePoint glass[] = {{0, 0.002f},     {0.028f, 0.002f}, {0.034f, 0.11f},
                                      {0.031f, 0.11f}, {0.026f, 0.012f}, {0, 0.012f}};
    lathe(mesh, frame, glass, 20, p.glass);
}

}  // namespace

void place_setting(Mesh& mesh, const ConferencePalette& p, bool laptop, Random& random) {
    const float aside = random.between(-0.05f, 0.05f), turn = random.between(-0.03f, 0.03f);
    const Frame pad = at({aside, 0.002f, -0.02f}, turn);
    if (laptop) {
        laptop_computer(mesh, pad, p);
    } else {
        for (int sheet = 0; sheet < 4; ++sheet) {
            const Frame page = pad * at({0, 0.0022f * sheet, 0}, random.between(-0.012f, 0.012f));
            box(mesh, page, {-0.105f, 0, -0.148f}, {0.105f, 0.0015f, 0.148f}, p.paper);
        }
        const Vec3 pen[] = {pad.point({0.05f, 0.014f, -0.08f}), pad.point({0.055f, 0.014f, 0.05f}),
                            pad.point({0.056f, 0.0135f, 0.065f})};
        tube(mesh, pen, 0.0045f, 0.002f, 8, random.below(2) ? p.blue : p.red);
    }
    cup_and_saucer(mesh, at({0.27f, 0.001f, 0.06f}, random.unit()), p);
    if (random.below(3) != 0) drinking_glass(mesh, at({-0.26f, 0.001f, 0.08f}), p);
    constexpr OutlinePoint card[] = {{-0.04f, 0.002f}, {0.04f, 0.002f}, {0, 0.075f}};
    Frame stand = at({0.1f, 0.001f, 0.3f}, 0.25f);
    prism(mesh, stand, card, 0.2f, p.white);
}

void telephone(Mesh& mesh, const ConferencePalette& p) {
    constexpr OutlinePoint wedge[] = {{-0.1f, 0.003f}, {0.1f, 0.003f}, {0.1f, 0.03f}, {-0.1f, 0.07f}};
    prism(mesh, at({-0.1f, 0, 0}, 0.25f), wedge, 0.2f, p.black);
    cushion(mesh, at({-0.05f, 0.085f, 0}), {0.03f, 0.022f, 0.11f}, 4, p.black);
    for (int row = 0; row < 4; ++row) {
        for (int key = 0; key < 3; ++key) {
            const Vec3 low{0.015f + 0.026f * key, 0.045f, -0.055f + 0.028f * row};
            box(mesh, low, low + Vec3{0.019f, 0.016f, 0.02f}, p.white);
        }
    }
    std::vector<Vec3> coil;
    for (int i = 0; i <= 120; ++i) {
        const auto [c, s] = circle(static_cast<double>(i) / 8);
        coil.push_back({-0.08f + 0.008f * c, 0.014f + 0.008f * s, 0.12f + 0.0014f * i});
    }
    tube(mesh, coil, 0.002f, 0.002f, 5, p.black);
}

void table_middle(Mesh& mesh, const ConferencePalette& p, float table_height, Random& random) {
    constexpr ProfilePoint carafe[] = {{0, 0.002f},     {0.06f, 0.002f}, {0.075f, 0.05f}, {0.07f, 0.14f},
                                       {0.03f, 0.21f},  {0.03f, 0.24f},  {0.04f, 0.27f},  {0.036f, 0.27f},
                                       {0.025f, 0.24f}, {0.025f, 0.21f}, {0, 0.16f}};
    constexpr ProfilePoint tray[] = {{0, 0.001f},      {0.2f, 0.001f},   {0.21f, 0.025f},
                                     {0.205f, 0.025f}, {0.195f, 0.006f}, {0, 0.006f}};
    for (int i = 0; i < 4; ++i) {
        const float aside = random.between(-0.1f, 0.1f), turn = random.unit();
        const Frame frame = at({-3.1f + 2.05f * i, table_height, aside}, turn);
        lathe(mesh, frame, tray, 40, p.metal);
        lathe(mesh, frame * at({0, 0.007f, 0}), carafe, 32, p.glass);
        for (int k = 0; k < 4; ++k) {
            const auto [c, s] = circle(0.25 * k + 0.1);
            drinking_glass(mesh, frame * at({0.14f * c, 0.006f, 0.14f * s}), p);
        }
    }
    for (const float x : {-2.1f, 0.0f, 2.1f}) {  // cables to a socket in the table and down its pedestal
        box(mesh, {x - 0.12f, table_height - 0.002f, -0.05f}, {x + 0.12f, table_height + 0.02f, 0.05f},
            p.black);
        for (int k = 0; k < 3; ++k) {
            std::vector<Vec3> cable;
            const float reach = random.between(0.5f, 0.75f), sway = random.between(0.03f, 0.1f);
            const float side = k % 2 ? 1.0f : -1.0f;
            for (int i = 0; i <= 28; ++i) {
                const float t = static_cast<float>(i) / 28;
                const auto [c, s] = circle(1.5 * t + 0.25 * k);
                cable.push_back({x + 0.05f * (k - 1) + sway * (s + c * t), table_height + 0.005f,
                                 side * (0.055f + reach * t * 0.8f)});
            }
            tube(mesh, cable, 0.004f, 0.004f, 6, p.black);
        }
    }
}

}  // namespace ctpbench::recipe
