// Primitives that a tree cannot tell apart, or only by going very deep.
#include <cmath>

#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

// Triangles of all sizes with one centroid (exactly: c = -(a + b) of multiples of 2^-12), and concentric
// spheres.
StressWorkload coincident_centroids(std::uint64_t seed) {
    Mesh mesh;
    recipe::Random random(seed, 2);
    std::vector<SphereShape> spheres;
    for (std::uint32_t i = 0; i < 500; ++i) {
        const auto snap = [&](Vec3 p) {
            return Vec3{std::floor(p.x * 4096.0f) / 4096.0f, std::floor(p.y * 4096.0f) / 4096.0f,
                        std::floor(p.z * 4096.0f) / 4096.0f};
        };
        const float size = std::pow(2.0f, random.between(-4.0f, 0.0f));
        const Vec3 a = snap(size * random.direction()), b = snap(size * random.direction());
        if (length(cross(a, b)) < 0.1f * size * size) continue;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec3& p : {a, b, -(a + b)}) mesh.positions.push_back(p);
        mesh.triangles.push_back({first, first + 1, first + 2});
        if (i % 10 == 0) spheres.push_back({{0, 0, 0}, size});
    }
    StressWorkload w;
    w.scene = stress_scene(std::move(mesh), std::move(spheres));
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = random.between(0.01f, 4.0f) * random.direction();
        return ray_towards(origin, std::pow(2.0f, random.between(-5.0f, 0.0f)) * in_ball(random));
    };
    return w;
}

// Triangles and spheres at 2^-i, each half as large as the one before: a tree peels them off one by one. Rays
// start among them and are aimed at one of the next ten. Down to 2^-30: products of three coordinates, which
// any test of triangles forms, leave float32's range below 2^-40.
constexpr int kHalvings = 30;
StressWorkload depth_adversarial(std::uint64_t seed) {
    Mesh mesh;
    std::vector<SphereShape> spheres;
    for (std::uint32_t i = 0; i < 126; ++i) {
        const float s = std::ldexp(1.0f, -static_cast<int>(i));
        for (const Vec3& p : {Vec3{s, 0, 0}, Vec3{s, 0.5f * s, 0}, Vec3{s, 0, 0.5f * s}})
            mesh.positions.push_back(p);
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        spheres.push_back({{s, -0.25f * s, -0.25f * s}, 0.125f * s});
    }
    StressWorkload w;
    w.scene = stress_scene(std::move(mesh), std::move(spheres));
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const int from = static_cast<int>(random.below(kHalvings));
        const float reach = std::ldexp(1.0f, -from);
        const float s = std::ldexp(1.0f, -from - static_cast<int>(random.below(10)));
        const Vec3 origin = {1.4f * reach, reach * random.between(-0.5f, 0.5f),
                             reach * random.between(-0.5f, 0.5f)};
        const float u = random.between(0.02f, 0.45f), v = random.between(0.02f, 0.45f);
        const Vec3 side = in_ball(random);
        const Vec3 target = random.below(2) == 0 ? Vec3{s, 0.5f * s * u, 0.5f * s * v}
                                                 : Vec3{s, -0.25f * s, -0.25f * s} + (0.1f * s) * side;
        return ray_along(origin, direction_to(origin, target));
    };
    return w;
}

}  // namespace

std::vector<StressInfo> heap_workloads() {
    return {
        {"coincident_centroids",
         "triangles and spheres of all sizes about one centroid, which no split parts", kOfBoth,
         coincident_centroids},
        {"depth_adversarial", "triangles and spheres at 2^-i, for which a tree grows as deep as it may",
         kOfBoth, depth_adversarial},
    };
}

}  // namespace ctpbench
