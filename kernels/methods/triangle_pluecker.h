// The side on which a ray passes each edge decides, from Pluecker coordinates about the ray's origin: Kay's
// signed volumes as in Davidovic, Engelhardt, Georgiev, Slusallek & Dachsbacher, "3D Rasterization: A Bridge
// between Rasterization and Ray Casting", Graphics Interface 2012, in the form that Embree made known, with
// an edge's sum and difference. Taken about the origin the coordinates stay small wherever the scene lies.
//
// Two triangles compute the very same number for an edge that they share, but for its sign, so no ray passes
// between them there. Numbers of different edges are not consistent where they meet: at a vertex all
// triangles of a fan may refuse the ray.
#pragma once

#include "../primitives/shapes.h"
#include "../ray.h"

namespace ctpbench {

struct Pluecker {
    static constexpr const char* name = "pluecker";

    struct Shape {
        Vec3 a, b, c;
    };
    struct RaySetup {
        Vec3 origin, direction;
    };

    CTP_INLINE static Shape shape(const TriangleShape& t) { return {t.a, t.b, t.c}; }
    CTP_INLINE static RaySetup setup(const Ray& ray) { return {ray.origin, ray.direction}; }

    CTP_INLINE static void intersect(const Shape& s, std::uint32_t id, const RaySetup& ray, Hit& hit) {
        const Vec3 d = ray.direction;
        const Vec3 a = s.a - ray.origin, b = s.b - ray.origin, c = s.c - ray.origin;
        const Vec3 ab = b - a, bc = c - b, ca = a - c;
        // Each 12 times a signed volume: the weights of a, b and c times their sum.
        const float u = dot(cross(b + c, bc), d);
        const float v = dot(cross(c + a, ca), d);
        const float w = dot(cross(a + b, ab), d);
        if (min(min(u, v), w) < 0.0f && max(max(u, v), w) > 0.0f) return;
        const float sum = (u + v) + w;
        const Vec3 normal = cross(ab, bc);
        const float slope = dot(normal, d);
        if (sum == 0.0f || slope == 0.0f) return;
        const float t = dot(normal, a) / slope;
        if (!hit.accepts(t, id)) return;
        const float inv = 1.0f / sum;
        hit = {t, id, v * inv, w * inv};
    }
};

}  // namespace ctpbench
