// Haines, Guenther & Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing
// Gems ch. 7, 2019: the discriminant from the centre's distance to the ray, and the small root from the
// large one, so that neither a far nor a large sphere cancels its digits away.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"

namespace ctpbench {

struct StableSphere {
    static constexpr const char* name = "stable";

    struct Shape {
        Vec3 center;
        float radius;
    };
    struct RaySetup {
        Ray ray;
        float length;  // of the direction
        float inv_dd;  // 1 / length^2
    };

    CTP_INLINE static Shape shape(const SphereShape& s) { return {s.center, s.radius}; }
    CTP_INLINE static RaySetup setup(const Ray& ray) {
        const float dd = dot(ray.direction, ray.direction);
        return {ray, std::sqrt(dd), 1.0f / dd};
    }

    // Of one sphere, or of a pack of them; F is float or such a pack.
    template <class F>
    struct Quadratic {
        F b, ff_less_rr;  // half the linear coefficient, negated, and the constant one
        F discriminant;   // negative: the ray's line misses
    };
    // Setup: RaySetup, or one whose floats are a packet's.
    template <class F, class Setup>
    CTP_INLINE static Quadratic<F> quadratic(F cx, F cy, F cz, F radius, const Setup& setup) {
        const auto& o = setup.ray.origin;
        const auto& d = setup.ray.direction;
        const F dx(d.x), dy(d.y), dz(d.z);
        const F fx = F(o.x) - cx, fy = F(o.y) - cy, fz = F(o.z) - cz;
        const F b = -(fx * dx + fy * dy + fz * dz);
        const F along = b * F(setup.inv_dd);
        const F px = fx + along * dx, py = fy + along * dy, pz = fz + along * dz;
        const F rr = radius * radius;
        return {b, (fx * fx + fy * fy + fz * fz) - rr, rr - (px * px + py * py + pz * pz)};
    }
    // The smaller positive root, where the discriminant is not negative. A ray that starts inside hits the
    // far side.
    template <class F, class Setup>
    CTP_INLINE static F t_of(const Quadratic<F>& e, const Setup& setup) {
        // Not the root of length^2 times the discriminant: that underflows in small scenes.
        const F root = F(setup.length) * square_root(e.discriminant);
        const F q = select(e.b < F(0.0f), e.b - root, e.b + root);
        const F t1 = q * F(setup.inv_dd);  // the root that is larger in magnitude
        // Where the ray starts on the sphere and grazes it, numerator and q are both rounding: without the
        // bound that t1 gives, the point reported would lie tens of ulps off the sphere.
        const F t0 = min(max(e.ff_less_rr / q, -absolute(t1)), absolute(t1));
        const F near = min(t0, t1);
        return select(F(0.0f) < near, near, max(t0, t1));
    }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& setup, Hit& hit) {
        const auto e = quadratic<float>(s.center.x, s.center.y, s.center.z, s.radius, setup);
        if (e.discriminant < 0.0f) return;
        const float t = t_of(e, setup);
        if (hit.accepts(t, id)) hit = {t, id, 0.0f, 0.0f};
    }
};

}  // namespace ctpbench
