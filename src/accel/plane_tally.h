// What a plane across a node leaves on its two sides, from the references' boxes alone: how many there are,
// and which are there whole. That bounds the cost of a split from below, and most planes are done with
// before a single primitive is cut.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "accel/bin_grid.h"
#include "accel/reference.h"

namespace ctpbench {

// A plane that may pay: the one at the lower side of `bin`, with these many references on its two sides.
struct Candidate {
    int bin;
    std::uint32_t left, right;
};

struct Candidates {
    std::array<Candidate, kMaxBins> plane;  // from the left to the right
    std::uint32_t count = 0;
};

// Over the bins of all three axes.
class PlaneTally {
public:
    // Must be called first.
    void clear(std::uint32_t bins) {
        for (Axis& axis : axes_) {
            for (std::uint32_t b = 0; b < bins; ++b) {
                axis.begin[b] = axis.end[b] = Bounds4::empty();
                axis.entries[b] = axis.exits[b] = 0;
            }
        }
    }
    void add(const Reference& r, Int4 first, Int4 last) {
        for (int a = 0; a < 3; ++a) {
            axes_[a].begin[first[a]].extend(r.bounds());
            axes_[a].end[last[a]].extend(r.bounds());
            ++axes_[a].entries[first[a]];
            ++axes_[a].exits[last[a]];
        }
    }
    void join(const PlaneTally& other, std::uint32_t bins) {
        for (int a = 0; a < 3; ++a) {
            for (std::uint32_t b = 0; b < bins; ++b) {
                axes_[a].begin[b].extend(other.axes_[a].begin[b]);
                axes_[a].end[b].extend(other.axes_[a].end[b]);
                axes_[a].entries[b] += other.axes_[a].entries[b];
                axes_[a].exits[b] += other.axes_[a].exits[b];
            }
        }
    }

    // The planes that may cost less than `below` and leave at most `capacity` of the `n` references. `node`
    // is the box of them all.
    template <int axis>
    Candidates candidates(const Bounds4& node, const BinGrid& grid, std::uint32_t n, std::size_t capacity,
                          double below) const {
        const Axis& bins = axes_[axis];
        const std::uint32_t count = static_cast<std::uint32_t>(grid.last) + 1;
        std::array<std::uint32_t, kMaxBins> left_count, right_count;
        std::array<float, kMaxBins> right_area;
        std::uint32_t left = n, right = 0;
        Bounds4 box = Bounds4::empty();
        for (std::uint32_t b = count; b-- > 1;) {
            left_count[b] = left -= bins.entries[b];
            right_count[b] = right += bins.exits[b];
            box.extend(bins.begin[b]);
            Bounds4 least = box;  // parts reach up to the plane, and something to the end of the node
            if (left + right > n) least.lo[axis] = grid.plane(static_cast<int>(b));
            least.hi[axis] = node.hi[axis];
            right_area[b] = least.half_area();
        }
        Candidates found;
        box = Bounds4::empty();
        for (std::uint32_t b = 1; b < count; ++b) {
            box.extend(bins.end[b - 1]);
            left = left_count[b], right = right_count[b];
            if (left == 0 || right == 0 || std::size_t{left} + right > capacity) continue;
            if (left == n && right == n) continue;  // tells nothing apart
            Bounds4 least = box;
            if (left + right > n) least.hi[axis] = grid.plane(static_cast<int>(b));
            least.lo[axis] = node.lo[axis];
            if (double{least.half_area()} * left + double{right_area[b]} * right >= below) continue;
            found.plane[found.count++] = {static_cast<int>(b), left, right};
        }
        return found;
    }

private:
    struct Axis {
        Bounds4 begin[kMaxBins], end[kMaxBins];  // of the references that begin or end in each bin
        std::uint32_t entries[kMaxBins], exits[kMaxBins];
    };
    std::array<Axis, 3> axes_;
};

}  // namespace ctpbench
