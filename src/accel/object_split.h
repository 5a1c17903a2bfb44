// Object splits: every reference goes to one side, by the position of its center along an axis. Binned,
// or exact over all positions for nodes of few references.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "accel/bin_grid.h"
#include "accel/reference.h"
#include "accel/sbvh.h"
#include "accel/split_sweep.h"

namespace ctpbench {

struct ObjectSplit : SplitSides {
    int axis = 0;
    std::uint32_t rank = 0;   // exact: the first `rank` references in order of their centers go left
    int first_right_bin = 0;  // binned: bins from this one on go right
    std::uint32_t bins = 0;   // 0 for an exact split

    // The grid that the binned split was found on.
    BinGrid grid(const Extent& e) const { return {e.centers.lo[axis], e.centers.hi[axis], bins}; }
};

// Best by the surface area heuristic; exists() is false if all centers coincide.
ObjectSplit find_object_split(std::span<const Reference> refs, const Extent& extent,
                              const SbvhSettings& settings);

// For each axis, references in order of their centers, ties in the order they were in.
using CenterOrder = std::array<std::array<std::uint8_t, kMaxBins>, 3>;
void sort_by_center(std::span<const Reference> refs, CenterOrder& order);

}  // namespace ctpbench
