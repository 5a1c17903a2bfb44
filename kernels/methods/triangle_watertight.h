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

// a b - c d with an error below 1.5 ulp (Jeannerod, Louvet & Muller 2013). F is float or a pack of them.
template <class F>
CTP_INLINE F difference_of_products(F a, F b, F c, F d) {
    const F w = c * d;
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
        const float o[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
        const float d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
        const float ax = absolute(d[0]), ay = absolute(d[1]), az = absolute(d[2]);
#if defined(__CUDA_ARCH__)
        const int kz = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
        const int kx = kz == 2 ? 0 : kz + 1;
        const int ky = kx == 2 ? 0 : kx + 1;
#else
        // By arithmetic: a processor could not predict which axis it is. A GPU selects, in fewer registers.
        const int x_over_y = ax > ay, not_z = max(ax, ay) > az;
        const int kz = 2 - not_z - (not_z & x_over_y);
        const int kx = 0b001001 >> 2 * kz & 3;  // the axis after it, and the one after that
        const int ky = 0b010010 >> 2 * kz & 3;
#endif
        const float r = 1.0f / element(d, kz);
        return {kx,
                ky,
                kz,
                element(o, kx),
                element(o, ky),
                element(o, kz),
                element(d, kx) * r,
                element(d, ky) * r,
                r};
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

    // Of one triangle, or of a pack of them.
    template <class F>
    struct Edges {
        F az, bz, cz;  // of the vertices, from the ray's origin
        F u, v, w;     // edge functions: the weights of a, b and c, times their sum
    };
    // vertices(i, axis): a coordinate of vertex i. Setup: RaySetup, or one whose floats are a packet's.
    template <class F, class Vertices, class Setup>
    CTP_INLINE static Edges<F> edges(const Vertices& vertices, const Setup& r) {
        Edges<F> e;
        const F sx(r.sx), sy(r.sy), ox(r.ox), oy(r.oy), oz(r.oz);
        e.az = vertices(0, r.kz) - oz;
        e.bz = vertices(1, r.kz) - oz;
        e.cz = vertices(2, r.kz) - oz;
        const F ax = fma(-sx, e.az, vertices(0, r.kx) - ox);
        const F ay = fma(-sy, e.az, vertices(0, r.ky) - oy);
        const F bx = fma(-sx, e.bz, vertices(1, r.kx) - ox);
        const F by = fma(-sy, e.bz, vertices(1, r.ky) - oy);
        const F cx = fma(-sx, e.cz, vertices(2, r.kx) - ox);
        const F cy = fma(-sy, e.cz, vertices(2, r.ky) - oy);
        e.u = difference_of_products(cx, by, cy, bx);
        e.v = difference_of_products(ax, cy, ay, cx);
        e.w = difference_of_products(bx, ay, by, ax);
        return e;
    }
    // The ray's t, given the reciprocal of the sum of the edge functions.
    template <class F, class Setup>
    CTP_INLINE static F t_of(const Edges<F>& e, F inv, const Setup& r) {
        return fma(e.u, e.az, fma(e.v, e.bz, e.w * e.cz)) * (F(r.sz) * inv);
    }
    // Up to where the sign of t is in doubt, see refined_t().
    template <class F, class Setup>
    CTP_INLINE static F doubt(const Edges<F>& e, const Setup& r) {
        return F(0x1p-21f) * max(max(absolute(e.az), absolute(e.bz)), absolute(e.cz)) * F(absolute(r.sz));
    }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& r, Hit& hit) {
        const auto e = edges<float>([&](int i, int axis) { return element(s.vertex[i], axis); }, r);
        if (min(min(e.u, e.v), e.w) < 0.0f && max(max(e.u, e.v), e.w) > 0.0f) return;
        const float det = (e.u + e.v) + e.w;
        if (det == 0.0f) return;
        const float inv = 1.0f / det;
        float t = t_of(e, inv, r);
        const float error = doubt(e, r);
        if (absolute(t) <= error) t = refined_t(s, r, t - error, t + error);
        if (hit.accepts(t, id)) hit = {t, id, e.v * inv, e.w * inv};
    }
};

}  // namespace ctpbench
