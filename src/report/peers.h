// Our traversals beside Embree's ways to trace, made from a run's results.
#pragma once

#include <string>

#include "measure/results.h"

namespace ctpbench {

// One line per scene, recorded bounce, contender on the CPU and number of threads. `rays` is primary for the
// camera's, else bounce1 and so on. Ratios are to rtcIntersect1 at Embree's defaults with as many threads,
// paired within rounds. `mismatch_rate`: the share of rays whose hit differs from the reference's beyond
// rounding (Verdict::mismatch_rate). `threads`: of contenders that ask for no number of their own.
std::string peers_csv(const Results& results, int threads);

}  // namespace ctpbench
