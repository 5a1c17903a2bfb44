// Boxes in double, and their rounding to float away from the inside. Four lanes, the last one unused, so
// that a compiler turns each operation into one or two vector instructions.
#pragma once

#include "../box.h"

namespace ctpbench {

// A float less than v by one to two ulp, or by the smallest normal number where that is more.
inline float step_below(float v) { return v - (absolute(v) * 0x1p-23f + 0x1p-126f); }
inline float step_above(float v) { return v + (absolute(v) * 0x1p-23f + 0x1p-126f); }

struct alignas(32) DoublePoint {
    double at[4];

    static DoublePoint of(Vec3 v) { return {{v.x, v.y, v.z, 0.0}}; }
};

struct DoubleBox {
    DoublePoint lo{{1e300, 1e300, 1e300, 1e300}};
    DoublePoint hi{{-1e300, -1e300, -1e300, -1e300}};

    void extend(const DoublePoint& p) {
        for (int i = 0; i < 4; ++i) lo.at[i] = p.at[i] < lo.at[i] ? p.at[i] : lo.at[i];
        for (int i = 0; i < 4; ++i) hi.at[i] = p.at[i] > hi.at[i] ? p.at[i] : hi.at[i];
    }

    // The smallest box of floats that is larger by `slack`, which bounds the absolute error of the
    // corners, and at least one ulp; less what is outside `limit`. Box::empty() if nothing is left.
    Box rounded_outward(double slack, const Box& limit) const {
        if (lo.at[0] > hi.at[0]) return Box::empty();
        Box out;
        for (int a = 0; a < 3; ++a) {
            out.lo[a] = max(step_below(static_cast<float>(lo.at[a] - slack)), limit.lo[a]);
            out.hi[a] = min(step_above(static_cast<float>(hi.at[a] + slack)), limit.hi[a]);
        }
        return out.is_empty() ? Box::empty() : out;
    }
};

}  // namespace ctpbench
