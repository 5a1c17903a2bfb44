// Slab test that never misses a primitive's hit, for use with methods/triangle_watertight.h.
//
// Every slab is widened by 2^-19 (max |o| + extent), extent being the scene's largest |coordinate|. That
// covers three errors, together at most three quarters of it: this test's own rounding (compare Ize, "Robust
// BVH Ray Traversal", JCGT 2(2), 2013), the lateral distance between the ray and the point that a primitive's
// test reports, and the rounding of its t. A node that holds the reported point is therefore entered at or
// before t, so two trees over the same primitives keep the same closest hit. The padding is per ray, which
// makes the test cost one fused multiply-add per plane, like the plain one.
#pragma once

#include "../bvh.h"
#include "../ray.h"

namespace ctpbench {

struct PaddedBox {
    static constexpr const char* name = "padded";

    struct RaySetup {
        float ix, iy, iz;  // reciprocal direction, finite
        float near_x, near_y, near_z;
        float far_x, far_y, far_z;
        int plane_x, plane_y, plane_z;  // offset of the near plane in BvhNode::bounds
    };

    // A component below 2^-40 of the largest moves a ray by less than the padding over any length in
    // the scene: raising it to that keeps the reciprocal finite and the products free of NaN.
    CTP_INLINE static float reciprocal(float d, float largest) {
        const float least = largest * 0x1p-40f;
        return 1.0f / (absolute(d) < least ? least : d);
    }

    CTP_INLINE static RaySetup setup(const Ray& ray, float extent) {
        const Vec3 o = ray.origin, d = ray.direction;
        const float largest = max(max(absolute(d.x), absolute(d.y)), absolute(d.z));
        const float pad = 0x1p-19f * (max(max(absolute(o.x), absolute(o.y)), absolute(o.z)) + extent);
        const Vec3 inv = {reciprocal(d.x, largest), reciprocal(d.y, largest), reciprocal(d.z, largest)};
        const Vec3 oi = o * inv;
        const Vec3 p = {pad * absolute(inv.x), pad * absolute(inv.y), pad * absolute(inv.z)};
        return {inv.x,
                inv.y,
                inv.z,  //
                -(oi.x + p.x),
                -(oi.y + p.y),
                -(oi.z + p.z),  //
                -(oi.x - p.x),
                -(oi.y - p.y),
                -(oi.z - p.z),  //
                inv.x < 0.0f ? 3 : 0,
                inv.y < 0.0f ? 4 : 1,
                inv.z < 0.0f ? 5 : 2};
    }

    // Whether the ray can meet the box at or before tmax; `near` is where it enters, rounded down.
    CTP_INLINE static bool test(const BvhNode& node, const RaySetup& r, float tmax, float& near) {
        const auto& b = node.bounds;
        const float nx = fma(plane_of<0>(b, r.plane_x), r.ix, r.near_x);
        const float ny = fma(plane_of<1>(b, r.plane_y), r.iy, r.near_y);
        const float nz = fma(plane_of<2>(b, r.plane_z), r.iz, r.near_z);
        const float fx = fma(plane_of<0>(b, 3 - r.plane_x), r.ix, r.far_x);
        const float fy = fma(plane_of<1>(b, 5 - r.plane_y), r.iy, r.far_y);
        const float fz = fma(plane_of<2>(b, 7 - r.plane_z), r.iz, r.far_z);
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
        // Floats that are not negative compare like the integers that their bits are, and a negative one is
        // below all of them either way: that is all that matters here. Hopper compares three at a time.
        const int bits = __vimax3_s32_relu(__float_as_int(nx), __float_as_int(ny), __float_as_int(nz));
        near = __int_as_float(bits);
        return bits <= __vimin3_s32(__float_as_int(fx), __float_as_int(fy),
                                    ::min(__float_as_int(fz), __float_as_int(tmax)));
#else
        near = max(max(nx, ny), max(0.0f, nz));
        return near <= min(min(fx, fy), min(fz, tmax));
#endif
    }
};

}  // namespace ctpbench
