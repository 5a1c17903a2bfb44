// Axis-aligned bounding box. The empty box has lo > hi, so that extending it by anything gives that thing.
#pragma once

#include <limits>

#include "vec.h"

namespace ctpbench {

struct Box {
    Vec3 lo, hi;

    CTP_INLINE static Box empty() {
        constexpr float inf = std::numeric_limits<float>::infinity();
        return {{inf, inf, inf}, {-inf, -inf, -inf}};
    }
    CTP_INLINE bool is_empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
    CTP_INLINE void extend(Vec3 p) {
        lo = min(lo, p);
        hi = max(hi, p);
    }
    CTP_INLINE void extend(const Box& b) {
        lo = min(lo, b.lo);
        hi = max(hi, b.hi);
    }
    CTP_INLINE Vec3 extent() const { return hi - lo; }
    CTP_INLINE Vec3 center() const { return (lo + hi) * 0.5f; }
    // Half the surface area, the quantity that the surface area heuristic compares.
    CTP_INLINE float half_area() const {
        if (is_empty()) return 0.0f;
        const Vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
    CTP_INLINE bool contains(const Box& b) const {
        return lo.x <= b.lo.x && lo.y <= b.lo.y && lo.z <= b.lo.z && hi.x >= b.hi.x && hi.y >= b.hi.y &&
               hi.z >= b.hi.z;
    }
};

CTP_INLINE Box intersection(const Box& a, const Box& b) { return {max(a.lo, b.lo), min(a.hi, b.hi)}; }

}  // namespace ctpbench
