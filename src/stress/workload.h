// Stress workloads: generated scenes with rays that provoke the rounding errors of one kind of method.
// Uniformly random rays do not tell methods apart; these do. All of it is a function of the name and the
// seed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "kernels/ray.h"
#include "scene/scene.h"

namespace ctpbench {

// A path that leaves a surface. The policy under test (kernels/methods/offset_*.h) forms the ray from the
// float32 members; `exact` is where it would start if nothing were rounded.
struct Departure {
    std::uint32_t primitive;      // scene-wide id of what it starts on
    Vec3 point;                   // as shading finds it from a hit (kernels/surface.h)
    Vec3 normal;                  // of unit length, to the side that it leaves on
    Vec3 direction;               // of unit length
    float t;                      // length of the way that led to the point, scene units
    std::array<double, 3> exact;  // on the surface itself, by float64
};

struct StressWorkload {
    std::string name;
    Scene scene;
    // Ray number i, or path number i of a workload for offsets; the other one is empty. Any number of them
    // may be asked for, in any order, from many threads; ray i is the same however many there are.
    std::function<Ray(std::uint32_t)> ray;
    std::function<Departure(std::uint32_t)> departure;
    // Of a workload for offsets: which surface each primitive, by its id, is part of. Ending on another
    // surface than the ideal path is a failure, on another triangle of the same one it is not.
    std::vector<std::uint32_t> surfaces;

    bool of_offsets() const { return static_cast<bool>(departure); }
};

// Which kinds of methods the workload can meet: a test of spheres has nothing to say about a mesh.
struct StressKinds {
    bool triangle = false, sphere = false, box = false, offset = false;

    bool operator==(const StressKinds&) const = default;
};
inline constexpr StressKinds kOfTriangles{true, false, true, false};
inline constexpr StressKinds kOfSpheres{false, true, true, false};
inline constexpr StressKinds kOfBoth{true, true, true, false};
inline constexpr StressKinds kOfOffsets{false, false, false, true};

struct StressInfo {
    std::string name;
    std::string provokes;  // one sentence
    StressKinds kinds;
    std::function<StressWorkload(std::uint64_t seed)> make;
};

}  // namespace ctpbench
