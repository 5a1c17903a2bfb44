// Equal steps along the axes of a box, by which references are binned.
#pragma once

#include <cstdint>
#include <limits>

#include "accel/reference.h"
#include "accel/vectors.h"

namespace ctpbench {

inline constexpr std::uint32_t kMaxBins = 64;

// One axis.
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

// Three axes at once, each as BinGrid has it. One that is not usable has a single bin.
class BinGrids {
public:
    BinGrids(const Bounds4& box, std::uint32_t bins) : last_(static_cast<int>(bins) - 1) {
        for (int a = 0; a < 3; ++a) {
            const BinGrid grid(box.lo[a], box.hi[a], bins);
            origin_[a] = grid.origin;
            per_unit_[a] = grid.per_unit;
        }
    }
    bool usable(int axis) const { return per_unit_[axis] > 0; }
    Int4 bin(Float4 x) const { return clamp(__builtin_convertvector(offset(x), Int4)); }
    Int4 end_bin(Float4 x, Int4 from) const {
        const Float4 at = offset(x);
        const Int4 whole = __builtin_convertvector(at, Int4);
        // A true comparison is -1.
        const Int4 b = clamp(whole + (__builtin_convertvector(whole, Float4) == at));
        return b > from ? b : from;
    }

private:
    Float4 offset(Float4 x) const {
        const Float4 most = {1e6f, 1e6f, 1e6f, 1e6f};
        return lower(upper((x - origin_) * per_unit_, Float4{}), most);
    }
    Int4 clamp(Int4 b) const {
        const Int4 most = {last_, last_, last_, last_};
        b = b < 0 ? Int4{} : b;
        return b > most ? most : b;
    }

    // The fourth lane is that of references, whose bits may be a denormal number: far from it, nothing is
    // slow.
    Float4 origin_ = {1, 1, 1, 1}, per_unit_ = {};
    int last_;
};

}  // namespace ctpbench
