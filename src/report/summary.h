// Machine-readable summaries of a run.
#pragma once

#include <string>

#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

// One line per cell and kernel: median throughput with its interval, ratios to the reference and to the
// yardstick, the verdict beside the reference and what makes it doubtful.
std::string summary_csv(const Config& config, const Results& results);

// One line per tree.
std::string trees_csv(const Results& results);

}  // namespace ctpbench
