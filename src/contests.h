// The two contests of a workload, from its contenders to rows: who intersects the same recorded rays, and who
// renders the same frames.
#pragma once

#include <memory>
#include <vector>

#include "measure/lineup.h"
#include "run_context.h"
#include "scene/scene.h"
#include "wavefront/cuda_workload.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

struct ContestInput {
    const Workload& workload;
    const Scene& scene;
    const SceneView& view;
    Lineup& lineup;
    const Intersector* oracle;  // null: there is none
    SceneResult& in_results;
    std::vector<Batch> batches{};          // of the reference's frame; none: nobody intersects
    std::unique_ptr<CudaWorkload> cuda{};  // null: no contender is for CUDA; after the batches, which it uses
};

// Renders the reference's frame and keeps the rays of each bounce.
std::vector<Batch> record_frame(const RunContext& run, const ContestInput& input);

// Null if no contender is for CUDA. Throws Error(no_backend) if they do not all fit the device's memory;
// nothing is allocated there before that is known.
std::unique_ptr<CudaWorkload> cuda_workload(const RunContext& run, ContestInput& input,
                                            const LayoutInput& layout,
                                            const std::vector<Contender>& contenders);

// Both throw Interrupted after Ctrl-C, with the finished rounds kept.
void run_intersect_contest(const RunContext& run, ContestInput& input,
                           const std::vector<Contender>& contenders);
void run_frame_contest(const RunContext& run, const ContestInput& input,
                       const std::vector<Contender>& contenders);

}  // namespace ctpbench
