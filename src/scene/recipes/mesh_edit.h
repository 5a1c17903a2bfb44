// The few operations from which every recipe builds its mesh. Triangles wind counter-clockwise seen from
// outside; vertices are shared wherever a surface is smooth or flat.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/recipes/frame.h"
#include "scene/recipes/palette.h"
#include "scene/scene.h"

namespace ctpbench::recipe {

inline std::uint32_t add_vertex(Mesh& mesh, Vec3 p) {
    mesh.positions.push_back(p);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

inline void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, MaterialId material) {
    mesh.triangles.push_back({a, b, c});
    mesh.material.push_back(material);
}

inline void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                     MaterialId material) {
    add_triangle(mesh, a, b, c, material);
    add_triangle(mesh, a, c, d, material);
}

inline void add_quad(Mesh& mesh, Vec3 a, Vec3 b, Vec3 c, Vec3 d, MaterialId material) {
    const auto first = add_vertex(mesh, a);
    add_vertex(mesh, b);
    add_vertex(mesh, c);
    add_vertex(mesh, d);
    add_quad(mesh, first, first + 1, first + 2, first + 3, material);
}

// Room for that many triangles, with up to as many vertices.
void reserve(Mesh& mesh, std::size_t triangles, std::size_t vertices);

// Appends a copy of `part`, placed by `frame`. A frame that mirrors would turn the winding; none here does.
void place(Mesh& mesh, const Mesh& part, const Frame& frame);

// How many triangles are still to come before the mesh has `target`. Throws if fewer than `least` are left:
// the recipe's fixed parts have outgrown its budget.
std::size_t remaining(const Mesh& mesh, std::size_t target, std::size_t least);

// Share `i` of `n` of a total: the shares differ by one at most and add up exactly.
constexpr std::size_t share(std::size_t total, std::size_t i, std::size_t n) {
    return total * (i + 1) / n - total * i / n;
}

}  // namespace ctpbench::recipe
