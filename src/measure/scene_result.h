// What meta.json says of a scene.
#pragma once

#include "measure/results.h"
#include "scene/scene.h"

namespace ctpbench {

// `spheres` as the workload names it. What was measured of the scene is not known yet.
SceneResult describe(const Scene& scene, std::uint32_t spheres);

}  // namespace ctpbench
