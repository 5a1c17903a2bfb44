#include "scene/recipes/courtyard_parts.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

using Size = CourtyardSize;

// Half-round tiles from z = 0 down to z = reach along x from 0 to length; the frame's y = 0 is the upper
// edge.
void tiled_roof(Mesh& mesh, const Frame& frame, float length, float reach, float fall, int rows,
                MaterialId material) {
    add_quad(mesh, frame.point({0, -fall, reach}), frame.point({length, -fall, reach}),
             frame.point({length, 0, 0}), frame.point({0, 0, 0}), material);
    const int columns = static_cast<int>(length / 0.22f);
    const float width = length / static_cast<float>(columns);
    const Vec3 down = Vec3{0, -fall, reach} * (1.0f / static_cast<float>(rows));
    for (int i = 0; i < columns; ++i) {
        for (int row = 0; row < rows; ++row) {
            const Vec3 top =
                Vec3{width * (static_cast<float>(i) + 0.5f), 0, 0} + down * static_cast<float>(row);
            surface(mesh, 6, 1, material, [&](float u, float v) {
                const auto [c, s] = circle(0.5 - 0.5 * static_cast<double>(u));
                const float r = width * (0.4f + 0.07f * (1 - v));
                return frame.point(top + down * ((1 - v) * 1.08f) +
                                   Vec3{r * c, r * s + 0.01f + 0.03f * (1 - v), 0});
            });
        }
    }
}

void window_grille(Mesh& mesh, const Frame& frame, const Opening& o, MaterialId iron) {
    const float width = o.x1 - o.x0;
    for (int i = 1; i < 9; ++i) {
        const float x = o.x0 + width * static_cast<float>(i) / 9;
        std::vector<Vec3> bar;
        for (int k = 0; k <= 10; ++k) {  // bellied at the foot, as Spanish grilles are
            const float t = static_cast<float>(k) / 10, belly = t < 0.5f ? circle(t).sin * 0.22f : 0.0f;
            bar.push_back(frame.point({x, o.y0 - 0.05f + (o.y1 - o.y0 + 0.1f) * t, 0.06f + belly}));
        }
        tube(mesh, bar, 0.012f, 0.012f, 6, iron);
    }
    for (const float t : {0.05f, 0.5f, 0.72f, 0.95f}) {
        const float y = o.y0 + (o.y1 - o.y0) * t;
        const float belly = t < 0.5f ? circle(t * 0.9f + 0.05f).sin * 0.22f : 0.0f;
        const Vec3 bar[] = {
            frame.point({o.x0 - 0.06f, y, -0.02f}), frame.point({o.x0 - 0.06f, y, 0.06f + belly}),
            frame.point({o.x1 + 0.06f, y, 0.06f + belly}), frame.point({o.x1 + 0.06f, y, -0.02f})};
        tube(mesh, bar, 0.01f, 0.01f, 6, iron);
    }
}

// Leaves of wood that close an opening, `depth` behind the wall, with a stone surround.
void shutters(Mesh& mesh, const Frame& wall, const Opening& o, float depth, const CourtyardPalette& p) {
    add_quad(mesh, wall.point({o.x0, o.y0, -depth}), wall.point({o.x1, o.y0, -depth}),
             wall.point({o.x1, o.y1, -depth}), wall.point({o.x0, o.y1, -depth}), p.wood);
    const float middle = (o.x0 + o.x1) / 2, height = o.y1 - o.y0;
    for (const float x : {o.x0 + 0.03f, middle + 0.01f}) {
        const float width = middle - o.x0 - 0.04f;
        for (int i = 0; i < 14; ++i) {
            const float y = o.y0 + 0.05f + (height - 0.1f) * static_cast<float>(i) / 14;
            box(mesh, wall * tipped({x, y, -depth + 0.03f}, 0.07f), {0, 0, 0},
                {width, (height - 0.1f) / 15, 0.012f}, p.wood);
        }
    }
    for (const float x : {o.x0 - 0.14f, o.x1 - 0.01f}) {
        box(mesh, wall, {x, o.y0 + 0.002f, -0.08f}, {x + 0.15f, o.y1 + 0.15f, 0.05f}, p.trim);
    }
    box(mesh, wall, {o.x0 + 0.008f, o.y1 - 0.012f, -0.075f}, {o.x1 - 0.008f, o.y1 + 0.145f, 0.045f}, p.trim);
}

}  // namespace

