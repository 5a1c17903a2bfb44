// Which triangles meet at a vertex. Vertices are the same if their positions are: meshes from files often
// hold one several times, for the sake of normals or texture coordinates.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/primitives/geometry.h"

namespace ctpbench {

class MeshAdjacency {
public:
    // Time and memory are linear in the triangles.
    explicit MeshAdjacency(const GeometryView& geometry);

    // Corner 0, 1 or 2 of a triangle as the number of its position.
    std::uint32_t vertex(std::uint32_t triangle, int corner) const {
        return corners_[3 * std::size_t{triangle} + static_cast<std::size_t>(corner)];
    }
    // The triangles with a corner at this position, in ascending order; one that has two corners there is
    // listed twice.
    std::span<const std::uint32_t> around(std::uint32_t vertex) const {
        return {triangles_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
    }
    std::size_t vertices() const { return first_.size() - 1; }

private:
    std::vector<std::uint32_t> corners_;  // three for each triangle
    std::vector<std::uint32_t> first_;    // of each vertex, in triangles_
    std::vector<std::uint32_t> triangles_;
};

}  // namespace ctpbench
