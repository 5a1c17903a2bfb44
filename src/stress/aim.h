// Where stress rays start and what they are aimed at. The target is rounded to float32, and the direction is
// the float32 difference to it, not normalised: t = 1 at the target.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "kernels/ray.h"
#include "scene/recipes/random.h"
#include "scene/scene.h"

namespace ctpbench {

// Ray number i has a stream of random numbers of its own; geometry uses other keys.
inline recipe::Random ray_random(std::uint64_t seed, std::uint32_t i) {
    return recipe::Random(seed ^ 0x7261797300000000u, i);
}

inline Ray ray_along(Vec3 origin, Vec3 direction) {
    return {origin, direction, std::numeric_limits<float>::infinity()};
}
inline Ray ray_towards(Vec3 origin, Vec3 target) { return ray_along(origin, target - origin); }

// Of unit length, by float64: the squares of tiny differences leave float32's range.
inline Vec3 direction_to(Vec3 origin, Vec3 target) {
    double d[3], squared = 0.0;
    for (int a = 0; a < 3; ++a) d[a] = double{target[a]} - double{origin[a]}, squared += d[a] * d[a];
    const double inverse = 1.0 / std::sqrt(squared);
    return {static_cast<float>(d[0] * inverse), static_cast<float>(d[1] * inverse),
            static_cast<float>(d[2] * inverse)};
}

// Uniform in the unit ball, but for its very center.
inline Vec3 in_ball(recipe::Random& random) {
    for (;;) {
        const float x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
        const float squared = x * x + y * y + z * z;
        if (squared > 1e-6f && squared <= 1.0f) return {x, y, z};
    }
}

// A unit vector at right angles to the unit vector n.
inline Vec3 beside(Vec3 n, recipe::Random& random) {
    for (;;) {
        const Vec3 side = cross(n, random.direction());
        if (length(side) > 0.1f) return normalize(side);
    }
}

enum class Aim { edges, vertices, insides, all };  // all: one of the three, by lot

// Of a triangle by lot: a + s (b - a) on an edge, a vertex, or a point inside, at least a twentieth from all
// edges.
inline Vec3 target_on(const Mesh& mesh, Aim aim, recipe::Random& random) {
    const auto at = random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
    const auto& t = mesh.triangles[at];
    const std::uint32_t k = random.below(3);
    const Vec3 a = mesh.positions[t[k]], b = mesh.positions[t[(k + 1) % 3]],
               c = mesh.positions[t[(k + 2) % 3]];
    if (aim == Aim::all) {
        constexpr Aim each[] = {Aim::edges, Aim::vertices, Aim::insides};
        aim = each[random.below(3)];
    }
    if (aim == Aim::vertices) return a;
    if (aim == Aim::edges) return a + random.unit() * (b - a);
    float u = random.unit(), v = random.unit();
    if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
    u = 0.05f + 0.85f * u, v = 0.05f + 0.85f * v;
    return a + u * (b - a) + v * (c - a);
}

}  // namespace ctpbench
