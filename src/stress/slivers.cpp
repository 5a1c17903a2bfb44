// Shapes and angles that magnify rounding: needles, and rays that graze a surface.
#include <cmath>
#include <memory>

#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

// 64 sides 1e-3 wide and 10 long: 1e4 to 1. Rays start in the middle and are aimed at those.
StressWorkload needles(std::uint64_t seed) {
    constexpr int narrow = 64;
    StressWorkload w;
    w.scene = stress_scene(tube_mesh(narrow, 1e-3f, 10.0f));
    Mesh sides{w.scene.mesh.positions, {}, {}, {}};
    sides.triangles.assign(w.scene.mesh.triangles.begin(), w.scene.mesh.triangles.begin() + 2 * narrow);
    w.ray = [sides = std::make_shared<const Mesh>(std::move(sides)), seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = 0.5f * in_ball(random);
        return ray_towards(origin, target_on(*sides, Aim::all, random));
    };
    return w;
}

// At points inside the triangles of a flat tilted floor, from up to 4 away, at angles whose cosine to the
// normal is from 1e-4 to 1e-1.
StressWorkload grazing(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(floor_mesh(16, 8.0f));
    const TriangleShape t = w.scene.mesh.triangle(0);
    const Vec3 normal = normalize(cross(t.b - t.a, t.c - t.a));
    w.ray = [mesh = std::make_shared<const Mesh>(w.scene.mesh), normal, seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 target = target_on(*mesh, Aim::insides, random);
        const float cosine = std::pow(10.0f, random.between(-4.0f, -1.0f));
        const Vec3 along = beside(normal, random);
        const float side = random.below(2) == 0 ? 1.0f : -1.0f;
        const float distance = random.between(0.5f, 4.0f);
        return ray_towards(target + distance * (along + (side * cosine) * normal), target);
    };
    return w;
}

}  // namespace

std::vector<StressInfo> sliver_workloads() {
    return {
        {"needles", "rays inside a tube whose sides are needles of 1e4 to 1, at edges, vertices and insides",
         kOfTriangles, needles},
        {"grazing", "rays that meet a flat floor at cosines of 1e-4 to 1e-1: the error of t is magnified",
         kOfTriangles, grazing},
    };
}

}  // namespace ctpbench
