// All stress workloads by name.
#pragma once

#include <string_view>
#include <vector>

#include "stress/workload.h"

namespace ctpbench {

// In the order of reports: meshes, slivers, grids, heaps, spheres, offsets.
const std::vector<StressInfo>& stress_workloads();

// Throws Error(usage), listing the choices, if there is none of this name.
StressWorkload make_stress(std::string_view name, std::uint64_t seed);

}  // namespace ctpbench
