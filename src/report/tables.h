// The paper's Table 3, made from a run's results.
#pragma once

#include <string>

#include "measure/results.h"

namespace ctpbench {

// Rows are sphere counts, a column per scene, backend and strategy: median Mrays/s of valid cells.
std::string table3_csv(const Results& results);

// Table 3 for people: ours beside the paper's, ratios within each machine beside each other.
std::string table3_markdown(const Results& results);

}  // namespace ctpbench
