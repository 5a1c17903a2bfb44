// Meshes for stress workloads, computed in float64 and rounded once: rounding must not make cracks or folds
// that are not meant.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace ctpbench {

// A subdivided octahedron of 8 4^subdivisions triangles, each vertex at a random distance from the center
// within [1 - roughness, 1] of the radius. Closed; with a roughness up to 0.25 and at least 60 floats along a
// radius star-shaped about the center. Triangles are counterclockwise from outside.
Mesh star_mesh(int subdivisions, float radius, Vec3 center, float roughness, std::uint64_t seed);

// A closed prism of this height over a polygon in the unit circle, turned to no axis' favour: first its sides
// of two triangles each, `narrow` of them of that width, the rest of the circle in 64; then its lids, fans
// about their centers.
Mesh tube_mesh(int narrow, float width, float height);

// The cube [-1, 1]^3 with n x n squares of two triangles on each face; all coordinates are multiples of 2 /
// n.
Mesh cube_mesh(int n);

// n x n parallelograms of two triangles in the plane z = x / 4 - y / 2, over a square of this side about the
// origin. If side / n is a power of two, no coordinate is rounded, and the floor is flat exactly.
Mesh floor_mesh(int n, float side);

// Appends the other's triangles with vertices of their own.
void append(Mesh& mesh, const Mesh& other);

// A scene of one material.
Scene stress_scene(Mesh mesh, std::vector<SphereShape> spheres = {});

}  // namespace ctpbench
