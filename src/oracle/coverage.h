// Whether a surface goes on around the place where a ray passes the outline of one of its triangles. A test
// of single triangles may miss each of them there; a watertight one hits one of them.
#pragma once

#include <cstdint>

#include "oracle/adjacency.h"
#include "oracle/exact.h"

namespace ctpbench {

// Whether the triangles that are joined to `id` by shared vertices near the ray cover, as seen along the ray
// and in front of its origin, all that is within `radius` (scene units) of it. If not, the ray is at the rim
// of an open mesh, at a silhouette, or starts there. NaN coordinates count as not covering.
bool surface_covers(const GeometryView& geometry, const MeshAdjacency& adjacency, std::uint32_t id,
                    double radius, const ExactRay& ray);

}  // namespace ctpbench
