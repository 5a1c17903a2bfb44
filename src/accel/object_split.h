// Object splits: every reference goes to one side, by the position of its center along an axis. Binned,
// or exact over all positions for nodes of few references. Costs are areas times counts, so a box without
// area costs nothing instead of dividing by zero; among equals the most even split wins.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "accel/reference.h"
#include "accel/sbvh.h"

namespace ctpbench {

inline constexpr std::uint32_t kMaxBins = 64;

// Where the split is and what it gives.
struct SplitSides {
    double cost = std::numeric_limits<double>::infinity();  // area times count, summed over the sides
    std::uint32_t left = 0, right = 0;                      // references
    Bounds4 left_box = Bounds4::empty(), right_box = Bounds4::empty();

    bool exists() const { return left > 0 && right > 0; }
    static SplitSides of(const Bounds4& l, std::uint32_t nl, const Bounds4& r, std::uint32_t nr) {
        return {double{l.half_area()} * nl + double{r.half_area()} * nr, nl, nr, l, r};
    }
    bool better_than(const SplitSides& o) const {
        if (cost != o.cost) return cost < o.cost;
        const std::uint32_t most = left > right ? left : right, others = o.left > o.right ? o.left : o.right;
        return most < others;
    }
};

// Equal steps along one axis of a box.
struct BinGrid {
    float origin, per_unit, width;
    int last;

    BinGrid(float lo, float hi, std::uint32_t bins)
        : origin(lo),
          per_unit(0),
          width((hi - lo) / static_cast<float>(bins)),
          last(static_cast<int>(bins) - 1) {
        // An extent so small that its reciprocal overflows has no bins to tell apart.
        const float scale = static_cast<float>(bins) / (hi - lo);
        if (hi > lo && scale <= std::numeric_limits<float>::max()) per_unit = scale;
    }
    bool usable() const { return per_unit > 0; }
    int bin(float x) const { return clamp(static_cast<int>(offset(x))); }
    // Bin that a reference ends in: one that ends on a bin's lower side does not enter it.
    int end_bin(float x, int from) const {
        const float at = offset(x);
        const int whole = static_cast<int>(at);
        const int b = clamp(static_cast<float>(whole) == at ? whole - 1 : whole);
        return b > from ? b : from;
    }
    float plane(int b) const { return origin + width * static_cast<float>(b); }

private:
    float offset(float x) const {
        const float v = (x - origin) * per_unit;
        return v < 0 ? 0 : v > 1e6f ? 1e6f : v;
    }
    int clamp(int b) const { return b < 0 ? 0 : b > last ? last : b; }
};

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

// The references in order of their centers, ties in the order they were in.
void sort_by_center(std::span<const Reference> refs, int axis, std::uint8_t* order);

}  // namespace ctpbench
