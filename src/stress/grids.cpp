// Coordinates that many planes share: a ray with a zero component, in the plane of a box's side, makes 0
// times infinity of an unguarded slab test.
#include <memory>

#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

constexpr int kSquares = 8;  // along an edge of the cube [-1, 1]^3

// A plane of the cube's grid, but for the outermost ones.
float inner_plane(recipe::Random& random) {
    return -1.0f + 2.0f * static_cast<float>(1 + random.below(kSquares - 1)) / kSquares;
}

// Both zeros are directions' components.
float zero(recipe::Random& random) { return random.below(2) == 0 ? 0.0f : -0.0f; }

StressWorkload axis_parallel(std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(cube_mesh(kSquares));
    w.ray = [seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const std::uint32_t axis = random.below(3);
        // In a grid plane across one further axis at least.
        const bool on_both = random.below(2) == 0;
        Vec3 o{0, 0, 0}, d{0, 0, 0};
        const auto along = static_cast<int>(axis), u = (along + 1) % 3, v = (along + 2) % 3;
        o[along] = random.below(2) == 0 ? inner_plane(random) : random.between(-0.9f, 0.9f);
        o[u] = inner_plane(random);
        o[v] = on_both ? inner_plane(random) : random.between(-0.9f, 0.9f);
        if (random.below(2) == 0) std::swap(o[u], o[v]);
        d[along] = random.below(2) == 0 ? 1.0f : -1.0f;
        d[u] = zero(random);
        d[v] = zero(random);
        return ray_along(o, d);
    };
    return w;
}

// From anywhere inside, or from the grid's points.
StressWorkload cube_vertices(int squares, bool from_grid, std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(cube_mesh(squares));
    w.ray = [mesh = std::make_shared<const Mesh>(w.scene.mesh), from_grid, seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const auto coordinate = [&] { return from_grid ? inner_plane(random) : random.between(-0.9f, 0.9f); };
        const float x = coordinate(), y = coordinate(), z = coordinate();
        return ray_towards({x, y, z}, target_on(*mesh, Aim::vertices, random));
    };
    return w;
}

// Triangles at all angles in one tilted plane, which lie on top of each other.
StressWorkload coplanar(std::uint64_t seed) {
    const auto on_plane = [](float u, float v) { return Vec3{u, v, 0.25f * u - 0.5f * v}; };
    Mesh mesh;
    recipe::Random random(seed, 1);
    for (std::uint32_t i = 0; i < 400; ++i) {
        const float u = random.between(-1, 1), v = random.between(-1, 1);
        const float size = i % 4 == 0 ? 1.0f : 0.2f;
        for (int k = 0; k < 3; ++k) {
            const float du = random.between(-size, size), dv = random.between(-size, size);
            // Multiples of 2^-12: the third coordinate is not rounded, and the plane is one.
            const auto snap = [](float x) { return std::floor(x * 4096.0f) / 4096.0f; };
            mesh.positions.push_back(on_plane(snap(u + du), snap(v + dv)));
        }
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    StressWorkload w;
    w.scene = stress_scene(std::move(mesh));
    w.ray = [mesh = std::make_shared<const Mesh>(w.scene.mesh), seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const Vec3 target = target_on(*mesh, Aim::insides, random);
        Vec3 from = random.direction();
        from.z += from.z < 0.0f ? -1.5f : 1.5f;
        return ray_towards(target + random.between(0.5f, 3.0f) * from, target);
    };
    return w;
}

}  // namespace

std::vector<StressInfo> grid_workloads() {
    return {
        {"axis_parallel", "axis-parallel rays that start on a cube's grid planes, in the planes of boxes",
         kOfTriangles, axis_parallel},
        {"cube_vertices",
         "rays inside a cube of twelve triangles at its corners, which are its boxes' corners", kOfTriangles,
         [](std::uint64_t seed) { return cube_vertices(1, false, seed); }},
        {"grid_vertices", "the same of a cube of 8 x 8 squares on each face, which share planes of boxes",
         kOfTriangles, [](std::uint64_t seed) { return cube_vertices(kSquares, false, seed); }},
        {"grid_to_grid", "rays from a grid's points to its vertices: exact ties between planes of boxes",
         kOfTriangles, [](std::uint64_t seed) { return cube_vertices(kSquares, true, seed); }},
        {"coplanar", "overlapping triangles in one plane, all at the same t", kOfTriangles, coplanar},
    };
}

}  // namespace ctpbench
