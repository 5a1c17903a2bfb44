// How often a workload's contenders fail on its own scene: rays at the inner edges and vertices of its mesh,
// from where the recorded paths come, judged by the oracle of last resort. Speed is measured on other rays,
// the recorded ones, which meet an edge too seldom to tell methods apart.
#pragma once

#include <cstdint>
#include <vector>

#include "accel/tree.h"
#include "entrants.h"
#include "measure/exam.h"

namespace ctpbench {

// `rays` rays for the recorded batches' paths, as a batch. Throws Error(usage) if nothing of the mesh that
// they see has an inner edge.
Batch exam_batch(const RunContext& run, ContestInput& input, std::uint32_t rays);

class SceneExam {
public:
    // Finds the reference. `tree` is over all primitives of the scene; all must outlive the exam.
    SceneExam(const RunContext& run, const ContestInput& input, const Tree& tree, Batch& batch);

    Accuracy take(BatchTracer& tracer) { return exam_.take(tracer); }

private:
    Judge judge_;
    ExactTracer exact_;
    RayExam exam_;
};

}  // namespace ctpbench
