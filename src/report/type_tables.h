// What types cost: narrowing.csv and types.csv.
#pragma once

#include <string>

#include "measure/results.h"

namespace ctpbench {

// Kernels compiled for the types that the scene has against kernels compiled for all: a line per scene,
// backend and strategy that was measured with both; `gain` is their paired ratio. The bytes are those of the
// layout on a CPU beside its trees.
std::string narrowing_csv(const Results& results);

// Throughput as lists of synthetic types grow: a line per strategy, kernel and list. `ratio` is to `ctp` with
// one type in the same kernel. Kernels are intersect; and of frames shade, what stands between two intersects
// (sort+shade+compact), and the frame.
std::string types_csv(const Results& results);

}  // namespace ctpbench
