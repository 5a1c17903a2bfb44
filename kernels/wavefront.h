// The wavefront's buffers: structure-of-arrays columns, addressed through an index buffer of active
// paths, so that sorting and compaction move indices and never rays (paper, Sec. 5.1).
#pragma once

#include <cstdint>

#include "ray.h"

namespace ctpbench {

struct RayColumns {
    float *ox, *oy, *oz, *dx, *dy, *dz, *tmax;

    CTP_INLINE Ray load(std::uint32_t i) const {
        return {{ox[i], oy[i], oz[i]}, {dx[i], dy[i], dz[i]}, tmax[i]};
    }
    CTP_INLINE void store(std::uint32_t i, const Ray& r) const {
        ox[i] = r.origin.x, oy[i] = r.origin.y, oz[i] = r.origin.z;
        dx[i] = r.direction.x, dy[i] = r.direction.y, dz[i] = r.direction.z;
        tmax[i] = r.tmax;
    }
};

struct HitColumns {
    float* t;
    std::uint32_t* primitive;
    float *u, *v;

    CTP_INLINE Hit load(std::uint32_t i) const { return {t[i], primitive[i], u[i], v[i]}; }
    CTP_INLINE void store(std::uint32_t i, const Hit& h) const {
        t[i] = h.t, primitive[i] = h.primitive, u[i] = h.u, v[i] = h.v;
    }
};

// Per pixel: the product of albedos along the path, and the light gathered, linear RGB.
struct PixelColumns {
    float *throughput_r, *throughput_g, *throughput_b;
    float *radiance_r, *radiance_g, *radiance_b;
};

}  // namespace ctpbench
