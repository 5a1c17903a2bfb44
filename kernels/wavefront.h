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

// Per pixel: the product of weights along the path, and the light gathered, linear RGB.
struct PixelColumns {
    float *throughput_r, *throughput_g, *throughput_b;
    float *radiance_r, *radiance_g, *radiance_b;

    CTP_INLINE void start(std::uint32_t i) const {
        throughput_r[i] = throughput_g[i] = throughput_b[i] = 1.0f;
        radiance_r[i] = radiance_g[i] = radiance_b[i] = 0.0f;
    }
    CTP_INLINE void scale_throughput(std::uint32_t i, Vec3 weight) const {
        throughput_r[i] *= weight.x, throughput_g[i] *= weight.y, throughput_b[i] *= weight.z;
    }
    CTP_INLINE Vec3 throughput(std::uint32_t i) const {
        return {throughput_r[i], throughput_g[i], throughput_b[i]};
    }
    CTP_INLINE void add_radiance(std::uint32_t i, Vec3 arriving) const {
        radiance_r[i] += throughput_r[i] * arriving.x;
        radiance_g[i] += throughput_g[i] * arriving.y;
        radiance_b[i] += throughput_b[i] * arriving.z;
    }
    CTP_INLINE Vec3 radiance(std::uint32_t i) const { return {radiance_r[i], radiance_g[i], radiance_b[i]}; }
};

// Linear RGB per pixel, averaged over the samples so far.
struct ImageColumns {
    float *r, *g, *b;
};

// What shading did with a path. The lowest bit says whether it goes on.
enum class PathFate : std::uint8_t {
    ended = 0,    // it found a light, left the scene or did not survive roulette
    goes_on = 1,  // with a new ray
    dropped = 2,  // it was sampled to a side where nothing is reflected: a sample of value 0
};
CTP_INLINE std::uint32_t goes_on(std::uint8_t fate) { return fate & 1u; }

}  // namespace ctpbench
