#include <array>
#include <cmath>

#include "scene/recipes/conference_parts.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

void swivel_chair(Mesh& mesh, const ConferencePalette& p) {
    for (int i = 0; i < 5; ++i) {
        const Frame arm = at({0, 0, 0}, static_cast<float>(i) / 5);
        const Vec3 leg[] = {arm.point({0, 0.11f, 0.03f}), arm.point({0, 0.1f, 0.15f}),
                            arm.point({0, 0.075f, 0.3f})};
        tube(mesh, leg, 0.026f, 0.016f, 8, p.metal);
        constexpr ProfilePoint wheel[] = {{0, -0.01f},      {0.022f, -0.01f}, {0.027f, -0.006f},
                                          {0.027f, 0.006f}, {0.022f, 0.01f},  {0, 0.01f}};
        for (const float side : {-0.014f, 0.014f}) {
            const Frame axle = arm * standing({side, 0.029f, 0.3f}, {1, 0, 0});
            lathe(mesh, axle, wheel, 12, p.black);
        }
    }
    constexpr ProfilePoint post[] = {{0.05f, 0.085f},  {0.05f, 0.14f},  {0.032f, 0.15f}, {0.032f, 0.27f},
                                     {0.022f, 0.275f}, {0.022f, 0.38f}, {0.12f, 0.40f},  {0.12f, 0.42f}};
    lathe(mesh, {}, post, 20, p.metal);
    cushion(mesh, at({0, 0.46f, 0}), {0.27f, 0.06f, 0.26f}, 8, p.upholstery);

    const std::size_t back = mesh.positions.size();
    cushion(mesh, tipped({0, 0.82f, -0.27f}, -0.02f), {0.26f, 0.30f, 0.05f}, 8, p.upholstery);
    for (std::size_t i = back; i < mesh.positions.size(); ++i) {
        Vec3& q = mesh.positions[i];
        q.z += 0.9f * q.x * q.x;  // wraps around the sitter
    }
    const Vec3 spine[] = {{0, 0.40f, -0.08f}, {0, 0.41f, -0.24f}, {0, 0.46f, -0.33f}, {0, 0.75f, -0.32f}};
    tube(mesh, spine, 0.022f, 0.018f, 8, p.metal);

    std::vector<Vec3> seam;
    for (int i = 0; i <= 32; ++i) {
        const auto [c, s] = circle(static_cast<double>(i) / 32 * 0.98);
        seam.push_back({0.245f * c, 0.46f, 0.235f * s});
    }
    tube(mesh, seam, 0.012f, 0.012f, 6, p.black);
    for (const float side : {-1.0f, 1.0f}) {
        std::array<Vec3, 11> arm;
        for (std::size_t i = 0; i < arm.size(); ++i) {
            const auto [c, s] = circle(0.5 * static_cast<double>(i) / 10);
            arm[i] = {side * (0.27f + 0.03f * s), 0.46f + 0.2f * s, 0.17f * c - 0.02f};
        }
        tube(mesh, arm, 0.014f, 0.014f, 8, p.metal);
        cushion(mesh, at({side * 0.3f, 0.675f, -0.02f}), {0.035f, 0.022f, 0.16f}, 4, p.black);
    }
}

void conference_table(Mesh& mesh, const ConferencePalette& p, float length, float width, float height) {
    std::vector<OutlinePoint> outline;
    std::vector<Vec3> edge;
    constexpr int steps = 48;
    for (int side = 0; side < 2; ++side) {
        for (int i = 0; i < steps; ++i) {
            const float t = 2 * static_cast<float>(i) / (steps - 1) - 1;
            const float s = side == 0 ? 1.0f : -1.0f;
            const float x = -s * t * length / 2, z = s * width / 2 * (1 - 0.3f * t * t);
            outline.push_back({x, z});
        }
    }
    // The outline lies in x-y of a frame whose z is down: the top is the cap at z = 0.
    const Frame down{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, height, 0}};
    std::vector<OutlinePoint> turned(outline.rbegin(), outline.rend());
    prism(mesh, down, turned, 0.045f, p.wood);
    for (const OutlinePoint& q : outline) edge.push_back({q.x * 1.002f, height - 0.022f, q.y * 1.002f});
    edge.push_back(edge.front());
    tube(mesh, edge, 0.028f, 0.028f, 8, p.dark_wood);
    for (const float x : {-0.36f, 0.0f, 0.36f}) {
        const Vec3 c{x * length, 0, 0};
        box(mesh, c + Vec3{-0.3f, 0.06f, -0.22f}, c + Vec3{0.3f, height - 0.05f, 0.22f}, p.dark_wood);
        box(mesh, c + Vec3{-0.45f, 0.002f, -0.5f}, c + Vec3{0.45f, 0.07f, 0.5f}, p.dark_wood);
    }
}

}  // namespace ctpbench::recipe
