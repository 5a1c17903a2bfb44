// What the tables print: medians, ratios and their intervals.
#pragma once

#include <string>

#include "measure/results.h"
#include "measure/statistics.h"

namespace ctpbench {

// The contender that `ratio_to_yardstick` refers to.
inline constexpr const char* kYardstick = "embree_robust";

// Mrays/s of a cell; all NaN if there is none, or none that may be shown.
Estimate throughput_of(const CellResult* cell);

// Paired ratio of two contenders of one workload; no rounds in common: all NaN.
Estimate ratio_of(const CellResult* numerator, const CellResult* denominator);

// "1.25", or "n/a" for NaN.
std::string fixed(double value, int digits);

// "1.25 [1.20, 1.30]"
std::string with_interval(const Estimate& estimate);

}  // namespace ctpbench
