// The slab test as most renderers write it, without allowance for rounding: Williams et al., "An
// Efficient and Robust Ray-Box Intersection Algorithm", J. Graph. Tools 10(1), 2005. It can miss a box
// whose edge the ray touches; where a ray lies in a box's plane, a NaN decides, and processors differ in how.
#pragma once

#include "../bvh.h"
#include "../ray.h"

namespace ctpbench {

struct PlainBox {
    static constexpr const char* name = "plain";

    struct RaySetup {
        Vec3 origin;
        Vec3 inv;
    };

    CTP_INLINE static RaySetup setup(const Ray& ray, float /*extent*/) {
        const Vec3 d = ray.direction;
        return {ray.origin, {1.0f / d.x, 1.0f / d.y, 1.0f / d.z}};
    }

    CTP_INLINE static bool test(const BvhNode& node, const RaySetup& r, float tmax, float& near) {
        const Vec3 t0 = (Vec3{node.bounds[0], node.bounds[1], node.bounds[2]} - r.origin) * r.inv;
        const Vec3 t1 = (Vec3{node.bounds[3], node.bounds[4], node.bounds[5]} - r.origin) * r.inv;
        const Vec3 lo = min(t0, t1), hi = max(t0, t1);
        near = max(max(lo.x, lo.y), max(lo.z, 0.0f));
        return near <= min(min(hi.x, hi.y), min(hi.z, tmax));
    }
};

}  // namespace ctpbench
