// The spheres that the experiment adds to a mesh (the paper's Tables 2 and 3).
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/box.h"
#include "kernels/primitives/shapes.h"

namespace ctpbench {

// The distance between neighbours if `count` points shared the box evenly: cbrt(volume / count). A box that
// is flat along an axis has no volume; it counts as the rectangle or segment that it is:
// sqrt(area / count), length / count.
double mean_spacing(const Box& bounds, std::uint32_t count);

// `count` spheres with centres uniform in the box and one radius, radius_share * mean_spacing(bounds, count).
//
// The centre of sphere i is lo + u * (hi - lo) in float64, then rounded to float32, with u = (w + 1/2) / 2^32
// for the first three words w of Philox4x32-10 with counter (i, 0, 0, 0) and key (low, high half of seed).
// So the spheres are the same on every machine, and those of a smaller count have the same places.
//
// Throws Error(usage) for an empty or single-point box and for a share that is not positive and finite.
std::vector<SphereShape> scatter_spheres(const Box& bounds, std::uint32_t count, float radius_share,
                                         std::uint64_t seed);

}  // namespace ctpbench