void railing(Mesh& mesh, const Frame& frame, float length, const CourtyardPalette& p) {
    constexpr ProfilePoint baluster[] = {{0.03f, 0.02f},  {0.03f, 0.1f},  {0.015f, 0.14f}, {0.034f, 0.3f},
                                         {0.026f, 0.42f}, {0.013f, 0.6f}, {0.024f, 0.72f}, {0.024f, 0.86f}};
    const int count = static_cast<int>(length / 0.15f);
    for (int i = 0; i < count; ++i) {
        const float x = length * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        lathe(mesh, frame * at({x, 0, 0}), baluster, 10, p.iron);
    }
    box(mesh, frame, {0, 0.01f, -0.04f}, {length, 0.04f, 0.04f}, p.wood);
    box(mesh, frame, {0, 0.85f, -0.05f}, {length, 0.92f, 0.05f}, p.wood);
}

void courtyard_wall(Mesh& mesh, const Frame& frame, float width, MaterialId plaster,
                    const CourtyardPalette& p) {
    std::vector<Opening> openings;
    const int bays = static_cast<int>(width / 4);
    for (int i = 0; i < bays; ++i) {
        const float x = width * (static_cast<float>(i) + 0.5f) / static_cast<float>(bays);
        const bool door = i % 2 == 0;
        openings.push_back({x - 0.7f, x + 0.7f, door ? 0.03f : 0.9f, 2.5f});
        openings.push_back(
            {x - 0.65f, x + 0.65f, Size::storey + (door ? 0.95f : 0.05f), Size::storey + 2.5f});
    }
    pierced_wall(mesh, frame, width, Size::wall, openings, 0.35f, plaster);
    for (const Opening& o : openings) {
        const bool upper = o.y0 > Size::storey;
        const bool walkable = o.y0 < 0.1f || (upper && o.y0 < Size::storey + 0.1f);
        shutters(mesh, frame, o, 0.3f, p);
        if (!walkable) window_grille(mesh, frame, o, p.iron);
        if (walkable && upper) {
            const float x0 = o.x0 - 0.5f, x1 = o.x1 + 0.5f, y = Size::storey;
            box(mesh, frame, {x0, y - 0.16f, -0.05f}, {x1, y, 0.85f}, p.stone);
            railing(mesh, frame * at({x0 + 0.03f, y, 0.78f}), x1 - x0 - 0.06f, p);
            railing(mesh, frame * at({x0 + 0.06f, y, 0.74f}, 0.25f), 0.72f, p);
            railing(mesh, frame * at({x1 - 0.06f, y, 0.74f}, 0.25f), 0.72f, p);
        }
    }
    box(mesh, frame, {0, Size::wall - 0.2f, -0.3f}, {width, Size::wall - 0.01f, 0.12f}, p.trim);
    tiled_roof(mesh, frame * at({0, Size::wall + 0.16f, -0.34f}), width, 0.62f, 0.16f, 2, p.roof);
}

