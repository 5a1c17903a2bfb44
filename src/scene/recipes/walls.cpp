#include "scene/recipes/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

namespace {

std::vector<float> levels(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

void pierced_wall(Mesh& mesh, const Frame& frame, float width, float height,
                  std::span<const Opening> openings, float depth, MaterialId material) {
    std::vector<float> xs{0, width}, ys{0, height};
    for (const Opening& o : openings) {
        xs.insert(xs.end(), {o.x0, o.x1});
        ys.insert(ys.end(), {o.y0, o.y1});
    }
    xs = levels(std::move(xs));
    ys = levels(std::move(ys));
    const int columns = static_cast<int>(xs.size()) - 1, rows = static_cast<int>(ys.size()) - 1;
    const auto solid = [&](int i, int j) {
        if (i < 0 || j < 0 || i >= columns || j >= rows) return true;
        const float x = (xs[i] + xs[i + 1]) / 2, y = (ys[j] + ys[j + 1]) / 2;
        return std::none_of(openings.begin(), openings.end(),
                            [&](const Opening& o) { return x > o.x0 && x < o.x1 && y > o.y0 && y < o.y1; });
    };
    // Vertices of the front and the back grid, made when first used: most of the back has none.
    constexpr auto none = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> made(2 * xs.size() * ys.size(), none);
    const auto vertex = [&](int i, int j, bool back) {
        auto& index = made[(back ? ys.size() * xs.size() : 0) + static_cast<std::size_t>(j) * xs.size() +
                           static_cast<std::size_t>(i)];
        if (index == none) index = add_vertex(mesh, frame.point({xs[i], ys[j], back ? -depth : 0.0f}));
        return index;
    };
    // Corners in order: braces are evaluated from left to right, arguments need not be.
    const auto quad = [&](const std::array<std::uint32_t, 4>& c) {
        add_quad(mesh, c[0], c[1], c[2], c[3], material);
    };
    // From (i, j) to (k, l) around the opening, seen from the front: its side of the wall's thickness.
    const auto reveal = [&](int i, int j, int k, int l) {
        quad({vertex(i, j, false), vertex(k, l, false), vertex(k, l, true), vertex(i, j, true)});
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            if (solid(i, j)) {
                quad({vertex(i, j, false), vertex(i + 1, j, false), vertex(i + 1, j + 1, false),
                      vertex(i, j + 1, false)});
                continue;
            }
            if (j > 0 && solid(i, j - 1)) reveal(i, j, i + 1, j);
            if (i < columns - 1 && solid(i + 1, j)) reveal(i + 1, j, i + 1, j + 1);
            if (j < rows - 1 && solid(i, j + 1)) reveal(i + 1, j + 1, i, j + 1);
            if (i > 0 && solid(i - 1, j)) reveal(i, j + 1, i, j);
        }
    }
}

void arch_bay(Mesh& mesh, const Frame& frame, const Arch& arch, MaterialId material) {
    std::vector<Vec3> lower{{0, arch.spring, 0}};
    for (int i = 0; i <= arch.segments; ++i) {
        const auto [c, s] = circle(0.5 - 0.5 * i / arch.segments);
        lower.push_back({arch.width / 2 + arch.radius * c, arch.spring + arch.radius * s, 0});
    }
    lower.push_back({arch.width, arch.spring, 0});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : lower) {  // front low, front high, back low, back high
        const Vec3 back{0, 0, -arch.thickness};
        const Vec3 high{p.x, arch.top, 0};
        for (const Vec3& corner : {p, high, p + back, high + back}) add_vertex(mesh, frame.point(corner));
    }
    for (std::uint32_t i = 0; i + 1 < lower.size(); ++i) {
        const auto a = first + 4 * i, b = a + 4;
        add_quad(mesh, a, b, b + 1, a + 1, material);
        add_quad(mesh, b + 2, a + 2, a + 3, b + 3, material);
        add_quad(mesh, a + 2, b + 2, b, a, material);
    }
}

