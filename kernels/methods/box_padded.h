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

    // Where the ray crosses the near and the far planes of one box, or of a pack of them.
    template <class F>
    struct Crossings {
        F nx, ny, nz, fx, fy, fz;

        // Where it enters, rounded down, and where it leaves, at most tmax. It meets the box if it enters
        // first.
        CTP_INLINE F near() const { return max(max(nx, ny), max(F(0.0f), nz)); }
        CTP_INLINE F far(F tmax) const { return min(min(fx, fy), min(fz, tmax)); }
    };
    // planes.near<axis>() and far<axis>(): of the axis' two planes, the one that the ray crosses first, and
    // the other one.
    template <class F, class Planes, class Setup>
    CTP_INLINE static Crossings<F> crossings(const Planes& planes, const Setup& r) {
        const F ix(r.ix), iy(r.iy), iz(r.iz);
        return {
            fma(planes.template near<0>(), ix, F(r.near_x)), fma(planes.template near<1>(), iy, F(r.near_y)),
            fma(planes.template near<2>(), iz, F(r.near_z)), fma(planes.template far<0>(), ix, F(r.far_x)),
            fma(planes.template far<1>(), iy, F(r.far_y)),   fma(planes.template far<2>(), iz, F(r.far_z))};
    }

    struct PlanesOfNode {
        const BvhNode& node;
        const RaySetup& ray;

        CTP_INLINE int offset(int axis) const {
            return axis == 0 ? ray.plane_x : axis == 1 ? ray.plane_y : ray.plane_z;
        }
        template <int axis>
        CTP_INLINE float near() const {
            return plane_of<axis>(node.bounds, offset(axis));
        }
        template <int axis>
        CTP_INLINE float far() const {
            return plane_of<axis>(node.bounds, 2 * axis + 3 - offset(axis));
        }
    };
    // Whether the ray can meet the box at or before tmax; `near` is where it enters, rounded down.
    CTP_INLINE static bool test(const BvhNode& node, const RaySetup& r, float tmax, float& near) {
        const auto c = crossings<float>(PlanesOfNode{node, r}, r);
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
        // Floats that are not negative compare like the integers that their bits are, and a negative one is
        // below all of them either way: that is all that matters here. Hopper compares three at a time.
        const int bits = __vimax3_s32_relu(__float_as_int(c.nx), __float_as_int(c.ny), __float_as_int(c.nz));
        near = __int_as_float(bits);
        return bits <= __vimin3_s32(__float_as_int(c.fx), __float_as_int(c.fy),
                                    ::min(__float_as_int(c.fz), __float_as_int(tmax)));
#else
        near = c.near();
        return near <= c.far(tmax);
#endif
    }
};

}  // namespace ctpbench
