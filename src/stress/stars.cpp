// Closed star-shaped meshes seen from inside: every ray hits, so whatever misses is a leak. At the origin,
// far from it, and at scales far from one.
#include <memory>

#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

struct Place {
    const char* suffix;
    const char* words;
    int subdivisions;
    float radius;
    Vec3 center;
};
// Far from the origin a mesh is as fine as the floats there let it be star-shaped: they are 1/64 apart
// at 1.5e5 and 1/4 at 3e6.
constexpr Place kPlaces[] = {
    {"", "of unit size", 4, 1.0f, {0.0f, 0.0f, 0.0f}},
    {"_at_150k", "of radius 64 at 1.5e5", 4, 64.0f, {1.5e5f, -1.5e5f, 0.75e5f}},
    {"_at_3m", "of radius 256 at 3e6", 3, 256.0f, {3e6f, -3e6f, 1.5e6f}},
    {"_x1e-6", "of radius 1e-6", 4, 1e-6f, {0.0f, 0.0f, 0.0f}},
    {"_x1e6", "of radius 1e6", 4, 1e6f, {0.0f, 0.0f, 0.0f}},
};

StressWorkload inside_star(const Place& place, Aim aim, std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(star_mesh(place.subdivisions, place.radius, place.center, 0.25f, seed));
    w.ray = [mesh = std::make_shared<const Mesh>(w.scene.mesh), place, aim, seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = place.center + (0.3f * place.radius) * in_ball(random);
        return ray_towards(origin, target_on(*mesh, aim, random));
    };
    return w;
}

StressWorkload random_in_star(const Place& place, std::uint64_t seed) {
    StressWorkload w = inside_star(place, Aim::edges, seed);
    w.ray = [place, seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 origin = place.center + (0.3f * place.radius) * in_ball(random);
        return ray_along(origin, random.direction());
    };
    return w;
}

}  // namespace

std::vector<StressInfo> star_workloads() {
    std::vector<StressInfo> list;
    for (const Place& place : kPlaces) {
        const std::string star = std::string("a closed mesh ") + place.words;
        list.push_back({std::string("edges") + place.suffix,
                        "rays inside " + star + " at its edges slip between two triangles", kOfTriangles,
                        [place](std::uint64_t seed) { return inside_star(place, Aim::edges, seed); }});
        list.push_back({std::string("vertices") + place.suffix,
                        "rays inside " + star + " at its vertices slip between all triangles around",
                        kOfTriangles,
                        [place](std::uint64_t seed) { return inside_star(place, Aim::vertices, seed); }});
    }
    list.push_back({"random", "nothing: uniformly random rays inside a closed mesh, on which all agree",
                    kOfTriangles, [](std::uint64_t seed) { return random_in_star(kPlaces[0], seed); }});
    list.push_back({"random_at_150k", "random rays inside a closed mesh whose boxes are a few floats wide",
                    kOfTriangles, [](std::uint64_t seed) { return random_in_star(kPlaces[1], seed); }});
    return list;
}

}  // namespace ctpbench