void archivolt(Mesh& mesh, const Frame& frame, const Arch& arch, float width, MaterialId material) {
    constexpr OutlinePoint profile[] = {{0, 0}, {0, 0.5f}, {0.3f, 0.6f}, {0.7f, 0.3f}, {1, 0.3f}, {1, 0}};
    surface(mesh, 5, arch.segments, material, [&](float u, float v) {
        const OutlinePoint p = profile[static_cast<int>(u * 5 + 0.5f)];
        const auto [c, s] = circle(0.5 - 0.5 * static_cast<double>(v));
        const float r = arch.radius + 0.01f + p.x * width;
        return frame.point({arch.width / 2 + r * c, arch.spring + r * s, p.y * width - 0.01f});
    });
}

void groin_vault(Mesh& mesh, const Frame& frame, float width, float depth, float rise, int n,
                 MaterialId material) {
    surface(mesh, n, n, material, [&](float u, float v) {
        const float a = 2 * u - 1, b = 2 * v - 1;
        const float height = std::sqrt(max(0.0f, 1 - min(a * a, b * b)));
        return frame.point({a * width / 2, height * rise, b * depth / 2});
    });
}

void column(Mesh& mesh, const Frame& frame, const Column& shape, MaterialId shaft, MaterialId trim) {
    const float r = shape.radius, h = shape.height;
    const float foot = 1.2f * r, head = h - 2.2f * r;
    box(mesh, frame, {-1.5f * r, 0.002f, -1.5f * r}, {1.5f * r, 0.5f * r, 1.5f * r}, trim);
    const ProfilePoint base[] = {{1.4f * r, 0.49f * r}, {1.48f * r, 0.6f * r},  {1.4f * r, 0.75f * r},
                                 {1.2f * r, 0.8f * r},  {1.15f * r, 0.9f * r},  {1.3f * r, 0.98f * r},
                                 {1.3f * r, 1.08f * r}, {1.08f * r, 1.14f * r}, {1.0f * r, 1.25f * r}};
    lathe(mesh, frame, base, shape.sides, trim);
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= 8; ++i) {
        const float t = static_cast<float>(i) / 8;
        profile.push_back({r * (1 - 0.16f * t * t), foot + (head - foot) * t});
    }
    lathe(mesh, frame, profile, shape.sides, shaft);
    const ProfilePoint bell[] = {{0.83f * r, head - 0.06f * r}, {0.98f * r, head - 0.02f * r},
                                 {0.98f * r, head + 0.08f * r}, {0.84f * r, head + 0.12f * r},
                                 {0.88f * r, head + 0.7f * r},  {1.0f * r, head + 1.2f * r},
                                 {1.3f * r, head + 1.75f * r}};
    lathe(mesh, frame, bell, shape.sides, trim);
    for (int i = 0; i < shape.leaves; ++i) {
        const bool upper = i % 2 == 1;
        const float rise = (upper ? 1.55f : 1.0f) * r;
        const Frame petal = frame * at({0, head + 0.12f * r, 0}, static_cast<float>(i) / shape.leaves);
        surface(mesh, 4, 6, trim, [&](float u, float v) {
            const float across = 2 * u - 1;
            const float half = (1.15f - v * v) * 2.6f * r / static_cast<float>(shape.leaves);
            const float out = 0.9f * r + 0.14f * r * (1 - across * across) + 0.55f * r * v * v * v;
            const float curl = v > 0.85f ? (v - 0.85f) * 1.2f : 0.0f;
            return petal.point({across * half, rise * (v - curl), out + (upper ? 0.05f * r : 0.0f)});
        });
    }
    box(mesh, frame, {-1.4f * r, h - 0.46f * r, -1.4f * r}, {1.4f * r, h - 0.01f, 1.4f * r}, trim);
}

}  // namespace ctpbench::recipe
