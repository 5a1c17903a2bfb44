// Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", J. Graph. Tools 2(1), 1997:
// the test that the paper uses. Not watertight: a ray through a shared edge can miss both triangles.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"

namespace ctpbench {

struct MoellerTrumbore {
    static constexpr const char* name = "moeller_trumbore";

    struct Shape {
        Vec3 a, e1, e2;
    };
    struct RaySetup {
        Ray ray;
    };

    CTP_INLINE static Shape shape(const TriangleShape& t) { return {t.a, t.b - t.a, t.c - t.a}; }
    CTP_INLINE static RaySetup setup(const Ray& ray) { return {ray}; }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& setup, Hit& hit) {
        const Vec3 d = setup.ray.direction;
        const Vec3 p = cross(d, s.e2);
        const float det = dot(s.e1, p);
        if (det == 0.0f) return;
        const float inv = 1.0f / det;
        const Vec3 from_a = setup.ray.origin - s.a;
        const float u = dot(from_a, p) * inv;
        if (!(u >= 0.0f && u <= 1.0f)) return;
        const Vec3 q = cross(from_a, s.e1);
        const float v = dot(d, q) * inv;
        if (!(v >= 0.0f && u + v <= 1.0f)) return;
        const float t = dot(s.e2, q) * inv;
        if (hit.accepts(t, id)) hit = {t, id, u, v};
    }
};

}  // namespace ctpbench
