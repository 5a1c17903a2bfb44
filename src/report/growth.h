// What a ray costs as its scene's triangles grow in number, made from a run's results.
#pragma once

#include <string>

#include "measure/results.h"

namespace ctpbench {

// One line per scene, recorded bounce, contender on the CPU and number of threads: triangles, and nanoseconds
// of the clock on the wall per ray, with the 95 % interval of the median over rounds. `rays` and `threads` as
// in peers.h.
std::string growth_csv(const Results& results, int threads);

}  // namespace ctpbench
