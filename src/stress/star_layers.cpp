// Closed meshes in layers, held by a larger neighbour, seen from afar or from their own surface.
#include <cmath>
#include <memory>

#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

constexpr float kStart = 0.3f;  // rays start within this distance of the center, inside all layers

// Rays from the middle at targets on `aimed_at`, which the scene's mesh contains.
StressWorkload from_the_middle(Mesh mesh, Mesh aimed_at, std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(std::move(mesh));
    w.ray = [aimed_at = std::make_shared<const Mesh>(std::move(aimed_at)), seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = kStart * in_ball(random);
        return ray_towards(origin, target_on(*aimed_at, Aim::all, random));
    };
    return w;
}

StressWorkload duplicates(std::uint64_t seed) {
    const Mesh star = star_mesh(3, 1.0f, {0, 0, 0}, 0.25f, seed);
    Mesh mesh = star;
    for (int copy = 1; copy < 8; ++copy) append(mesh, star);
    return from_the_middle(std::move(mesh), star, seed);
}

StressWorkload double_walls(std::uint64_t seed) {
    const Mesh inner = star_mesh(4, 1.0f, {0, 0, 0}, 0.0f, seed);
    Mesh mesh = inner;
    append(mesh, star_mesh(4, 1.0f + 0x1p-14f, {0, 0, 0}, 0.0f, seed));
    return from_the_middle(std::move(mesh), inner, seed);
}

StressWorkload mixed_scales(std::uint64_t seed) {
    const Mesh star = star_mesh(2, 1.0f, {0, 0, 0}, 0.25f, seed);
    Mesh mesh = star;
    Mesh far_floor = floor_mesh(1, 1e6f);
    for (Vec3& p : far_floor.positions) p.z -= 3.0f;
    append(mesh, far_floor);
    return from_the_middle(std::move(mesh), star, seed);
}

// From 10 to 1e4 away at points well inside the outline: hits of either side of the mesh.
StressWorkload from_afar(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(star_mesh(4, 1.0f, {0, 0, 0}, 0.1f, seed));
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 from = random.direction();
        const float distance = std::pow(10.0f, random.between(1.0f, 4.0f));
        return ray_towards(distance * from, 0.6f * in_ball(random));
    };
    return w;
}

// From points of the surface, rounded, to either side: a hit at t = 0 may be found or not, what comes after
// it must be.
StressWorkload from_surface(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(star_mesh(4, 1.0f, {0, 0, 0}, 0.25f, seed));
    w.ray = [mesh = std::make_shared<const Mesh>(w.scene.mesh), seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = target_on(*mesh, Aim::all, random);
        return ray_along(origin, random.direction());
    };
    return w;
}

}  // namespace

std::vector<StressInfo> star_layer_workloads() {
    return {
        {"duplicates", "eight copies of every triangle, all at the same t: one must be reported",
         kOfTriangles, duplicates},
        {"double_walls", "two walls 2^-14 apart: what slips through the first, or culls it, hits the second",
         kOfTriangles, double_walls},
        {"mixed_scales", "a unit mesh above a floor of side 1e6, which makes boxes' padding large",
         kOfTriangles, mixed_scales},
        {"from_afar", "a unit mesh from up to 1e4 away: its size is all that is left of the coordinates",
         kOfTriangles, from_afar},
        {"from_surface", "rays that start on the mesh: the sign of t is rounding", kOfTriangles,
         from_surface},
    };
}

}  // namespace ctpbench
