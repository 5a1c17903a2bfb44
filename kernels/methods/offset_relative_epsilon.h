// The origin of a secondary ray is moved along the ray by a share of the way that led to the hit, 1e-3 t: the
// rayEpsilon of a triangle in pbrt-v2 (Pharr & Humphreys, "Physically Based Rendering", 2nd edition, 2010,
// Sec. 3.6), where it is the least t of the next ray. It scales with the scene, but follows the last leg of
// the path rather than the rounding of coordinates: a short leg far from zero gives too little, and a long
// one jumps over corners.
#pragma once

#include "../vec.h"

namespace ctpbench {

struct RelativeEpsilon {
    static constexpr const char* name = "relative_epsilon";
    static constexpr bool excludes = false;
    static constexpr float share = 1e-3f;

    // As WaechterBinder::origin().
    CTP_INLINE static Vec3 origin(Vec3 point, Vec3 /*normal*/, Vec3 direction, float t) {
        return point + (share * t) * direction;
    }
};

}  // namespace ctpbench
