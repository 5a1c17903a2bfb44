// Where a ray hit, and the frame around it.
#pragma once

#include "primitives/geometry.h"
#include "ray.h"

namespace ctpbench {

struct Surface {
    Vec3 point;
    Vec3 normal;  // geometric, of unit length, on the side that the ray came from
};

// The point is taken from the primitive rather than from o + t d, whose rounding grows with t. The hit
// must be one.
CTP_INLINE Surface surface_at(const GeometryView& geometry, const Ray& ray, const Hit& hit) {
    Surface s;
    if (hit.primitive < geometry.first_sphere()) {
        const auto& corners = geometry.triangles[hit.primitive];
        const Vec3 a = geometry.positions[corners[0]];
        const Vec3 e1 = geometry.positions[corners[1]] - a, e2 = geometry.positions[corners[2]] - a;
        s.point = a + (hit.u * e1 + hit.v * e2);
        s.normal = normalize(cross(e1, e2));
    } else {
        const SphereShape sphere = geometry.spheres[hit.primitive - geometry.first_sphere()];
        s.normal = normalize(ray.origin + hit.t * ray.direction - sphere.center);
        s.point = sphere.center + sphere.radius * s.normal;
    }
    if (dot(s.normal, ray.direction) > 0.0f) s.normal = -s.normal;
    return s;
}

// x, y, z in an orthonormal frame about the unit vector n: Duff et al., "Building an Orthonormal Basis,
// Revisited", JCGT 6(1), 2017.
CTP_INLINE Vec3 in_frame_of(Vec3 n, float x, float y, float z) {
    const float sign = n.z < 0.0f ? -1.0f : 1.0f;
    const float a = -1.0f / (sign + n.z), b = n.x * n.y * a;
    const Vec3 tangent = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    const Vec3 bitangent = {b, sign + n.y * n.y * a, -n.y};
    return x * tangent + y * bitangent + z * n;
}

inline constexpr float kTwoPi = 6.28318530717959f;

// A direction about the unit normal n with density cos / pi (Malley's method). u1 and u2 are in [0, 1).
CTP_INLINE Vec3 cosine_direction(Vec3 n, float u1, float u2) {
    const float radius = std::sqrt(u1), phi = kTwoPi * u2;
    return in_frame_of(n, radius * std::cos(phi), radius * std::sin(phi), std::sqrt(max(0.0f, 1.0f - u1)));
}

// The direction at that angle to the unit vector n, turned about it by u of a full turn.
CTP_INLINE Vec3 direction_about(Vec3 n, float cosine, float u) {
    const float sine = std::sqrt(max(0.0f, 1.0f - cosine * cosine)), phi = kTwoPi * u;
    return in_frame_of(n, sine * std::cos(phi), sine * std::sin(phi), cosine);
}

}  // namespace ctpbench
