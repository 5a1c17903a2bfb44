// What the stages of frames add up to, kernel by kernel.
#pragma once

#include <vector>

#include "measure/results.h"
#include "wavefront/frame.h"

namespace ctpbench {

// Adds a round to the cell: what its stages took over all bounces, and the samples dropped and clamped.
void add_stages(CellResult& cell, const std::vector<StageTime>& stages);

// Seconds of all stages. What ran inside another stage, shade_<type>, is not counted twice; the copy, a
// yardstick, not at all.
double seconds_of(const std::vector<StageTime>& stages);

}  // namespace ctpbench
