// Tessellated surfaces over the unit square. `f(u, v)` gives the point; the outside is on the side of
// df/du x df/dv. `f` must be injective, or triangles of zero area result.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "scene/recipes/mesh_edit.h"

namespace ctpbench::recipe {

// columns x rows cells of two triangles each.
template <class Function>
void surface(Mesh& mesh, int columns, int rows, MaterialId material, Function f) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            add_vertex(mesh, f(static_cast<float>(i) / columns, static_cast<float>(j) / rows));
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const std::uint32_t a = first + j * stride + i;
            add_quad(mesh, a, a + 1, a + stride + 1, a + stride, material);
        }
    }
}

// Exactly `triangles` (at least 2) of them, in cells about square where the surface is `aspect` times as wide
// as high. The last row takes up the slack: a strip between n and m segments has n + m triangles.
template <class Function>
void exact_surface(Mesh& mesh, std::size_t triangles, float aspect, MaterialId material, Function f) {
    const auto wish = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) * 0.5 * aspect));
    std::size_t columns = std::clamp<std::size_t>(wish, 1, triangles - 1);
    const auto slack = [&](std::size_t n) { return (triangles - n - 1) % (2 * n) + 1; };  // 1 .. 2 * n
    // A few columns fewer may leave a last row about as fine as the others.
    for (std::size_t n = columns; n > columns / 2; --n) {
        if (2 * slack(n) >= n && 2 * slack(n) <= 3 * n) {
            columns = n;
            break;
        }
    }
    const std::size_t last = slack(columns);
    const std::size_t full_rows = (triangles - columns - last) / (2 * columns);
    const float rows = static_cast<float>(full_rows + 1);
    const float top = static_cast<float>(full_rows) / rows;
    if (full_rows > 0) {
        surface(mesh, static_cast<int>(columns), static_cast<int>(full_rows), material,
                [&](float u, float v) { return f(u, v * top); });
    } else {
        for (std::size_t i = 0; i <= columns; ++i) {
            add_vertex(mesh, f(static_cast<float>(i) / static_cast<float>(columns), 0.0f));
        }
    }
    const auto upper = static_cast<std::uint32_t>(mesh.positions.size());
    const auto lower = static_cast<std::uint32_t>(upper - columns - 1);
    for (std::size_t j = 0; j <= last; ++j) {
        add_vertex(mesh, f(static_cast<float>(j) / static_cast<float>(last), 1.0f));
    }
    for (std::size_t i = 0, j = 0; i < columns || j < last;) {
        const auto a = lower + static_cast<std::uint32_t>(i), b = upper + static_cast<std::uint32_t>(j);
        if (j == last || (i < columns && (i + 1) * last <= (j + 1) * columns)) {
            add_triangle(mesh, a, a + 1, b, material);
            ++i;
        } else {
            add_triangle(mesh, a, b + 1, b, material);
            ++j;
        }
    }
}

}  // namespace ctpbench::recipe
