// Table 1 and Figure 4 of the paper, made from a run's frames.
#pragma once

#include <string>

#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

// Rows are kernels, a column per scene, backend and shade strategy: median Mrays/s of valid cells, "n/a"
// where a pipeline has no such kernel.
std::string table1_csv(const Results& results);

// Table 1 for people: ours beside the paper's, ratios within each machine, reordering against a plain copy,
// and what shading takes beside intersecting.
std::string table1_markdown(const Results& results);

// One line per cell and kernel: seconds of a frame, accumulated over its bounces.
std::string figure4_csv(const Config& config, const Results& results);

}  // namespace ctpbench
