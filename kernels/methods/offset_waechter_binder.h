// Waechter & Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems ch. 6,
// 2019: the origin of a secondary ray is moved along the normal by a number of ulps, or, near zero
// where ulps are too small, by a fixed distance.
#pragma once

#include <bit>

#include "../vec.h"

namespace ctpbench {

CTP_INLINE float offset_component(float p, float n) {
    constexpr float near_zero = 1.0f / 32.0f;
    constexpr float distance = 1.0f / 65536.0f;
    constexpr float ulps = 256.0f;
    if (absolute(p) < near_zero) return fma(distance, n, p);
    const auto steps = static_cast<std::int32_t>(ulps * n);
    const auto bits = std::bit_cast<std::int32_t>(p);
    return std::bit_cast<float>(p < 0.0f ? bits - steps : bits + steps);
}

// `normal` is of unit length and points to the side that the ray leaves on.
CTP_INLINE Vec3 offset_origin(Vec3 p, Vec3 normal) {
    return {offset_component(p.x, normal.x), offset_component(p.y, normal.y),
            offset_component(p.z, normal.z)};
}

struct WaechterBinder {
    static constexpr const char* name = "waechter_binder";
    static constexpr bool excludes = false;  // whether the next intersection leaves out the primitive

    // Where the next ray of a path starts. `point`: on the surface; `normal`: of unit length, to the side
    // that the path goes on to; `direction`: of the next ray, of unit length; `t`: length of the way to the
    // point.
    CTP_INLINE static Vec3 origin(Vec3 point, Vec3 normal, Vec3 /*direction*/, float /*t*/) {
        return offset_origin(point, normal);
    }
};

}  // namespace ctpbench
