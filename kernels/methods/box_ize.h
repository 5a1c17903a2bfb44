// Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013: near and far planes are picked by the sign of the
// direction, and the far distance is made larger by two ulps, which covers the rounding of both. So no ray
// misses a box whose true slabs it enters.
//
// A component of the direction that is 0 has an infinite reciprocal; with the origin on a plane their product
// is NaN. It must not decide: each minimum and maximum has the plane's distance first and what is known
// second, and a NaN that comes first is dropped (by x86's instruction for the order, by a GPU's for being
// NaN). The box then counts as entered.
//
// It allows for this test's own rounding only, not for that of the primitive's (methods/box_padded.h).
#pragma once

#include "../bvh.h"
#include "../ray.h"

namespace ctpbench {

struct IzeBox {
    static constexpr const char* name = "ize";

    struct RaySetup {
        Vec3 origin;
        Vec3 inv;
        int plane_x, plane_y, plane_z;  // offset of the near plane in BvhNode::bounds
    };

    CTP_INLINE static RaySetup setup(const Ray& ray, float /*extent*/) {
        const Vec3 d = ray.direction;
        const Vec3 inv = {1.0f / d.x, 1.0f / d.y, 1.0f / d.z};
        return {ray.origin, inv, inv.x < 0.0f ? 3 : 0, inv.y < 0.0f ? 4 : 1, inv.z < 0.0f ? 5 : 2};
    }

    CTP_INLINE static bool test(const BvhNode& node, const RaySetup& r, float tmax, float& near) {
        const auto& b = node.bounds;
        const float nx = (plane_of<0>(b, r.plane_x) - r.origin.x) * r.inv.x;
        const float ny = (plane_of<1>(b, r.plane_y) - r.origin.y) * r.inv.y;
        const float nz = (plane_of<2>(b, r.plane_z) - r.origin.z) * r.inv.z;
        const float fx = (plane_of<0>(b, 3 - r.plane_x) - r.origin.x) * r.inv.x;
        const float fy = (plane_of<1>(b, 5 - r.plane_y) - r.origin.y) * r.inv.y;
        const float fz = (plane_of<2>(b, 7 - r.plane_z) - r.origin.z) * r.inv.z;
        near = max(nx, max(ny, max(nz, 0.0f)));
        return near <= min(fx, min(fy, min(fz, tmax))) * kTwoUlps;
    }

private:
    static constexpr float kTwoUlps = 1.0f + 0x1p-22f;
};

}  // namespace ctpbench
