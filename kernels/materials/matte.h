// Lambert: the same radiance in every direction.
#pragma once

#include "../surface.h"
#include "diffuse_color.h"

namespace ctpbench {

// Color: diffuse_color.h.
template <class Color>
struct MatteOf {
    static constexpr const char* name = "matte";

    Color color;

    static MatteOf make(const MaterialDescription& d) { return {Color::make(d)}; }

    // f(wo, wi), per steradian.
    CTP_INLINE Vec3 shade(const SurfacePoint& point, Vec3 wi) const {
        Vec3 albedo;
        if (!color.at(point, albedo) || dot(point.normal, wi) <= 0.0f) return {0.0f, 0.0f, 0.0f};
        return albedo * kInvPi;
    }
    // Density with which sample() picks wi, per steradian.
    CTP_INLINE float pdf(const SurfacePoint& point, Vec3 wi) const {
        return max(dot(point.normal, wi), 0.0f) * kInvPi;
    }
    CTP_INLINE Scattering sample(const SurfacePoint& point, const PathRandom& random) const {
        Vec3 albedo;
        if (!color.at(point, albedo)) return without_light(ScatterEvent::passed);
        const Random4 r = random.draw();
        return scattered(cosine_direction(point.normal, r.v[0], r.v[1]), albedo);
    }
};

using Matte = MatteOf<DiffuseColor>;

}  // namespace ctpbench
