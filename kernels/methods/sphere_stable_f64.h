// The stable test of methods/sphere_stable.h in float64, on spheres stored in float32: what a planet needs,
// whose radius is millions of times the height above it. There every float32 form is wrong by more than the
// height's own digits.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"
#include "../vec64.h"

namespace ctpbench {

struct StableSphere64 {
    static constexpr const char* name = "stable_f64";

    struct Shape {
        Vec3 center;
        float radius;
    };
    struct RaySetup {
        Vec3d origin, direction;
        double dd;  // squared length of the direction
        double inv_dd;
    };

    CTP_INLINE static Shape shape(const SphereShape& s) { return {s.center, s.radius}; }
    CTP_INLINE static RaySetup setup(const Ray& ray) {
        const Vec3d d = promote(ray.direction);
        const double dd = dot(d, d);
        return {promote(ray.origin), d, dd, 1.0 / dd};
    }

    // A ray that starts inside hits the far side.
    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& ray, Hit& hit) {
        const Vec3d f = ray.origin - promote(s.center);
        const double b = -dot(f, ray.direction);
        const Vec3d perpendicular = f + (b * ray.inv_dd) * ray.direction;
        const double rr = double{s.radius} * double{s.radius};
        const double discriminant = rr - dot(perpendicular, perpendicular);
        if (!(discriminant >= 0.0)) return;
        const double root = std::sqrt(ray.dd * discriminant);
        const double q = b < 0.0 ? b - root : b + root;
        const double t0 = (dot(f, f) - rr) / q;
        const double t1 = q * ray.inv_dd;
        const double near = t0 < t1 ? t0 : t1, far = t0 < t1 ? t1 : t0;
        const auto t = static_cast<float>(near > 0.0 ? near : far);
        if (hit.accepts(t, id)) hit = {t, id, 0.0f, 0.0f};
    }
};

}  // namespace ctpbench
