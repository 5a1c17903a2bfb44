// The solids of which the furniture and the buildings are made. Lengths are metres, y is up.
#pragma once

#include <span>

#include "scene/recipes/mesh_edit.h"

namespace ctpbench::recipe {

// 12 triangles.
void box(Mesh& mesh, const Frame& frame, Vec3 low, Vec3 high, MaterialId material);
inline void box(Mesh& mesh, Vec3 low, Vec3 high, MaterialId material) {
    box(mesh, Frame{}, low, high, material);
}

// A box whose corners are rounded away, as upholstery is; 12 * n * n triangles, n a power of two (its grid
// is then exact and the faces meet without seams).
void cushion(Mesh& mesh, const Frame& frame, Vec3 half_size, int n, MaterialId material);

struct ProfilePoint {
    float radius, height;
};

// A surface of revolution about the frame's y axis, its profile given from bottom to top (a closed cup: out
// and back in). Radius 0, allowed at the ends alone, closes the surface with a fan.
void lathe(Mesh& mesh, const Frame& frame, std::span<const ProfilePoint> profile, int sides,
           MaterialId material);

// A tube along a path, tapering from one radius to the other, its ends closed.
void tube(Mesh& mesh, std::span<const Vec3> path, float first_radius, float last_radius, int sides,
          MaterialId material);

// A ring of round cross-section about the frame's y axis; 2 * segments * sides triangles.
void torus(Mesh& mesh, const Frame& frame, float radius, float thickness, int segments, int sides,
           MaterialId material);

struct OutlinePoint {
    float x, y;
};

// A convex outline in the frame's x-y plane (counter-clockwise seen from +z), drawn out along z from 0 to
// `depth`, with both caps.
void prism(Mesh& mesh, const Frame& frame, std::span<const OutlinePoint> outline, float depth,
           MaterialId material);

}  // namespace ctpbench::recipe
