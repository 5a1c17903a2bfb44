// The two contests of a workload, from its contenders to rows: who intersects the same recorded rays, and who
// renders the same frames.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "entrants.h"

namespace ctpbench {

// Renders the reference's frame and keeps the rays of each bounce, with those of the exam if there is to be
// one.
void record_frame(const RunContext& run, ContestInput& input);

// Whether a file of this name is one that the workload's accumulated frames are written to.
bool is_picture_of(const Workload& workload, const std::string& file);

// Null if no contender is for CUDA. Throws Error(no_backend) if they do not all fit the device's memory;
// nothing is allocated there before that is known.
std::unique_ptr<CudaWorkload> cuda_workload(const RunContext& run, ContestInput& input,
                                            const std::vector<Contender>& contenders);

// Both throw Interrupted after Ctrl-C, with the finished rounds kept.
void run_intersect_contest(const RunContext& run, ContestInput& input,
                           const std::vector<Contender>& contenders);
void run_frame_contest(const RunContext& run, const ContestInput& input,
                       const std::vector<Contender>& contenders);

}  // namespace ctpbench