void courtyard_floor(Mesh& mesh, const CourtyardPalette& p, Random& random) {
    constexpr float low_z = -Size::half_z - Size::arcade, grout = -0.01f;
    add_quad(mesh, {-Size::half_x, grout, Size::half_z}, {Size::half_x, grout, Size::half_z},
             {Size::half_x, grout, low_z}, {-Size::half_x, grout, low_z}, p.grout);
    constexpr int columns = 60, rows = 54;
    const float w = 2 * Size::half_x / columns, d = (Size::half_z - low_z) / rows;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            // A flat slab with a worn edge; its five quads share eight vertices.
            const Vec3 a{-Size::half_x + w * static_cast<float>(i), 0, low_z + d * static_cast<float>(j)};
            const MaterialId material = random.below(3) == 0 ? p.tile_sand : p.tile_red;
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            const float y = random.between(-0.003f, 0.001f);
            for (const float inset : {0.006f, 0.018f}) {
                const float height = inset < 0.01f ? grout + 0.0005f : y;
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

void courtyard_arcade(Mesh& mesh, const CourtyardPalette& p) {
    const Arch arch{Size::bay, 1.12f, 2.6f, Size::storey - 0.25f, 0.45f, 28};
    for (int i = 0; i <= Size::bays; ++i) {
        const float x = -Size::half_x + Size::bay * static_cast<float>(i);
        column(mesh, at({x, 0, -Size::half_z}), {0.22f, arch.spring, 32, 12}, p.stone, p.trim);
        if (i == Size::bays) break;
        arch_bay(mesh, at({x, 0, -Size::half_z + 0.225f}), arch, p.rose);
        archivolt(mesh, at({x, 0, -Size::half_z + 0.225f}), arch, 0.16f, p.trim);
        for (int beam = 0; beam < 5; ++beam) {
            const float bx = x + Size::bay * (static_cast<float>(beam) + 0.5f) / 5;
            box(mesh, {bx - 0.06f, Size::storey - 0.42f, -Size::half_z - Size::arcade},
                {bx + 0.06f, Size::storey - 0.245f, -Size::half_z - 0.2f}, p.wood);
        }
    }
    for (const float side : {-1.0f, 1.0f}) {  // the ends of the passage and of the gallery above
        const Frame end =
            at({side * Size::half_x, -0.01f, -Size::half_z - (side < 0 ? 0 : Size::arcade)}, -0.25f * side);
        pierced_wall(mesh, end, Size::arcade, Size::wall + 0.9f, {}, 0.1f, p.white);
    }
}

void courtyard_gallery(Mesh& mesh, const CourtyardPalette& p) {
    const float back = -Size::half_z - Size::arcade, y = Size::storey;
    box(mesh, {-Size::half_x, y - 0.249f, back}, {Size::half_x, y, -Size::half_z + 0.35f}, p.trim);
    railing(mesh, at({-Size::half_x, y, -Size::half_z + 0.2f}), 2 * Size::half_x, p);
    for (int i = 0; i <= Size::bays; ++i) {
        const float x = -Size::half_x + Size::bay * static_cast<float>(i);
        column(mesh, at({x, y, -Size::half_z}), {0.12f, 3.3f, 16, 0}, p.wood, p.wood);
    }
    box(mesh, {-Size::half_x, y + 3.28f, -Size::half_z - 0.12f},
        {Size::half_x, y + 3.5f, -Size::half_z + 0.12f}, p.wood);
    for (int i = 0; i < 32; ++i) {  // rafters
        const float x = -Size::half_x + 2 * Size::half_x * (static_cast<float>(i) + 0.5f) / 32;
        const Vec3 rafter[] = {{x, Size::wall + 0.72f, back}, {x, y + 3.42f, -Size::half_z + 0.7f}};
        tube(mesh, rafter, 0.06f, 0.06f, 6, p.wood);
    }
    tiled_roof(mesh, at({-Size::half_x, Size::wall + 0.85f, back}), 2 * Size::half_x, Size::arcade + 0.8f,
               1.3f, 12, p.roof);
    // The wall behind arcade and gallery.
    const Frame wall = at({-Size::half_x, -0.01f, back});
    std::vector<Opening> openings;
    for (int i = 0; i < Size::bays; ++i) {
        const float x = Size::bay * (static_cast<float>(i) + 0.5f);
        openings.push_back({x - 0.6f, x + 0.6f, i % 2 ? 0.95f : 0.03f, 2.5f});
        openings.push_back({x - 0.6f, x + 0.6f, i % 2 ? y + 0.05f : y + 0.95f, y + 2.4f});
    }
    pierced_wall(mesh, wall, 2 * Size::half_x, Size::wall + 0.9f, openings, 0.35f, p.white);
    for (const Opening& o : openings) {
        shutters(mesh, wall, o, 0.3f, p);
        if (o.y0 > 0.5f && (o.y0 < y || o.y0 > y + 0.5f)) window_grille(mesh, wall, o, p.iron);
    }
}

}  // namespace ctpbench::recipe
