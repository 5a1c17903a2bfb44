#include "scene/recipes/conference_parts.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

constexpr float hx = conference_half_length, hz = conference_half_width, top = conference_height;

void light_fixture(Mesh& mesh, Vec3 corner, float size, const ConferencePalette& p) {
    const Vec3 high = corner + Vec3{size, 0.12f, size};
    const Frame wall_frames[] = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, corner},
        {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {high.x, corner.y, corner.z}},
        {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {high.x, corner.y, high.z}},
        {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {corner.x, corner.y, high.z}},
    };
    for (const Frame& f : wall_frames) {
        add_quad(mesh, f.point({0, 0, 0}), f.point({size, 0, 0}), f.point({size, 0.12f, 0}),
                 f.point({0, 0.12f, 0}), p.white);
    }
    add_quad(mesh, {corner.x, high.y, corner.z}, {high.x, high.y, corner.z}, high, {corner.x, high.y, high.z},
             p.lamp);
    for (const float z : {0.27f, 0.73f}) {
        const Vec3 lamp[] = {corner + Vec3{0.03f, 0.085f, z * size},
                             corner + Vec3{size - 0.03f, 0.085f, z * size}};
        tube(mesh, lamp, 0.016f, 0.016f, 12, p.lamp);
    }
    for (int i = 1; i < 12; ++i) {
        const float x = corner.x + size * static_cast<float>(i) / 12;
        box(mesh, {x - 0.003f, corner.y + 0.01f, corner.z + 0.01f},
            {x + 0.003f, corner.y + 0.055f, high.z - 0.01f}, p.metal);
    }
}

// Facing +z, its lower left corner at the frame's origin.
void panelled_field(Mesh& mesh, const Frame& frame, float width, float height, const ConferencePalette& p) {
    box(mesh, frame, {0.02f, 0, -0.01f}, {width - 0.02f, height, 0.02f}, p.wood);
    for (const float x : {0.1f, width - 0.14f}) {
        box(mesh, frame, {x, 0.08f, 0.015f}, {x + 0.04f, height - 0.08f, 0.035f}, p.dark_wood);
    }
    for (const float y : {0.08f, height - 0.12f}) {
        box(mesh, frame, {0.138f, y, 0.014f}, {width - 0.138f, y + 0.04f, 0.033f}, p.dark_wood);
    }
}

void door(Mesh& mesh, const Frame& frame, const ConferencePalette& p) {
    box(mesh, frame, {-0.5f, 0.004f, -0.02f}, {0.5f, 2.15f, 0.025f}, p.dark_wood);
    for (const float x : {-0.58f, 0.49f}) {
        box(mesh, frame, {x, 0.003f, -0.015f}, {x + 0.09f, 2.24f, 0.06f}, p.metal);
    }
    box(mesh, frame, {-0.495f, 2.14f, -0.014f}, {0.495f, 2.235f, 0.058f}, p.metal);
    for (const float y : {0.2f, 1.1f}) {
        box(mesh, frame, {-0.36f, y, 0.02f}, {0.36f, y + 0.75f, 0.036f}, p.wood);
    }
    const Vec3 handle[] = {frame.point({-0.42f, 1.02f, 0.02f}), frame.point({-0.42f, 1.02f, 0.075f}),
                           frame.point({-0.40f, 1.02f, 0.085f}), frame.point({-0.28f, 1.02f, 0.085f})};
    tube(mesh, handle, 0.011f, 0.009f, 12, p.metal);
}

}  // namespace

void conference_ceiling(Mesh& mesh, const ConferencePalette& p) {
    constexpr float cell = 0.8f;
    constexpr int columns = 20, rows = 12;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const Vec3 a{-hx + cell * i, top, -hz + cell * j};
            if (i % 4 == 1 && j % 3 == 1) {
                light_fixture(mesh, a, cell, p);
                continue;
            }
            add_quad(mesh, a, a + Vec3{cell, 0, 0}, a + Vec3{cell, 0, cell}, a + Vec3{0, 0, cell}, p.ceiling);
            if (i % 4 == 3 && j % 3 == 1) {  // a sprinkler
                constexpr ProfilePoint head[] = {{0, -0.06f},      {0.03f, -0.055f}, {0.012f, -0.045f},
                                                 {0.012f, -0.01f}, {0.04f, -0.008f}, {0.045f, 0.004f}};
                lathe(mesh, at(a + Vec3{0.4f, 0, 0.4f}), head, 16, p.metal);
            }
        }
    }
    for (int i = 1; i < columns; ++i) {
        const float x = -hx + cell * i;
        box(mesh, {x - 0.012f, top - 0.012f, -hz}, {x + 0.012f, top + 0.002f, hz}, p.white);
    }
    for (int j = 1; j < rows; ++j) {
        const float z = -hz + cell * j;
        box(mesh, {-hx, top - 0.01f, z - 0.012f}, {hx, top + 0.001f, z + 0.012f}, p.white);
    }
}

