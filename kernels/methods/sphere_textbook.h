// The quadratic formula as textbooks have it, in float32: the first root, or the second for a ray that starts
// inside. In b^2 - 4ac both terms grow with the square of the distance while their difference does not: from
// some hundred radii away the sphere's outline frays, and from some thousand its rays hit and miss at random.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"

namespace ctpbench {

struct TextbookSphere {
    static constexpr const char* name = "textbook";

    struct Shape {
        Vec3 center;
        float radius;
    };
    struct RaySetup {
        Ray ray;
        float a;  // squared length of the direction
        float inv_2a;
    };

    CTP_INLINE static Shape shape(const SphereShape& s) { return {s.center, s.radius}; }
    CTP_INLINE static RaySetup setup(const Ray& ray) {
        const float a = dot(ray.direction, ray.direction);
        return {ray, a, 0.5f / a};
    }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& setup, Hit& hit) {
        const Vec3 f = setup.ray.origin - s.center;
        const float b = 2.0f * dot(f, setup.ray.direction);
        const float c = dot(f, f) - s.radius * s.radius;
        const float discriminant = b * b - 4.0f * setup.a * c;
        if (!(discriminant >= 0.0f)) return;
        const float root = std::sqrt(discriminant);
        const float near = (-b - root) * setup.inv_2a;
        const float t = near > 0.0f ? near : (-b + root) * setup.inv_2a;
        if (hit.accepts(t, id)) hit = {t, id, 0.0f, 0.0f};
    }
};

}  // namespace ctpbench
