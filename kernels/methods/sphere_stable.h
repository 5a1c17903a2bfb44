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

    // A ray that starts inside hits the far side.
    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& setup, Hit& hit) {
        const Vec3 d = setup.ray.direction;
        const Vec3 f = setup.ray.origin - s.center;
        const float b = -dot(f, d);
        const Vec3 perpendicular = f + (b * setup.inv_dd) * d;
        const float rr = s.radius * s.radius;
        const float discriminant = rr - dot(perpendicular, perpendicular);
        if (discriminant < 0.0f) return;
        // Not the root of length^2 times the discriminant: that underflows in small scenes.
        const float root = setup.length * std::sqrt(discriminant);
        const float q = b < 0.0f ? b - root : b + root;
        const float t1 = q * setup.inv_dd;  // the root that is larger in magnitude
        // Where the ray starts on the sphere and grazes it, numerator and q are both rounding: without the
        // bound that t1 gives, the point reported would lie tens of ulps off the sphere.
        const float t0 = min(max((dot(f, f) - rr) / q, -absolute(t1)), absolute(t1));
        const float near = min(t0, t1);
        const float t = near > 0.0f ? near : max(t0, t1);
        if (hit.accepts(t, id)) hit = {t, id, 0.0f, 0.0f};
    }
};

}  // namespace ctpbench
