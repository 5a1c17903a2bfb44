// The tables of a run, made from its results: machine-readable, and in the paper's shape.
#pragma once

#include <string>

#include "config/config.h"
#include "measure/results.h"
#include "measure/statistics.h"

namespace ctpbench {

// The contender that `ratio_to_yardstick` refers to.
inline constexpr const char* kYardstick = "embree_robust";

// Paired ratio of two contenders of one workload; no rounds in common: all NaN.
Estimate ratio_of(const CellResult* numerator, const CellResult* denominator);

// One line per cell: median throughput with its interval, ratios to the reference and to the yardstick.
std::string summary_csv(const Config& config, const Results& results);

// One line per tree.
std::string trees_csv(const Results& results);

// Rows are sphere counts, columns are scenes: nodes of the combined trees, and of each type's own.
std::string table2_csv(const Results& results);

// Rows are sphere counts, a column per scene, backend and strategy: median Mrays/s of valid cells.
std::string table3_csv(const Results& results);

// Table 3 for people: ours beside the paper's, ratios within each machine beside each other.
std::string table3_markdown(const Results& results);

// For the end of a run on a terminal.
std::string table_text(const Config& config, const Results& results);

}  // namespace ctpbench
