#include "entrants.h"

#include "wavefront/cpu_tracer.h"
#include "wavefront/interleaved/intersector.h"
#include "wavefront/methods.h"

namespace ctpbench {
namespace {

// With roulette, paths that have not left their third hit behind go on for certain: they carry most of a
// picture's light.
constexpr std::uint32_t kRouletteFrom = 3;

}  // namespace

Contender recording_contender(const Config& config) {
    Contender recording;
    recording.backend = "cpu", recording.strategy = config.reference;
    recording.traversal = traverses(config.reference, kSingle, recording.backend) ? kSingle : kInterleaved;
    recording.methods = Watertight::name, recording.shade = kRecordingShade;
    return recording;
}

std::string intersect_key(const Contender& c) {
    if (c.is_yardstick()) return own_way;
    return intersect_methods(c.methods, c.triangle_test, c.sphere_test, c.box_test, c.offset);
}

std::string offset_name(const Contender& c) { return offset_of(c.methods, c.offset); }

bool is_exact(const Contender& c) { return methods_exact(intersect_key(c)); }

CellResult cell_of(const ContestInput& input, const Contender& contender) {
    CellResult cell;
    cell.workload = input.workload, cell.contender = contender;
    cell.scene_source = input.in_results.source, cell.triangles = input.scene.mesh.triangles.size();
    return cell;
}

FrameSettings frame_settings(const Config& config, const Contender& c) {
    const std::uint32_t bounces = c.bounce_limit != 0 ? c.bounce_limit : config.bounces;
    FrameSettings settings{config.width, config.height, bounces, config.seed};
    if (c.roulette) settings.roulette_from = kRouletteFrom;
    return settings;
}

std::unique_ptr<BatchTracer> tracer_of(const RunContext& run, const ContestInput& input, const Contender& c) {
    const std::string methods = intersect_key(c);
    if (c.backend == "cuda") return input.cuda->tracer(c.strategy, methods, c.types);
    return std::make_unique<CpuTracer>(run.pools.get(static_cast<int>(c.threads)),
                                       input.lineup.get(c.strategy, methods, c.types, c.traversal),
                                       input.view.geometry().extent);
}

std::unique_ptr<FramePipeline> PipelineMaker::make(const Contender& c, const FrameSettings& settings) {
    const std::string methods = intersect_key(c);
    if (c.backend == "cuda")
        return input_.cuda->pipeline(c.strategy, methods, c.types, c.shade, cuda_launch(c.launch),
                                     input_.scene.camera, settings, offset_name(c));
    return std::make_unique<CpuPipeline>(
        renderer(settings), input_.lineup.get(c.strategy, methods, c.types, c.traversal),
        make_shader(c.shade, input_.scenes.materials(c.types, offset_name(c)), offset_name(c)));
}

std::shared_ptr<Renderer> PipelineMaker::renderer(const FrameSettings& settings) {
    std::erase_if(renderers_, [](const std::weak_ptr<Renderer>& r) { return r.expired(); });
    for (const std::weak_ptr<Renderer>& r : renderers_)
        if (auto alive = r.lock(); alive && alive->settings() == settings) return alive;
    auto made = std::make_shared<Renderer>(run_.backend, input_.view, input_.scene.camera, settings);
    renderers_.push_back(made);
    return made;
}

}  // namespace ctpbench
