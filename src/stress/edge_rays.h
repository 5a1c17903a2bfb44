// Rays at the edges and vertices of a real scene's own mesh, from where its paths come: what a method's leaks
// cost there, rather than on a mesh made for it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/ray.h"
#include "scene/scene.h"

namespace ctpbench {

// A triangle, and an origin of a path's ray that hits it: it is seen from there.
struct Sighting {
    Vec3 origin;
    std::uint32_t triangle;
};

// `n` rays, each from a sighting's origin at a point of an edge of its triangle or, one in four, at a vertex.
// Edges are inner ones only: shared, by their positions, by two triangles. Ray i depends on seed and i alone,
// given the scene and the sightings. Empty if no sighted triangle has an inner edge.
std::vector<Ray> edge_rays(const Scene& scene, std::span<const Sighting> sightings, std::uint64_t seed,
                           std::uint32_t n);

}  // namespace ctpbench
