// Moeller & Trumbore's test (methods/triangle_moeller_trumbore.h) in float64. Vertices are stored in float32
// and promoted here, so a triangle takes no more memory; differences of promoted vertices are all but exact.
//
// Products of float32 numbers are exact in float64, so a ray at a shared edge, which passes beside it by some
// ulps of float32, is not lost. What is left is what is exactly 0: a ray that meets a vertex in all digits
// may be lost there, and for a ray in a triangle's plane, as along one of its edges, the determinant is
// nothing but rounding, and so is t. No bound on t holds at such angles, as it does for
// methods/triangle_watertight.h.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"
#include "../vec64.h"

namespace ctpbench {

struct MoellerTrumbore64 {
    static constexpr const char* name = "moeller_trumbore_f64";

    struct Shape {
        Vec3 a, b, c;
    };
    struct RaySetup {
        Vec3d origin, direction;
    };

    CTP_INLINE static Shape shape(const TriangleShape& t) { return {t.a, t.b, t.c}; }
    CTP_INLINE static RaySetup setup(const Ray& ray) { return {promote(ray.origin), promote(ray.direction)}; }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& ray, Hit& hit) {
        const Vec3d a = promote(s.a);
        const Vec3d e1 = promote(s.b) - a, e2 = promote(s.c) - a;
        const Vec3d p = cross(ray.direction, e2);
        const double det = dot(e1, p);
        if (det == 0.0) return;
        const double inv = 1.0 / det;
        const Vec3d from_a = ray.origin - a;
        const double u = dot(from_a, p) * inv;
        if (!(u >= 0.0 && u <= 1.0)) return;
        const Vec3d q = cross(from_a, e1);
        const double v = dot(ray.direction, q) * inv;
        if (!(v >= 0.0 && u + v <= 1.0)) return;
        const auto t = static_cast<float>(dot(e2, q) * inv);
        if (hit.accepts(t, id)) hit = {t, id, static_cast<float>(u), static_cast<float>(v)};
    }
};

}  // namespace ctpbench
