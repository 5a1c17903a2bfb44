// What the tables print: medians, ratios and their intervals.
#pragma once

#include <string>
#include <string_view>

#include "measure/results.h"
#include "measure/statistics.h"

namespace ctpbench {

// The contender that `ratio_to_yardstick` refers to on the CPU.
inline constexpr const char* kYardstick = "embree_robust";

// The kernel by which a contender is judged where none is named: intersect, or shade if it renders.
std::string_view main_kernel(const CellResult& cell);

// Who the ratios of a cell refer to: the contender of its workload that has the reference's name, as a
// strategy or, if it renders, as a shade strategy.
const CellResult* reference_of(const CellResult& cell, const Results& results, const std::string& reference);

// The yardstick of the cell's backend on its workload; null if it was not measured.
const CellResult* yardstick_of(const CellResult& cell, const Results& results);

// Mrays/s of a kernel; all NaN if there is no such cell, or none that may be shown.
Estimate throughput_of(const CellResult* cell, std::string_view kernel = "intersect");

// Seconds per frame, likewise.
Estimate seconds_of_kernel(const CellResult* cell, std::string_view kernel);

// By round, the ratios of two contenders' throughput; none if there is no such cell, or none that may be
// shown.
std::vector<double> ratios_of(const CellResult* numerator, const CellResult* denominator,
                              std::string_view kernel);

// Their median; no rounds in common: all NaN.
Estimate ratio_of(const CellResult* numerator, const CellResult* denominator,
                  std::string_view kernel = "intersect");

// Paired ratio of the throughputs of two kernels of one contender.
Estimate kernel_ratio_of(const CellResult* cell, std::string_view numerator, std::string_view denominator);

// Paired ratio of the seconds that two kernels take of a frame.
Estimate seconds_ratio_of(const CellResult* cell, std::string_view numerator, std::string_view denominator);

// "1.25", or "n/a" for NaN.
std::string fixed(double value, int digits);

// "1.25 [1.20, 1.30]"
std::string with_interval(const Estimate& estimate);

}  // namespace ctpbench
