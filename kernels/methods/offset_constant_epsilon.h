// The origin of a secondary ray is moved along the ray by a fixed distance, 1e-4 scene units, as the paper's
// library does in its path tracer. It knows neither how large the scene is nor how far from zero: too short
// where coordinates are in the thousands, so that a ray hits what it just left; and where the whole scene
// measures a thousandth, long enough to jump over what is near.
#pragma once

#include "../vec.h"

namespace ctpbench {

struct ConstantEpsilon {
    static constexpr const char* name = "constant_epsilon";
    static constexpr bool excludes = false;
    static constexpr float distance = 1e-4f;  // scene units, directions being of unit length

    // As WaechterBinder::origin().
    CTP_INLINE static Vec3 origin(Vec3 point, Vec3 /*normal*/, Vec3 direction, float /*t*/) {
        return point + distance * direction;
    }
};

}  // namespace ctpbench
