// Baldwin & Weber, "Fast Ray-Triangle Intersections by Coordinate Transformation", JCGT 5(3), 2016: an affine
// map, made once per triangle, takes the ray to where the triangle is (0, 0), (1, 0), (0, 1). The third axis
// is that world axis which is nearest to the normal; so nine of the map's twelve numbers need be stored (the
// paper's BW9) and which axis it is.
//
// The map is set up in float64 and stored in float32. Its offsets are as large as the triangle is far from
// the world's origin in units of its own size: that is where small triangles far away lose their digits.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"
#include "../vec64.h"

namespace ctpbench {

struct BaldwinWeber {
    static constexpr const char* name = "baldwin_weber";

    // With k the axis, i and j the two after it in turn: height above the plane, along k, is
    // p[k] + height[0] p[i] + height[1] p[j] + height[2]; the weights of b and c are b[0] p[i] + b[1] p[j] +
    // b[2] and likewise, for points p in the plane.
    struct Shape {
        float height[3], b[3], c[3];
        std::uint32_t axis;
    };
    struct RaySetup {
        float origin[3], direction[3];
    };

    static Shape shape(const TriangleShape& t) {
        const Vec3d at = promote(t.a), e1 = promote(t.b) - at, e2 = promote(t.c) - at, n = cross(e1, e2);
        const double nx = std::fabs(n.x), ny = std::fabs(n.y), nz = std::fabs(n.z);
        if (nx > ny && nx > nz) return map(0, n.x, n.y, n.z, at.x, at.y, at.z, e1.y, e1.z, e2.y, e2.z);
        if (ny > nz) return map(1, n.y, n.z, n.x, at.y, at.z, at.x, e1.z, e1.x, e2.z, e2.x);
        return map(2, n.z, n.x, n.y, at.z, at.x, at.y, e1.x, e1.y, e2.x, e2.y);
    }
    CTP_INLINE static RaySetup setup(const Ray& ray) {
        return {{ray.origin.x, ray.origin.y, ray.origin.z},
                {ray.direction.x, ray.direction.y, ray.direction.z}};
    }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& ray, Hit& hit) {
        const int k = static_cast<int>(s.axis), i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        const float oi = element(ray.origin, i), oj = element(ray.origin, j);
        const float di = element(ray.direction, i), dj = element(ray.direction, j);
        const float above = element(ray.origin, k) + s.height[0] * oi + s.height[1] * oj + s.height[2];
        const float rise = element(ray.direction, k) + s.height[0] * di + s.height[1] * dj;
        const float t = -above / rise;
        if (!hit.accepts(t, id)) return;
        const float pi = oi + t * di, pj = oj + t * dj;
        const float u = s.b[0] * pi + s.b[1] * pj + s.b[2];
        const float v = s.c[0] * pi + s.c[1] * pj + s.c[2];
        // A triangle without an area has a map of NaN and infinities: it fails here.
        if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f) hit = {t, id, u, v};
    }

private:
    static Shape map(std::uint32_t axis, double nk, double ni, double nj, double ak, double ai, double aj,
                     double e1i, double e1j, double e2i, double e2j) {
        const auto f = [](double x) { return static_cast<float>(x); };
        return {{f(ni / nk), f(nj / nk), f(-(ak + (ai * ni + aj * nj) / nk))},
                {f(e2j / nk), f(-e2i / nk), f((aj * e2i - ai * e2j) / nk)},
                {f(-e1j / nk), f(e1i / nk), f((ai * e1j - aj * e1i) / nk)},
                axis};
    }
};

}  // namespace ctpbench
