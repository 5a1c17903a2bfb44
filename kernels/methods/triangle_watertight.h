// Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, with the edge functions
// evaluated as Kahan's difference of products. Their signs are then exact for the sheared vertices, so
// that the paper's float64 fallback is not needed.
//
// The point U A + V B + W C lies on the triangle and within a few ulps of the largest coordinate of the ray,
// whatever the angle between them, and the reported t is as near to it. The box test's padding covers that
// distance: together they make hits independent of the tree (methods/box_padded.h).
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"

namespace ctpbench {

// a b - c d with an error below 1.5 ulp (Jeannerod, Louvet & Muller 2013).
CTP_INLINE float difference_of_products(float a, float b, float c, float d) {
    const float w = c * d;
    return fma(a, b, -w) + fma(-c, d, w);
}

struct WatertightTriangle {
    static constexpr const char* name = "woop";

    struct Shape {
        float vertex[3][3];
    };
    // The axis of the direction's largest component becomes z; the shear maps the ray to (0, 0, 1).
    struct RaySetup {
        int kx, ky, kz;
        float ox, oy, oz;
        float sx, sy, sz;
    };

    CTP_INLINE static Shape shape(const TriangleShape& t) {
        return {{{t.a.x, t.a.y, t.a.z}, {t.b.x, t.b.y, t.b.z}, {t.c.x, t.c.y, t.c.z}}};
    }

    CTP_INLINE static RaySetup setup(const Ray& ray) {
        const Vec3 o = ray.origin, d = ray.direction;
        const float ax = absolute(d.x), ay = absolute(d.y), az = absolute(d.z);
        const int kz = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
        const int kx = kz == 2 ? 0 : kz + 1;
        const int ky = kx == 2 ? 0 : kx + 1;
        const float r = 1.0f / d[kz];
        return {kx, ky, kz, o[kx], o[ky], o[kz], d[kx] * r, d[ky] * r, r};
    }

    // t from the triangle's plane, kept within [lo, hi]. The t of the barycentric weights is bounded at any
    // angle, but by the size of the triangle: on a large floor it exceeds the offset of a secondary ray's
    // origin, and its sign would say that the ray hits the floor it just left. The plane's t does not lose
    // the small distance to a plane along an axis, but is unbounded at grazing angles; so it decides where
    // the sign is in doubt, and only within that doubt.
    CTP_INLINE static float refined_t(const Shape& s, const RaySetup& r, float lo, float hi) {
        const float e1x = element(s.vertex[1], r.kx) - element(s.vertex[0], r.kx),
                    e2x = element(s.vertex[2], r.kx) - element(s.vertex[0], r.kx);
        const float e1y = element(s.vertex[1], r.ky) - element(s.vertex[0], r.ky),
                    e2y = element(s.vertex[2], r.ky) - element(s.vertex[0], r.ky);
        const float e1z = element(s.vertex[1], r.kz) - element(s.vertex[0], r.kz),
                    e2z = element(s.vertex[2], r.kz) - element(s.vertex[0], r.kz);
        const float nx = difference_of_products(e1y, e2z, e1z, e2y);
        const float ny = difference_of_products(e1z, e2x, e1x, e2z);
        const float nz = difference_of_products(e1x, e2y, e1y, e2x);
        const float distance =
            fma(nx, element(s.vertex[0], r.kx) - r.ox,
                fma(ny, element(s.vertex[0], r.ky) - r.oy, nz * (element(s.vertex[0], r.kz) - r.oz)));
        const float slope = fma(nx, r.sx, fma(ny, r.sy, nz));
        return min(max(distance * r.sz / slope, lo), hi);
    }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& r, Hit& hit) {
        const float az = element(s.vertex[0], r.kz) - r.oz;
        const float bz = element(s.vertex[1], r.kz) - r.oz;
        const float cz = element(s.vertex[2], r.kz) - r.oz;
        const float ax = fma(-r.sx, az, element(s.vertex[0], r.kx) - r.ox);
        const float ay = fma(-r.sy, az, element(s.vertex[0], r.ky) - r.oy);
        const float bx = fma(-r.sx, bz, element(s.vertex[1], r.kx) - r.ox);
        const float by = fma(-r.sy, bz, element(s.vertex[1], r.ky) - r.oy);
        const float cx = fma(-r.sx, cz, element(s.vertex[2], r.kx) - r.ox);
        const float cy = fma(-r.sy, cz, element(s.vertex[2], r.ky) - r.oy);
        const float u = difference_of_products(cx, by, cy, bx);
        const float v = difference_of_products(ax, cy, ay, cx);
        const float w = difference_of_products(bx, ay, by, ax);
        if (min(min(u, v), w) < 0.0f && max(max(u, v), w) > 0.0f) return;
        const float det = (u + v) + w;
        if (det == 0.0f) return;
        const float inv = 1.0f / det;
        float t = fma(u, az, fma(v, bz, w * cz)) * (r.sz * inv);
        const float error = 0x1p-21f * max(max(absolute(az), absolute(bz)), absolute(cz)) * absolute(r.sz);
        if (absolute(t) <= error) t = refined_t(s, r, t - error, t + error);
        if (hit.accepts(t, id)) hit = {t, id, v * inv, w * inv};
    }
};

}  // namespace ctpbench
