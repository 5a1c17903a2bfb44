// A ray and the closest hit found along it.
#pragma once

#include <cstdint>
#include <limits>

#include "vec.h"

namespace ctpbench {

inline constexpr std::uint32_t kNoPrimitive = 0xffffffffu;

// Points o + t d for 0 < t <= tmax. The direction need not be normalised; t is in units of |d|.
// Rays leave a surface from an offset origin (methods/offset_*.h), so there is no tmin.
struct Ray {
    Vec3 origin;
    Vec3 direction;
    float tmax;
};

// Closest hit so far: `t` also bounds the search. `primitive` is the scene-wide id: triangles come
// first, in mesh order, then spheres. u and v are the barycentric weights of a triangle's second and
// third vertex, and 0 for a sphere.
struct Hit {
    float t;
    std::uint32_t primitive;
    float u, v;

    // A candidate wins if it is nearer, or as near with a lower id. This is what makes hits independent
    // of the order in which a tree visits its leaves. An infinite t is an overflow and no hit, although it is
    // not beyond an infinite tmax.
    CTP_INLINE bool accepts(float candidate_t, std::uint32_t candidate) const {
        return candidate_t > 0.0f &&
               (candidate_t < t || (candidate_t == t && candidate < primitive &&
                                    candidate_t < std::numeric_limits<float>::infinity()));
    }
};

CTP_INLINE Hit no_hit(const Ray& ray) { return {ray.tmax, kNoPrimitive, 0.0f, 0.0f}; }

}  // namespace ctpbench
