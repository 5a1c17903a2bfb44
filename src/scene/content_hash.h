// Identifies what a scene holds, so that two results can be told to be of the same scene.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace ctpbench {

// Of the triangles, spheres, materials, textures and the light from outside, bit for bit and in order. The
// name, the source, the camera and the exposure do not count: the same content seen from elsewhere.
std::uint64_t content_hash(const Scene& scene);

// Of what workloads of one scene have in common whatever their spheres: the triangles with their materials
// and textures, the light, the camera and the exposure.
std::uint64_t base_hash(const Scene& scene);

}  // namespace ctpbench
