// Where the time of rays in flight goes, as a table.
#pragma once

#include <string>

#include "measure/results.h"

namespace ctpbench {

// One line per scene, bounce and phase (kernels/interleaved/profile.h): how often a ray comes to it, cycles
// of the time stamp counter that each time costs, their product, and how many rays a loop is over. Rays that
// are alike go in packets, the others in flight; `per_ray` and `cycles_per_ray` are means over all rays of
// the bounce.
std::string profile_csv(const Results& results);

}  // namespace ctpbench
