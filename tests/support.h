// Small scenes and rays that several tests share. Random numbers are seeded, so every run is the same.
#pragma once

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "kernels/ray.h"
#include "scene/scene.h"

namespace ctpbench::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    float uniform(float lo, float hi) {
        return lo + (hi - lo) * static_cast<float>(engine_() >> 40) * 0x1p-24f;
    }
    Vec3 point(float lo, float hi) { return {uniform(lo, hi), uniform(lo, hi), uniform(lo, hi)}; }
    Vec3 direction() {
        while (true) {
            const Vec3 d = point(-1.0f, 1.0f);
            const float l = length(d);
            if (l > 0.1f && l <= 1.0f) return d * (1.0f / l);
        }
    }

private:
    std::mt19937_64 engine_;
};

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A closed star-shaped mesh about `center`: an octahedron, subdivided, with radii that vary by the share
// `roughness`; with none it is convex.
inline Mesh star(int subdivisions, float radius, Vec3 center, std::uint64_t seed, float roughness = 0.25f) {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int s = 0; s < subdivisions; ++s) {
        std::vector<std::array<std::uint32_t, 3>> finer;
        std::vector<std::pair<std::uint64_t, std::uint32_t>> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
            for (const auto& [k, v] : middles)
                if (k == key) return v;
            mesh.positions.push_back(normalize(mesh.positions[a] + mesh.positions[b]));
            middles.emplace_back(key, static_cast<std::uint32_t>(mesh.positions.size() - 1));
            return middles.back().second;
        };
        for (const auto& t : mesh.triangles) {
            const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
            finer.push_back({t[0], ab, ca});
            finer.push_back({ab, t[1], bc});
            finer.push_back({ca, bc, t[2]});
            finer.push_back({ab, bc, ca});
        }
        mesh.triangles = finer;
    }
    Random random(seed);
    for (Vec3& p : mesh.positions) p = center + p * (radius * random.uniform(1.0f - roughness, 1.0f));
    mesh.material.assign(mesh.triangles.size(), 0);
    return mesh;
}

// Triangles of very different sizes, among them needles that spatial splits cut up, and spheres.
inline Scene soup(std::uint32_t triangles, std::uint32_t spheres, std::uint64_t seed, float scale = 1.0f,
                  Vec3 offset = {0, 0, 0}) {
    Scene scene;
    scene.name = "soup";
    scene.materials.push_back({});
    Random random(seed);
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const Vec3 at = random.point(-1.0f, 1.0f);
        const float size = i % 7 == 0 ? 1.0f : i % 3 == 0 ? 0.3f : 0.05f;
        Vec3 corners[3] = {at, at + size * random.point(-1.0f, 1.0f), at + size * random.point(-1.0f, 1.0f)};
        if (i % 5 == 0) corners[2] = corners[1] + 0.01f * random.point(-1.0f, 1.0f);
        for (const Vec3& c : corners) scene.mesh.positions.push_back(offset + scale * c);
        scene.mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        scene.mesh.material.push_back(0);
    }
    for (std::uint32_t i = 0; i < spheres; ++i)
        scene.spheres.push_back(
            {offset + scale * random.point(-1.0f, 1.0f), scale * random.uniform(0.01f, 0.15f)});
    return scene;
}

}  // namespace ctpbench::test
