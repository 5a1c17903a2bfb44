// Speed beside failures, made from a run's results.
#pragma once

#include <string>

#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

// One line per examined contender of the reference's strategy, and per yardstick: speed of the recorded rays,
// failures of the exam's. `on_front`: no other on the same workload and backend is at least as fast and fails
// no more often, and better in one of the two.
std::string pareto_csv(const Config& config, const Results& results);

}  // namespace ctpbench
