#include "scene/recipes/shapes.h"
#include "scene/recipes/sponza_parts.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

using Size = SponzaSize;

// A bump of height 1 at the centre, falling to a half at `width`.
float bump(float dx, float dy, float width) { return 1 / (1 + (dx * dx + dy * dy) / (width * width)); }

// Relief above the plate at polar coordinates; the angle is in turns from +x.
float lion_relief(double angle, float r) {
    const auto [c, s] = circle(angle);
    const float x = r * c, y = r * s;
    const float edge = max(0.0f, 1 - r * r);
    const float locks = circle(13 * angle + 0.9 * r).sin * (0.6f + 0.4f * circle(5 * angle - 0.7 * r).cos);
    const float mane = min(1.0f, max(0.0f, (r - 0.42f) * 5)) * edge * (0.45f + 0.25f * locks);
    const float face = 0.45f * max(0.0f, 1 - r * r / 0.4f);
    const float brow = 0.16f * (bump(x - 0.26f, y - 0.3f, 0.13f) + bump(x + 0.26f, y - 0.3f, 0.13f));
    const float eyes = -0.3f * (bump(x - 0.25f, y - 0.13f, 0.07f) + bump(x + 0.25f, y - 0.13f, 0.07f));
    const float muzzle = 0.3f * (bump(x - 0.12f, y + 0.26f, 0.13f) + bump(x + 0.12f, y + 0.26f, 0.13f));
    const float nose = 0.28f * bump(x, 0.4f * y, 0.07f);
    const float mouth = -0.45f * bump(x * 0.4f, y + 0.45f, 0.07f);
    const float ears = 0.24f * (bump(x - 0.52f, y - 0.58f, 0.12f) + bump(x + 0.52f, y - 0.58f, 0.12f));
    return mane + face + (brow + eyes + muzzle + nose + mouth + ears) * min(1.0f, edge * 2);
}

}  // namespace

void lion_plaque(Mesh& mesh, const Frame& frame, float radius, const SponzaPalette& p) {
    const ProfilePoint plate[] = {{1.25f * radius, -0.02f},
                                  {1.25f * radius, 0.1f},
                                  {1.18f * radius, 0.16f},
                                  {1.1f * radius, 0.12f},
                                  {1.0f * radius, 0.05f}};
    lathe(mesh, frame * standing({0, 0, 0}, {0, 0, 1}), plate, 64, p.trim);
    constexpr int around = 96, rings = 40;
    const auto relief = [&](double angle, float r) {
        const auto [c, s] = circle(angle);
        return frame.point({radius * r * c, radius * r * s, 0.05f + radius * 0.6f * lion_relief(angle, r)});
    };
    constexpr float inner = 0.02f;
    surface(mesh, around, rings, p.plaque,
            [&](float u, float v) { return relief(-static_cast<double>(u), inner + (1 - inner) * v); });
    // The same points as the innermost ring, closed by a fan.
    const auto centre = add_vertex(mesh, relief(0, 0));
    for (int i = 0; i < around; ++i) add_vertex(mesh, relief(static_cast<double>(i) / around, inner));
    for (std::uint32_t i = 0; i < around; ++i) {
        add_triangle(mesh, centre, centre + 1 + i, centre + 1 + (i + 1) % around, p.plaque);
    }
}

void lantern(Mesh& mesh, const Frame& frame, float chain, const SponzaPalette& p) {
    const int links = static_cast<int>(chain / 0.11f);
    for (int i = 0; i < links; ++i) {
        const Frame link =
            frame * at({0, -0.11f * (static_cast<float>(i) + 0.5f), 0}, 0.25f * static_cast<float>(i % 2));
        torus(mesh, link * Frame{{0, 1.4f, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}}, 0.045f, 0.011f, 12, 6,
              p.bronze);
    }
    constexpr ProfilePoint bowl[] = {{0, -0.5f},    {0.05f, -0.48f}, {0.08f, -0.42f}, {0.22f, -0.34f},
                                     {0.3f, -0.2f}, {0.31f, -0.12f}, {0.28f, -0.12f}, {0.27f, -0.2f},
                                     {0.2f, -0.3f}, {0, -0.33f}};
    const Frame low = frame * at({0, -chain, 0});
    lathe(mesh, low, bowl, 28, p.lantern);
    for (int i = 0; i < 3; ++i) {
        const auto [c, s] = circle(i / 3.0);
        const Vec3 rod[] = {low.point({0, 0.03f, 0}), low.point({0.29f * c, -0.13f, 0.29f * s})};
        tube(mesh, rod, 0.012f, 0.012f, 6, p.bronze);
    }
}

