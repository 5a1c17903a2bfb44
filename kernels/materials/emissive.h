// A light: constant radiance to both sides, and the end of the path.
#pragma once

#include "description.h"
#include "scattering.h"

namespace ctpbench {

struct Emissive {
    static constexpr const char* name = "emissive";

    Vec3 radiance;

    static Emissive make(const MaterialDescription& d) { return {d.emission}; }

    CTP_INLINE Vec3 shade(const SurfacePoint&, Vec3) const { return {0.0f, 0.0f, 0.0f}; }
    CTP_INLINE float pdf(const SurfacePoint&, Vec3) const { return 0.0f; }
    CTP_INLINE Scattering sample(const SurfacePoint&, const PathRandom&) const {
        Scattering s = without_light(ScatterEvent::absorbed);
        s.emitted = radiance;
        return s;
    }
};

}  // namespace ctpbench
