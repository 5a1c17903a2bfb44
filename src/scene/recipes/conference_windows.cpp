#include <array>

#include "scene/recipes/conference_parts.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

std::span<const Opening> conference_window_openings() {
    static constexpr std::array<Opening, 4> openings{{{0.8f, 3.6f, 0.9f, 2.8f},
                                                      {4.6f, 7.4f, 0.9f, 2.8f},
                                                      {8.6f, 11.4f, 0.9f, 2.8f},
                                                      {12.4f, 15.2f, 0.9f, 2.8f}}};
    return openings;
}

namespace {

void venetian_blind(Mesh& mesh, const Frame& frame, float width, float height, float tilt,
                    const ConferencePalette& p) {
    constexpr float pitch = 0.042f;
    const auto [c, s] = circle(tilt);
    const int slats = static_cast<int>(height / pitch);
    for (int i = 0; i < slats; ++i) {
        const float y = 0.03f + pitch * static_cast<float>(i);
        surface(mesh, 8, 4, p.white, [&, c = c, s = s](float u, float v) {
            const float across = (v - 0.5f) * 0.05f, bow = 0.16f * (0.25f - (v - 0.5f) * (v - 0.5f));
            const float lift = 0.05f * bow;
            return frame.point(
                {0.02f + (width - 0.04f) * u, y + across * s + lift * c, across * c - lift * s});
        });
    }
    box(mesh, frame, {0.01f, height, -0.03f}, {width - 0.01f, height + 0.05f, 0.03f}, p.metal);
    for (const float t : {0.1f, 0.5f, 0.9f}) {
        const Vec3 cord[] = {frame.point({width * t, 0.01f, 0.034f}),
                             frame.point({width * t, height, 0.034f})};
        tube(mesh, cord, 0.0015f, 0.0015f, 5, p.white);
    }
}

}  // namespace

void conference_windows(Mesh& mesh, const ConferencePalette& p, Random& random) {
    const Frame wall = at({-conference_half_length, 0, -conference_half_width});
    for (const Opening& o : conference_window_openings()) {
        const float width = o.x1 - o.x0, height = o.y1 - o.y0;
        const Frame frame = wall * at({o.x0, o.y0, 0});
        // The pane shines as bright as the day behind it; a pane that reflected would leave the room dark.
        add_quad(mesh, frame.point({0, 0, -0.25f}), frame.point({width, 0, -0.25f}),
                 frame.point({width, height, -0.25f}), frame.point({0, height, -0.25f}), p.daylight);
        for (const float x : {0.0f, width / 2, width}) {
            box(mesh, frame, {x - 0.03f, -0.02f, -0.24f}, {x + 0.03f, height + 0.02f, -0.19f}, p.metal);
        }
        for (const float y : {0.0f, height * 0.7f, height}) {
            box(mesh, frame, {-0.02f, y - 0.025f, -0.235f}, {width + 0.02f, y + 0.025f, -0.195f}, p.metal);
        }
        box(mesh, frame, {-0.06f, -0.035f, -0.12f}, {width + 0.06f, 0.004f, 0.1f}, p.wood);
        const float drop = random.between(0.7f, 1.0f) * (height - 0.1f);
        venetian_blind(mesh, frame * at({0, height - 0.08f - drop, -0.09f}), width, drop,
                       random.between(0.03f, 0.1f), p);
        // a radiator under the sill
        for (int fin = 0; fin < 24; ++fin) {
            const float x = 0.2f + (width - 0.4f) * static_cast<float>(fin) / 23;
            box(mesh, frame, {x - 0.02f, -0.75f, 0.03f}, {x + 0.02f, -0.15f, 0.09f}, p.white);
        }
        const Vec3 pipe[] = {frame.point({0.1f, -0.7f, 0.06f}), frame.point({width - 0.1f, -0.7f, 0.06f})};
        tube(mesh, pipe, 0.015f, 0.015f, 10, p.white);
    }
}

}  // namespace ctpbench::recipe
