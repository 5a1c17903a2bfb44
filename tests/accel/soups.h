// Small generated scenes that are hard on a tree builder.
#pragma once

#include <cstddef>
#include <cstdint>

#include "support.h"

namespace ctpbench::test {

inline void add_triangle(Scene& scene, Vec3 a, Vec3 b, Vec3 c) {
    const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
    for (const Vec3& v : {a, b, c}) scene.mesh.positions.push_back(v);
    scene.mesh.triangles.push_back({first, first + 1, first + 2});
    scene.mesh.material.push_back(0);
}

// One triangle in eight is a long needle, the others are small and lie among them: most needles are split,
// and often.
inline Scene needles(std::size_t count, Vec3 center, float scale, std::uint32_t seed) {
    Scene scene;
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 a = random.point(-1, 1);
        const Vec3 b = i % 8 == 0 ? random.point(-1, 1) : a + random.point(-0.03f, 0.03f);
        const Vec3 c = a + (b - a) * random.uniform(0, 1) + random.point(-0.03f, 0.03f);
        add_triangle(scene, center + scale * a, center + scale * b, center + scale * c);
    }
    return scene;
}

inline void add_spheres(Scene& scene, std::size_t count, Vec3 center, float scale, float radius,
                        std::uint32_t seed) {
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 c = center + scale * random.point(-1, 1);
        scene.spheres.push_back({c, scale * radius * random.uniform(0.5f, 1.5f)});
    }
}

}  // namespace ctpbench::test
