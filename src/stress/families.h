// The families of stress workloads; each is a source file. A further workload is an entry in one of them.
#pragma once

#include <vector>

#include "stress/workload.h"

namespace ctpbench {

std::vector<StressInfo> star_workloads();        // closed meshes seen from inside, at all scales and offsets
std::vector<StressInfo> star_layer_workloads();  // the same in layers, from afar, from their surface
std::vector<StressInfo> sliver_workloads();      // needles, grazing rays
std::vector<StressInfo> grid_workloads();        // coordinates that many planes share
std::vector<StressInfo> heap_workloads();        // primitives that a tree cannot tell apart
std::vector<StressInfo> ball_workloads();        // spheres
std::vector<StressInfo> departure_workloads();   // rays that leave surfaces

}  // namespace ctpbench