void sponza_floor(Mesh& mesh, const SponzaPalette& p, Random& random) {
    const float length = Size::half_length;
    add_quad(mesh, {-length, -0.012f, Size::outer}, {length, -0.012f, Size::outer},
             {length, -0.012f, -Size::outer}, {-length, -0.012f, -Size::outer}, p.grout);
    constexpr int columns = 45, rows = 20;
    const float w = 2 * length / columns, d = 2 * Size::outer / rows;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const Vec3 a{-length + w * static_cast<float>(i), 0, -Size::outer + d * static_cast<float>(j)};
            const MaterialId material = (i + j) % 2 == 0 ? p.floor_light : p.floor_dark;
            const float y = random.between(-0.002f, 0.001f);  // no two tiles lie quite level
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const float inset : {0.008f, 0.02f}) {
                const float height = inset < 0.01f ? -0.0115f : y;
                add_vertex(mesh, a + Vec3{inset, height, d - inset});
                add_vertex(mesh, a + Vec3{w - inset, height, d - inset});
                add_vertex(mesh, a + Vec3{w - inset, height, inset});
                add_vertex(mesh, a + Vec3{inset, height, inset});
            }
            for (std::uint32_t k = 0; k < 4; ++k) {
                const std::uint32_t next = (k + 1) % 4;
                add_quad(mesh, first + k, first + next, first + 4 + next, first + 4 + k, material);
            }
            add_quad(mesh, first + 4, first + 5, first + 6, first + 7, material);
        }
    }
}

void sponza_end_wall(Mesh& mesh, const Frame& end, const SponzaPalette& p) {
    const Frame wall = end * at({-Size::outer, -0.012f, 0});
    const float width = 2 * Size::outer, middle = Size::outer;
    std::vector<Opening> openings{{1.4f, 2.6f, 0.012f, 2.4f}, {width - 2.6f, width - 1.4f, 0.012f, 2.4f}};
    for (int i = -1; i <= 1; ++i) {
        const float x = middle + 2.2f * static_cast<float>(i);
        openings.push_back({x - 0.6f, x + 0.6f, Size::gallery + 0.8f, Size::gallery + 3.0f});
    }
    pierced_wall(mesh, wall, width, Size::ridge + 0.012f, openings, 0.3f, p.brick);
    for (const Opening& o : openings) {
        add_quad(mesh, wall.point({o.x0, o.y0, -0.3f}), wall.point({o.x1, o.y0, -0.3f}),
                 wall.point({o.x1, o.y1, -0.3f}), wall.point({o.x0, o.y1, -0.3f}), p.wood);
        for (const float x : {o.x0 - 0.12f, o.x1 - 0.02f}) {
            box(mesh, wall, {x, o.y0 + 0.003f, -0.1f}, {x + 0.14f, o.y1 + 0.1f, 0.06f}, p.trim);
        }
        box(mesh, wall, {o.x0 + 0.015f, o.y1 - 0.04f, -0.09f}, {o.x1 - 0.015f, o.y1 + 0.095f, 0.055f},
            p.trim);
    }
    box(mesh, end, {-Size::court + 0.5f, Size::gallery - 0.35f, -0.05f},
        {Size::court - 0.5f, Size::gallery, 0.25f}, p.trim);
    for (const float x : {-2.6f, 2.6f}) {
        box(mesh, end, {x - 0.25f, 0.004f, -0.04f}, {x + 0.25f, Size::gallery - 0.34f, 0.16f}, p.stone);
    }
    lion_plaque(mesh, end * at({0, 3.4f, 0.02f}), 1.25f, p);
}

}  // namespace ctpbench::recipe
