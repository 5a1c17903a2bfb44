// Perfect specular reflection of a constant colour.
#pragma once

#include "description.h"
#include "scattering.h"

namespace ctpbench {

struct Mirror {
    static constexpr const char* name = "mirror";

    Vec3 reflectance;

    static Mirror make(const MaterialDescription& d) { return {d.specular}; }

    // The one direction that reflects has no density per steradian; every other reflects nothing.
    CTP_INLINE Vec3 shade(const SurfacePoint&, Vec3) const { return {0.0f, 0.0f, 0.0f}; }
    CTP_INLINE float pdf(const SurfacePoint&, Vec3) const { return 0.0f; }
    CTP_INLINE Scattering sample(const SurfacePoint& point, const PathRandom&) const {
        return scattered(2.0f * dot(point.normal, point.wo) * point.normal - point.wo, reflectance);
    }
};

}  // namespace ctpbench
