// The two contests of a workload, from its contenders to rows: who intersects the same recorded rays, and who
// renders the same frames.
#pragma once

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
    CudaWorkload* cuda;         // null: no contender is for CUDA
    const Intersector* oracle;  // null: there is none
    SceneResult& in_results;
};

// Whether its hits are the same bit for bit whatever the tree.
bool is_exact(const Contender& contender);

// The contender's cell before anything is measured.
CellResult cell_of(const ContestInput& input, const Contender& contender);

// Both throw Interrupted after Ctrl-C, with the finished rounds kept.
void run_intersect_contest(const RunContext& run, const ContestInput& input,
                           const std::vector<Contender>& contenders);
void run_frame_contest(const RunContext& run, const ContestInput& input,
                       const std::vector<Contender>& contenders);

}  // namespace ctpbench
