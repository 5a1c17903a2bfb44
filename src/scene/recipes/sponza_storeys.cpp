#include "scene/recipes/shapes.h"
#include "scene/recipes/sponza_parts.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

using Size = SponzaSize;
constexpr float aisle = Size::outer - Size::court;

// A stepped moulding along x, standing out from the plane z = 0.
void cornice(Mesh& mesh, const Frame& frame, float reach, float height, MaterialId material) {
    constexpr OutlinePoint profile[] = {{-0.02f, 0},    {0.25f, 0.08f}, {0.3f, 0.3f},  {0.55f, 0.45f},
                                        {0.75f, 0.55f}, {1.0f, 0.6f},   {1.0f, 0.98f}, {-0.02f, 1.0f}};
    surface(mesh, Size::bays, 7, material, [&](float u, float v) {
        const OutlinePoint q = profile[static_cast<int>(v * 7 + 0.5f)];
        return frame.point({(2 * u - 1) * Size::half_length, q.y * height, q.x * reach});
    });
}

void vault_rib(Mesh& mesh, const Frame& frame, float x, const SponzaPalette& p) {
    std::vector<Vec3> path;
    for (int i = 0; i <= 16; ++i) {
        const auto [c, s] = circle(0.5 - 0.5 * i / 16);
        path.push_back(frame.point({x, Size::spring - 0.1f + 1.72f * s, -aisle / 2 + aisle / 2 * 0.98f * c}));
    }
    tube(mesh, path, 0.14f, 0.14f, 8, p.trim);
}

}  // namespace

void sponza_ground_storey(Mesh& mesh, const Frame& side, const SponzaPalette& p) {
    const Arch arch{Size::bay, 1.42f, Size::spring, Size::gallery - 0.3f, 0.6f, 28};
    const Column pillar{0.34f, Size::spring, 32, 16};
    for (int i = 0; i < Size::bays; ++i) {
        const float x = -Size::half_length + Size::bay * static_cast<float>(i);
        const Frame bay = side * at({x, 0, 0.3f});
        arch_bay(mesh, bay, arch, p.stone);
        archivolt(mesh, bay, arch, 0.2f, p.trim);
        groin_vault(mesh, side * at({x + Size::bay / 2, Size::spring, -aisle / 2}), Size::bay, aisle, 1.75f,
                    16, p.vault);
        if (i > 0) vault_rib(mesh, side, x, p);
        const Frame outer = side * at({x, 0, -aisle});
        if (i > 0) {
            box(mesh, outer, {-0.3f, 0.003f, -0.05f}, {0.3f, Size::spring, 0.22f}, p.stone);
            box(mesh, outer, {-0.38f, Size::spring - 0.25f, -0.04f}, {0.38f, Size::spring + 0.02f, 0.3f},
                p.trim);
        }
    }
    for (int i = 0; i <= Size::bays; ++i) {
        const float x = -Size::half_length + Size::bay * static_cast<float>(i);
        column(mesh, side * at({x, 0, 0}), pillar, p.stone, p.trim);
    }
    // The outer wall of both storeys with doors below and windows above.
    std::vector<Opening> openings;
    for (int i = 0; i < Size::bays; ++i) {
        const float middle = Size::bay * (static_cast<float>(i) + 0.5f);
        if (i % 2 == 1) openings.push_back({middle - 0.6f, middle + 0.6f, 0.032f, 2.4f});
        openings.push_back({middle - 0.5f, middle + 0.5f, Size::gallery + 0.9f, Size::gallery + 2.7f});
    }
    const Frame wall = side * at({-Size::half_length, -0.012f, -aisle});
    pierced_wall(mesh, wall, 2 * Size::half_length, Size::ridge + 0.012f, openings, 0.25f, p.wall);
    for (const Opening& o : openings) {
        add_quad(mesh, wall.point({o.x0, o.y0, -0.25f}), wall.point({o.x1, o.y0, -0.25f}),
                 wall.point({o.x1, o.y1, -0.25f}), wall.point({o.x0, o.y1, -0.25f}), p.wood);
        for (int plank = 0; plank < 5; ++plank) {
            const float w = (o.x1 - o.x0) / 5, x = o.x0 + w * static_cast<float>(plank);
            box(mesh, wall, {x + 0.01f, o.y0 + 0.02f, -0.27f}, {x + w - 0.01f, o.y1 - 0.02f, -0.2f}, p.wood);
        }
    }
}

