// Splits a polygon into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/vec.h"

namespace ctpbench {

// Ear clipping (Meisters 1975) in the coordinate plane nearest to the polygon's own. The corners name the
// positions, in order around the polygon, which may be concave; the triangles name the corners, since two
// corners at one position may differ in what else they carry. Always corners.size() - 2 triangles with the
// polygon's orientation; one that has no ear left (it crosses itself, or has no area) is finished as a fan.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> positions,
                                                      std::span<const std::uint32_t> corners);

}  // namespace ctpbench
