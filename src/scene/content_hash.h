// Identifies what a scene holds, so that two results can be told to be of the same scene.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace ctpbench {

// Of the triangles, materials and spheres, bit for bit and in order. The name, the source and the camera do
// not count: the same geometry seen from elsewhere is the same content.
std::uint64_t content_hash(const Scene& scene);

}  // namespace ctpbench