void conference_walls(Mesh& mesh, const ConferencePalette& p) {
    add_quad(mesh, {-hx, 0, hz}, {hx, 0, hz}, {hx, 0, -hz}, {-hx, 0, -hz}, p.carpet);
    add_quad(mesh, {hx, 0, -hz}, {hx, 0, hz}, {hx, top, hz}, {hx, top, -hz}, p.wall);
    add_quad(mesh, {-hx, 0, hz}, {-hx, 0, -hz}, {-hx, top, -hz}, {-hx, top, hz}, p.wall);
    add_quad(mesh, {hx, 0, hz}, {-hx, 0, hz}, {-hx, top, hz}, {hx, top, hz}, p.wall);
    pierced_wall(mesh, at({-hx, 0, -hz}), 2 * hx, top, conference_window_openings(), 0.25f, p.wall);

    const Frame inner{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {hx, 0, hz}};  // the wall opposite the windows
    for (int i = 0; i < 11; ++i) {
        if (i == 1) continue;
        panelled_field(mesh, inner * at({16.0f / 11 * i, 0.12f, 0}), 16.0f / 11, 2.7f, p);
    }
    door(mesh, inner * at({16.0f / 11 * 1.5f, 0, 0}), p);
    const Frame ends[] = {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {hx, 0, -hz}},
                          {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {-hx, 0, hz}}};
    for (const Frame& end : ends) {
        for (int i = 0; i < 6; ++i) {
            if (&end == &ends[0] && (i == 2 || i == 3)) continue;
            panelled_field(mesh, end * at({0.02f + 1.593f * i, 0.12f, 0}), 1.593f, 2.7f, p);
        }
        box(mesh, end, {0.041f, 0.001f, -0.008f}, {2 * hz - 0.041f, 0.1f, 0.015f}, p.black);
    }
    box(mesh, inner, {0.016f, 0.0015f, -0.009f}, {2 * hx - 0.016f, 0.1f, 0.016f}, p.black);
    constexpr ProfilePoint clock[] = {
        {0.17f, -0.01f}, {0.17f, 0.035f}, {0.15f, 0.04f}, {0.15f, 0.03f}, {0, 0.03f}};
    lathe(mesh, ends[0] * standing({hz, 2.95f, 0.0f}, {0, 0, 1}), clock, 40, p.white);
}

void whiteboard(Mesh& mesh, const Frame& frame, const ConferencePalette& p, Random& random) {
    constexpr float w = 1.5f, low = 0.85f, high = 2.3f;
    box(mesh, frame, {-w, low, -0.02f}, {w, high, 0.02f}, p.white);
    for (const float x : {-w, w})
        box(mesh, frame, {x - 0.025f, low - 0.02f, -0.015f}, {x + 0.025f, high + 0.02f, 0.035f}, p.metal);
    for (const float y : {low, high}) {
        box(mesh, frame, {-w + 0.02f, y - 0.024f, -0.014f}, {w - 0.02f, y + 0.024f, 0.034f}, p.metal);
    }
    box(mesh, frame, {-0.6f, low - 0.03f, 0.03f}, {0.6f, low - 0.015f, 0.11f}, p.metal);
    const MaterialId inks[] = {p.blue, p.red, p.green, p.black};
    for (int i = 0; i < 4; ++i) {
        const float x = -0.5f + 0.2f * i;
        const Vec3 pen[] = {frame.point({x, low - 0.005f, 0.07f}),
                            frame.point({x + 0.12f, low - 0.005f, 0.075f})};
        tube(mesh, pen, 0.009f, 0.008f, 10, inks[i]);
    }
    for (int stroke = 0; stroke < 14; ++stroke) {  // handwriting: wavy lines just in front of the board
        std::vector<Vec3> line;
        const float y = high - 0.15f - 0.085f * stroke, length = random.between(0.8f, 2.6f);
        for (int i = 0; i <= 40; ++i) {
            const float t = static_cast<float>(i) / 40;
            const float wave = circle(random.between(0.0f, 0.3f) + 9.0 * t).sin;
            line.push_back(frame.point({-1.35f + length * t, y + 0.018f * wave, 0.021f}));
        }
        tube(mesh, line, 0.004f, 0.004f, 4, inks[random.below(4)]);
    }
}

}  // namespace ctpbench::recipe
