// What a frame on a CUDA device reports of its stages, from its clock and from what the device has counted.
#pragma once

#include <string>
#include <vector>

#include "kernels/dispatch/shade/layout.h"
#include "wavefront/frame_clock.cuh"
#include "wavefront/placed_wavefront.h"

namespace ctpbench {

// The names of the parts of shade that have streams of their own, by key; empty: it has no parts.
using ShadePartNames = std::vector<std::string>;

// After the frame has ended and its counts are the host's. Stages that no path reached are left out. Names
// point into `parts`.
std::vector<StageTime> stage_times(const FrameClock& clock, const PlacedWavefront& wavefront, PathOrder order,
                                   const ShadePartNames& parts);

}  // namespace ctpbench
