// How Embree is handed the wavefront's rays: kernels for CpuBackend::for_each, each on the same columns as
// our own contenders. Nothing in a program without Embree.
#pragma once

#include <algorithm>
#include <cstdint>

#include "kernels/intersect.h"
#include "oracle/embree_api.h"

#ifdef CTPBENCH_EMBREE

namespace ctpbench {

// What all of them need.
struct EmbreeTask {
    RTCScene scene;
    IntersectBuffers io;
    std::uint32_t first_sphere;
    bool coherent;
};

// Of those that hit geometry 1, the spheres. Embree leaves what it was given where a ray hits nothing, so
// that everything else is as it should be: tmax, no primitive, 0 and 0.
inline void number_spheres(std::uint32_t count, const unsigned* geometry, std::uint32_t* primitive, float* u,
                           float* v, std::uint32_t first_sphere) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool sphere = geometry[i] == 1;
        primitive[i] += sphere ? first_sphere : 0;
        u[i] = sphere ? 0.0f : u[i], v[i] = sphere ? 0.0f : v[i];
    }
}

// Whether the slots of `count` > 0 entries are consecutive: their rays then lie side by side in every column.
inline bool consecutive(const std::uint32_t* index, std::uint32_t count) {
    std::uint32_t breaks = 0;
    for (std::uint32_t i = 0; i < count; ++i) breaks |= index[i] ^ (index[0] + i);
    return breaks == 0;
}

// rtcIntersect1; call i traces the i-th ray.
struct EmbreeOneKernel : EmbreeTask {
    static constexpr std::uint32_t rays = 1;

    void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Ray ray = io.rays.load(slot);
        RTCRayHit rh;
        rh.ray.org_x = ray.origin.x, rh.ray.org_y = ray.origin.y, rh.ray.org_z = ray.origin.z;
        rh.ray.dir_x = ray.direction.x, rh.ray.dir_y = ray.direction.y, rh.ray.dir_z = ray.direction.z;
        rh.ray.tnear = 0.0f, rh.ray.tfar = ray.tmax;
        rh.ray.time = 0.0f, rh.ray.mask = 0xffffffffu, rh.ray.id = 0, rh.ray.flags = 0;
        rh.hit.geomID = rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rh.hit.primID = kNoPrimitive, rh.hit.u = rh.hit.v = 0.0f;
        EmbreeQuery(false).intersect(scene, rh);
        number_spheres(1, &rh.hit.geomID, &rh.hit.primID, &rh.hit.u, &rh.hit.v, first_sphere);
        io.hits.store(slot, {rh.ray.tfar, rh.hit.primID, rh.hit.u, rh.hit.v});
    }
};

// rtcIntersect16; call p traces the p-th sixteen rays. Lanes beyond the last ray repeat it and are not valid,
// so that nothing in them slows the others down.
struct EmbreePacketKernel : EmbreeTask {
    static constexpr std::uint32_t rays = 16;

