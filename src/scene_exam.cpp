#include "scene_exam.h"

#include "base/error.h"
#include "kernels/registry.h"
#include "stress/edge_rays.h"

namespace ctpbench {
namespace {

// Of each bounce at most, evenly spread.
constexpr std::uint32_t kSightings = 20000;

}  // namespace

Batch exam_batch(const RunContext& run, ContestInput& input, std::uint32_t rays) {
    const auto tracer = tracer_of(run, input, recording_contender(run.config));
    std::vector<Sighting> sightings;
    for (Batch& batch : input.batches) {
        stop_if_interrupted();
        tracer->trace(batch, true);
        const HitColumns hits = tracer->hits().view();
        const auto n = static_cast<std::uint32_t>(batch.rays.size());
        const std::uint32_t step = n / kSightings + 1;
        for (std::uint32_t i = 0; i < n; i += step) {
            const Hit hit = hits.load(i);
            if (hit.primitive < input.view.geometry().first_sphere())
                sightings.push_back({batch.rays.view().load(i).origin, hit.primitive});
        }
    }
    const std::vector<Ray> aimed = edge_rays(input.scene, sightings, run.config.seed, rays);
    if (aimed.empty())
        throw Error(ExitCode::usage, "table pareto: error: " + input.workload.name() +
                                         " shows no edge that two triangles share, so that no method can be "
                                         "made to leak there; choose a scene with a mesh");
    return stress_batch(run.backend, rays, [&](std::uint32_t i) { return aimed[i]; });
}

SceneExam::SceneExam(const RunContext& run, const ContestInput& input, const Tree& tree, Batch& batch)
    : judge_(input.view.geometry()),
      exact_(judge_, tree),
      exam_(run.backend, judge_, exact_, batch, stop_if_interrupted) {}

}  // namespace ctpbench
