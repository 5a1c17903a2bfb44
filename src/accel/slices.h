// Boxes of what lies between successive planes across an axis. A reference between two of them extends one
// box. One that they cut is cut by all of them at once, eight to a vector; the boxes of parts are kept apart,
// coordinate by coordinate.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "accel/bin_grid.h"
#include "accel/plane_tally.h"
#include "accel/reference.h"
#include "accel/vectors.h"

namespace ctpbench {

template <int axis>
class Slices {
public:
    // Must be called first.
    void clear(const BinGrid& grid, const Candidates& planes) {
        constexpr float inf = std::numeric_limits<float>::infinity();
        count_ = planes.count + 1;
        for (std::uint32_t i = 0; 8 * i < count_; ++i) {
            for (int k = 0; k < 3; ++k) {
                lo_[k][i] = Float8{} + inf;
                hi_[k][i] = Float8{} - inf;
            }
        }
        for (std::uint32_t s = 0; s < count_; ++s) whole_[s] = Bounds4::empty();
        std::uint8_t slice = 0;
        for (int b = 0; b <= grid.last; ++b) {
            if (slice < planes.count && planes.plane[slice].bin == b) {
                end_[slice / 8][slice % 8] = grid.plane(b);
                ++slice;
                begin_[slice / 8][slice % 8] = grid.plane(b);
            }
            slice_of_[b] = slice;
        }
    }

    // A reference from one bin to another, of a shape that `cut` gives a slicer for.
    template <class MakeSlicer>
    void add(const Reference& r, int first_bin, int last_bin, const MakeSlicer& make_slicer) {
        const int first = slice_of_[first_bin], last = slice_of_[last_bin];
        if (first == last) {
            whole_[first].extend(r.bounds());
        } else {
            make_slicer([&](const auto& slicer) { add_parts(slicer, r, first, last); });
        }
    }

    void join(const Slices& other) {
        for (std::uint32_t s = 0; s < count_; ++s) whole_[s].extend(other.whole_[s]);
        for (std::uint32_t i = 0; 8 * i < count_; ++i) {
            for (int k = 0; k < 3; ++k) extend(lo_[k][i], hi_[k][i], other.lo_[k][i], other.hi_[k][i]);
        }
    }

    std::uint32_t count() const { return count_; }
    Bounds4 box(std::uint32_t s) const {
        constexpr int x = (3 - axis) % 3, y = (4 - axis) % 3, z = (5 - axis) % 3;
        const std::uint32_t i = s / 8, k = s % 8;
        const Bounds4 parts{{lo_[x][i][k], lo_[y][i][k], lo_[z][i][k], 0},
                            {hi_[x][i][k], hi_[y][i][k], hi_[z][i][k], 0}};
        return whole_[s].united(parts);
    }

private:
    template <class Slicer>
    void add_parts(const Slicer& slicer, const Reference& r, int first, int last) {
        constexpr int u = (axis + 1) % 3, v = (axis + 2) % 3;
        constexpr float inf = std::numeric_limits<float>::infinity();
        const Float8 least[2] = {Float8{} + r.lo[u], Float8{} + r.lo[v]};
        const Float8 most[2] = {Float8{} + r.hi[u], Float8{} + r.hi[v]};
        for (int i = first / 8; i <= last / 8; ++i) {
            const Int8 slice = Int8{0, 1, 2, 3, 4, 5, 6, 7} + 8 * i;
            const Float8 from = slice == first ? Float8{} + r.lo[axis] : begin_[i];
            const Float8 to = slice == last ? Float8{} + r.hi[axis] : end_[i];
            Float8 lo[2], hi[2];
            slicer(from, to, lo, hi);
            Int8 inside = (slice >= first) & (slice <= last);
            for (int k = 0; k < 2; ++k) {
                lo[k] = lo[k] > least[k] ? lo[k] : least[k];
                hi[k] = hi[k] < most[k] ? hi[k] : most[k];
                inside &= lo[k] <= hi[k];
            }
            // No masked stores: the next reference would have to wait for them.
            const auto add = [&](int k, const Float8& l, const Float8& h) {
                extend(lo_[k][i], hi_[k][i], inside ? l : Float8{} + inf, inside ? h : Float8{} - inf);
            };
            add(0, from, to);
            add(1, lo[0], hi[0]);
            add(2, lo[1], hi[1]);
        }
    }

    static void extend(Float8& lo, Float8& hi, const Float8& l, const Float8& h) {
        lo = l < lo ? l : lo;
        hi = h > hi ? h : hi;
    }

    static constexpr std::uint32_t kBlocks = kMaxBins / 8;
    std::uint32_t count_;
    Float8 begin_[kBlocks], end_[kBlocks];    // planes; a reference itself ends the first and the last slice
    Float8 lo_[3][kBlocks], hi_[3][kBlocks];  // of parts: along the axis, then along the two that follow it
    Bounds4 whole_[kMaxBins];
    std::uint8_t slice_of_[kMaxBins];  // that each bin is part of
};

}  // namespace ctpbench