    void operator()(std::uint32_t p) const {
        const std::uint32_t begin = rays * p, count = std::min(rays, io.count - begin);
        const bool whole = count == rays && consecutive(io.index + begin, rays);
        alignas(64) std::uint32_t slots[rays];
        alignas(64) int valid[rays];
        for (std::uint32_t k = 0; k < rays; ++k) {
            slots[k] = io.index[begin + std::min(k, count - 1)];
            valid[k] = k < count ? -1 : 0;
        }
        RTCRayHit16 rh;
        const auto gather = [&](const float* column, float* lanes) {
            if (whole)
                std::copy_n(column + slots[0], rays, lanes);
            else
                for (std::uint32_t k = 0; k < rays; ++k) lanes[k] = column[slots[k]];
        };
        gather(io.rays.ox, rh.ray.org_x), gather(io.rays.oy, rh.ray.org_y), gather(io.rays.oz, rh.ray.org_z);
        gather(io.rays.dx, rh.ray.dir_x), gather(io.rays.dy, rh.ray.dir_y), gather(io.rays.dz, rh.ray.dir_z);
        gather(io.rays.tmax, rh.ray.tfar);
        std::fill_n(rh.ray.tnear, rays, 0.0f), std::fill_n(rh.ray.time, rays, 0.0f);
        std::fill_n(rh.ray.mask, rays, 0xffffffffu);
        std::fill_n(rh.ray.id, rays, 0u), std::fill_n(rh.ray.flags, rays, 0u);
        std::fill_n(rh.hit.geomID, rays, RTC_INVALID_GEOMETRY_ID);
        std::fill_n(rh.hit.instID[0], rays, RTC_INVALID_GEOMETRY_ID);
        std::fill_n(rh.hit.primID, rays, kNoPrimitive);
        std::fill_n(rh.hit.u, rays, 0.0f), std::fill_n(rh.hit.v, rays, 0.0f);
        EmbreeQuery(coherent).intersect(scene, valid, rh);
        number_spheres(rays, rh.hit.geomID, rh.hit.primID, rh.hit.u, rh.hit.v, first_sphere);
        const auto scatter = [&](const auto* lanes, auto* column) {
            if (whole)
                std::copy_n(lanes, rays, column + slots[0]);
            else
                for (std::uint32_t k = 0; k < count; ++k) column[slots[k]] = lanes[k];
        };
        scatter(rh.ray.tfar, io.hits.t), scatter(rh.hit.primID, io.hits.primitive);
        scatter(rh.hit.u, io.hits.u), scatter(rh.hit.v, io.hits.v);
    }
};

#if CTPBENCH_EMBREE == 3

// rtcIntersectNp; call s traces the s-th stream of rays. Consecutive rays are read and their hits written
// where they are; others are gathered and scattered.
struct EmbreeStreamKernel : EmbreeTask {
    static constexpr std::uint32_t rays = 1024;
    static constexpr std::uint32_t aligned = 4;  // Embree asks for columns at multiples of 16 bytes

    void operator()(std::uint32_t s) const {
        const std::uint32_t begin = rays * s, count = std::min(rays, io.count - begin);
        const std::uint32_t* index = io.index + begin;
        if (index[0] % aligned == 0 && consecutive(index, count)) {
            const std::uint32_t at = index[0];
            const RayColumns& r = io.rays;
            const HitColumns& h = io.hits;
            trace({r.ox + at, r.oy + at, r.oz + at, r.dx + at, r.dy + at, r.dz + at, r.tmax + at},
                  {h.t + at, h.primitive + at, h.u + at, h.v + at}, count);
            return;
        }
        alignas(64) float columns[10][rays];
        alignas(64) std::uint32_t primitive[rays];
        const RayColumns gathered{columns[0], columns[1], columns[2], columns[3],
                                  columns[4], columns[5], columns[6]};
        const HitColumns found{columns[7], primitive, columns[8], columns[9]};
        for (std::uint32_t i = 0; i < count; ++i) gathered.store(i, io.rays.load(index[i]));
        trace(gathered, found, count);
        for (std::uint32_t i = 0; i < count; ++i) io.hits.store(index[i], found.load(i));
    }

private:
    // Embree takes null for tnear, time and masks that are the same for all rays, and for normals not asked
    // for.
    void trace(const RayColumns& r, const HitColumns& h, std::uint32_t count) const {
        alignas(64) unsigned geometry[rays];
        std::fill_n(geometry, count, RTC_INVALID_GEOMETRY_ID);
        std::copy_n(r.tmax, count, h.t);
        std::fill_n(h.primitive, count, kNoPrimitive);
        std::fill_n(h.u, count, 0.0f), std::fill_n(h.v, count, 0.0f);
        RTCRayHitNp stream{};
        stream.ray.org_x = r.ox, stream.ray.org_y = r.oy, stream.ray.org_z = r.oz;
        stream.ray.dir_x = r.dx, stream.ray.dir_y = r.dy, stream.ray.dir_z = r.dz;
        stream.ray.tfar = h.t;
        stream.hit.primID = h.primitive, stream.hit.u = h.u, stream.hit.v = h.v;
        stream.hit.geomID = geometry;
        EmbreeQuery(coherent).intersect(scene, stream, count);
        number_spheres(count, geometry, h.primitive, h.u, h.v, first_sphere);
    }
};

#endif

}  // namespace ctpbench

#endif
