// Spheres: far, huge, tiny, seen from inside and from their surface.
#include <cmath>

#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

struct Impact {
    float lo, hi;  // distance of the ray's line from the center, in radii
};
constexpr Impact kHits{0.0f, 0.99f}, kPasses{1.01f, 1.1f};

// One sphere from this many radii away.
StressWorkload from_distance(SphereShape sphere, float radii, Impact impact, std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene({}, {sphere});
    w.ray = [=](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 d = random.direction();
        const Vec3 side = beside(d, random);
        const float off = sphere.radius * random.between(impact.lo, impact.hi);
        return ray_along(sphere.center + off * side - (radii * sphere.radius) * d, d);
    };
    return w;
}

constexpr SphereShape kUnit{{0.3f, -0.7f, 0.2f}, 1.0f};

// From 2 to 1e4 units above a planet of radius 1e6, downwards; at a height of 1 its rounding decides.
StressWorkload planet(std::uint64_t seed) {
    constexpr SphereShape sphere{{0, 0, 0}, 1e6f};
    StressWorkload w;
    w.scene = stress_scene({}, {sphere});
    w.ray = [=](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 up = random.direction();
        const float height = std::pow(10.0f, random.between(0.3f, 4.0f));
        Vec3 d = random.direction();
        if (dot(d, up) > 0.0f) d = -d;
        return ray_along((sphere.radius + height) * up, d);
    };
    return w;
}

StressWorkload inside(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene({}, {kUnit});
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = kUnit.center + (0.999f * kUnit.radius) * in_ball(random);
        return ray_along(origin, random.direction());
    };
    return w;
}

// From the surface to either side, at all angles, directions of any length.
StressWorkload on_surface(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene({}, {kUnit});
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = kUnit.center + kUnit.radius * random.direction();
        return ray_along(origin, random.between(0.1f, 10.0f) * random.direction());
    };
    return w;
}

// A thousand in a ball; rays are aimed at points up to 1.3 radii from a center, so some pass.
StressWorkload cloud(float scale, Vec3 offset, std::uint64_t seed) {
    std::vector<SphereShape> spheres;
    recipe::Random random(seed, 3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 at = in_ball(random);
        const float radius = std::pow(2.0f, random.between(-12.0f, -3.0f));
        spheres.push_back({offset + scale * at, scale * radius});
    }
    StressWorkload w;
    w.scene = stress_scene({}, spheres);
    w.ray = [=](std::uint32_t i) {
        recipe::Random r = ray_random(seed, i);
        const SphereShape& s = spheres[r.below(static_cast<std::uint32_t>(spheres.size()))];
        const Vec3 from = r.direction();
        const float distance = scale * r.between(0.5f, 2.0f);
        return ray_towards(offset + distance * from, s.center + (1.3f * s.radius) * in_ball(r));
    };
    return w;
}

// Two spheres 2^-14 apart, from the middle: the inner one must be hit.
StressWorkload shells(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene({}, {{kUnit.center, 1.0f + 0x1p-14f}, kUnit});
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = kUnit.center + 0.9f * in_ball(random);
        return ray_along(origin, random.direction());
    };
    return w;
}

}  // namespace

std::vector<StressInfo> ball_workloads() {
    std::vector<StressInfo> list;
    const auto add = [&](const char* name, const char* provokes, auto make) {
        list.push_back({name, provokes, kOfSpheres, make});
    };
    const auto far = [&](const char* name, const char* provokes, float radii, Impact impact) {
        add(name, provokes, [=](std::uint64_t seed) { return from_distance(kUnit, radii, impact, seed); });
    };
    far("sphere_at_1e2", "hits from 100 radii away, where the textbook's t has lost its last digits", 1e2f,
        kHits);
    far("sphere_at_1e3", "hits from 1e3 radii away, some of which the textbook's discriminant loses", 1e3f,
        kHits);
    far("sphere_at_1e4", "hits from 1e4 radii away, where that discriminant is rounding alone", 1e4f, kHits);
    far("sphere_passed_at_1e4", "rays that pass it by 1 to 10 % of its radius from 1e4 radii away", 1e4f,
        kPasses);
    add("sphere_planet", "a radius of 1e6 seen from a few units above: digits cancel in t", planet);
    add("sphere_inside", "rays that start inside must hit the far side", inside);
    add("sphere_surface", "rays that start on it: whether they are in or out is rounding", on_surface);
    add("sphere_shells", "two spheres 2^-14 apart, of which the nearer must be hit", shells);
    add("sphere_cloud", "spheres of radii from 2^-12 to 2^-3, at their outlines and inside",
        [](std::uint64_t seed) {
            return cloud(1.0f, {0, 0, 0}, seed);
        });
    add("sphere_cloud_at_150k", "the same spheres, 64 times as large, around 1.5e5", [](std::uint64_t seed) {
        return cloud(64.0f, {1.5e5f, -1.5e5f, 0.75e5f}, seed);
    });
    add("sphere_cloud_x1e-6", "the same spheres a millionth as large", [](std::uint64_t seed) {
        return cloud(1e-6f, {0, 0, 0}, seed);
    });
    add("sphere_cloud_x1e6", "the same spheres a million times as large", [](std::uint64_t seed) {
        return cloud(1e6f, {0, 0, 0}, seed);
    });
    return list;
}

}  // namespace ctpbench
