// The shade stage: matte surfaces under a constant ambient light, as the paper's renderer has them. A
// path that leaves the scene gathers the light and ends; one that hits continues in a cosine-distributed
// direction, from an origin moved off the surface.
#pragma once

#include "methods/offset_waechter_binder.h"
#include "rng.h"
#include "surface.h"
#include "wavefront.h"

namespace ctpbench {

// Albedo of a primitive: `material[triangle]` for triangles, one material for all spheres.
struct MaterialView {
    const Vec3* albedo;
    const std::uint32_t* material;
    std::uint32_t sphere_material;
};

struct ShadeKernel {
    GeometryView geometry;
    MaterialView materials;
    RayColumns rays;
    HitColumns hits;
    PixelColumns pixels;
    const std::uint32_t* index;
    std::uint64_t seed;
    std::uint32_t sample, bounce;
    float ambient;  // radiance that arrives from outside, every direction

    CTP_HD void operator()(std::uint32_t i) const {
        const std::uint32_t slot = index[i];
        const Hit hit = hits.load(slot);
        if (hit.primitive == kNoPrimitive) {
            pixels.radiance_r[slot] += pixels.throughput_r[slot] * ambient;
            pixels.radiance_g[slot] += pixels.throughput_g[slot] * ambient;
            pixels.radiance_b[slot] += pixels.throughput_b[slot] * ambient;
            return;
        }
        const Surface surface = surface_at(geometry, rays.load(slot), hit);
        const Vec3 albedo =
            materials.albedo[hit.primitive < geometry.first_sphere() ? materials.material[hit.primitive]
                                                                     : materials.sphere_material];
        pixels.throughput_r[slot] *= albedo.x;
        pixels.throughput_g[slot] *= albedo.y;
        pixels.throughput_b[slot] *= albedo.z;
        const Random4 r = random4(seed, slot, sample, bounce, Dimension::direction);
        rays.store(
            slot, {offset_origin(surface.point, surface.normal),
                   cosine_direction(surface.normal, r.v[0], r.v[1]), std::numeric_limits<float>::infinity()});
    }
};

}  // namespace ctpbench