void sponza_upper_storey(Mesh& mesh, const Frame& side, const SponzaPalette& p) {
    const float length = Size::half_length, floor = Size::gallery;
    box(mesh, side, {-length, floor - 0.299f, -aisle}, {length, floor, 0.32f}, p.trim);
    cornice(mesh, side * at({0, floor - 0.45f, 0.31f}), 0.4f, 0.46f, p.trim);
    box(mesh, side, {-length + 0.01f, floor - 0.01f, -0.2f}, {length - 0.01f, floor + 0.7f, 0.2f}, p.brick);
    box(mesh, side, {-length + 0.02f, floor + 0.69f, -0.26f}, {length - 0.02f, floor + 0.8f, 0.26f}, p.trim);

    constexpr int arches = 2 * Size::bays;
    const Arch arch{Size::bay / 2, 0.74f, Size::upper_spring, Size::eaves, 0.4f, 20};
    const Column shaft{0.17f, Size::upper_spring - floor - 0.79f, 20, 8};
    for (int i = 0; i <= arches; ++i) {
        const float x = -length + Size::bay / 2 * static_cast<float>(i);
        column(mesh, side * at({x, floor + 0.79f, 0}), shaft, p.stone, p.trim);
        if (i == arches) break;
        const Frame bay = side * at({x, 0, 0.2f});
        arch_bay(mesh, bay, arch, p.brick);
        archivolt(mesh, bay, arch, 0.12f, p.trim);
    }
}

void sponza_roof(Mesh& mesh, const Frame& side, const SponzaPalette& p) {
    const float length = Size::half_length;
    cornice(mesh, side * at({0, Size::eaves - 0.3f, 0.19f}), 0.35f, 0.35f, p.trim);
    for (int i = 0; i < 2 * Size::bays; ++i) {  // beams under the roof
        const float x = -length + Size::bay / 2 * (static_cast<float>(i) + 0.5f);
        box(mesh, side, {x - 0.09f, Size::eaves - 0.35f, -aisle}, {x + 0.09f, Size::eaves - 0.08f, -0.15f},
            p.wood);
    }
    const auto corner = [&](float x, float z, float y) { return side.point({x, y, z}); };
    add_quad(mesh, corner(-length, -aisle, Size::eaves - 0.09f), corner(length, -aisle, Size::eaves - 0.09f),
             corner(length, -0.15f, Size::eaves - 0.09f), corner(-length, -0.15f, Size::eaves - 0.09f),
             p.wood);
    add_quad(mesh, corner(-length, 0.5f, Size::eaves), corner(length, 0.5f, Size::eaves),
             corner(length, -aisle, Size::ridge), corner(-length, -aisle, Size::ridge), p.tile);
    constexpr int rows = 7, columns = 84;
    const Vec3 down = Vec3{0, Size::eaves - Size::ridge, aisle + 0.55f} * (1.0f / rows);
    const float width = 2 * length / columns;
    for (int i = 0; i < columns; ++i) {
        const float x = -length + width * (static_cast<float>(i) + 0.5f);
        for (int row = 0; row < rows; ++row) {
            const Vec3 top = Vec3{x, Size::ridge, -aisle} + down * static_cast<float>(row);
            surface(mesh, 6, 1, p.tile, [&](float u, float v) {
                const auto [c, s] = circle(0.5 - 0.5 * static_cast<double>(u));
                const float r = width * (0.4f + 0.06f * (1 - v));
                return side.point(top + down * ((1 - v) * 1.06f) +
                                  Vec3{r * c, r * s + 0.01f + 0.03f * (1 - v), 0});
            });
        }
    }
}

}  // namespace ctpbench::recipe
