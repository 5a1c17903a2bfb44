// From a contender to what is measured: its tracer of recorded rays, its pipeline of frames, on its backend.
#pragma once

#include <memory>
#include <vector>

#include "measure/lineup.h"
#include "run_context.h"
#include "scene/scene.h"
#include "wavefront/cuda_workload.h"
#include "wavefront/frame.h"
#include "wavefront/renderer.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

// What the contenders of one workload share.
struct ContestInput {
    const Workload& workload;
    const Scene& scene;
    const SceneView& view;
    TypedScenes& scenes;
    Lineup& lineup;
    const Intersector* oracle;  // null: there is none
    SceneResult& in_results;
    std::vector<Batch> batches{};          // of the reference's frame; none: nobody intersects
    const Tree* examined{};                // over all primitives; null: failures are not counted. Else the
                                           // exam's batch follows the frame's
    bool compares = false;                 // whether contenders are compared with what the frame hit
    std::vector<HitStorage> found{};       // if so: what that was, by batch
    std::unique_ptr<CudaWorkload> cuda{};  // null: no contender is for CUDA; after the batches, which it uses
};

// Who shades frames of which only the rays or the reference matter.
inline constexpr const char* kRecordingShade = "ctp";

// Who records the rays of a run, with the run's reference strategy and the default methods.
Contender recording_contender(const Config& config);

// What the intersect stage is called for this contender (wavefront/methods.h); own_way for a yardstick.
std::string intersect_key(const Contender& contender);

// Whether its hits are the same bit for bit whatever the tree.
bool is_exact(const Contender& contender);

// The contender's cell before anything is measured.
CellResult cell_of(const ContestInput& input, const Contender& contender);

// Of a contender's frames; with the contender's own limits.
FrameSettings frame_settings(const Config& config, const Contender& contender);

// The offset of its frames, as make_shader() takes it.
std::string offset_name(const Contender& contender);

std::unique_ptr<BatchTracer> tracer_of(const RunContext& run, const ContestInput& input, const Contender& c);

// Pipelines on CPU threads with equal settings share a renderer, whose buffers are large, while one of them
// lives.
class PipelineMaker {
public:
    // Both must outlive it and the pipelines.
    PipelineMaker(const RunContext& run, const ContestInput& input) : run_(run), input_(input) {}

    std::unique_ptr<FramePipeline> make(const Contender& contender, const FrameSettings& settings);

private:
    std::shared_ptr<Renderer> renderer(const FrameSettings& settings);

    const RunContext& run_;
    const ContestInput& input_;
    std::vector<std::weak_ptr<Renderer>> renderers_;
};

}  // namespace ctpbench
