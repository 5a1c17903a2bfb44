#include "contests.h"

#include "measure/contest.h"
#include "measure/frame_contest.h"
#include "oracle/embree.h"
#include "report/image.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/methods.h"
#include "wavefront/renderer.h"

namespace ctpbench {
namespace {

// Shares of a workload's time, for the progress line; loading and trees come before.
constexpr double kFrame = 0.45, kVerified = 0.55;

// Verifies an entrant and enters its cell. `verify` returns the rows of an entrant that is rejected.
template <class Verify>
void enter(const RunContext& run, CellResult cell, double share, Verify&& verify) {
    stop_if_interrupted();
    const std::string name = cell.workload.name() + "/" + cell.contender.label();
    run.progress.step("checking " + cell.contender.label(), kFrame + (kVerified - kFrame) * share);
    const std::vector<Row> rows = verify(cell);
    if (!cell.valid) run.note(name + ": rejected: " + cell.reason);
    run.results.cells.push_back(std::move(cell));
    if (!run.results.cells.back().valid) run.rows.append(run.results, rows);
}

template <class Contest, class Entrants>
void run_rounds(const RunContext& run, Contest& contest, Entrants& entrants) {
    for (std::uint32_t round = 0; round < run.config.rounds; ++round) {
        run.progress.step("round " + std::to_string(round + 1) + " of " + std::to_string(run.config.rounds),
                          kVerified + (1.0 - kVerified) * round / run.config.rounds);
        run.rows.append(run.results, contest.round(round, entrants, run.results, interrupted));
        stop_if_interrupted();
    }
}

Renderer renderer_of(const RunContext& run, const ContestInput& input, bool copies) {
    const Config& c = run.config;
    return Renderer(run.backend, input.view, input.scene.camera,
                    {c.width, c.height, c.bounces, c.seed, copies});
}

std::vector<Batch> record_frame(const RunContext& run, const ContestInput& input) {
    run.progress.step("tracing the reference frame", kFrame);
    std::vector<Batch> batches;
    ImageStorage image;
    const auto shader = make_shader("ctp", input.view.materials());
    renderer_of(run, input, false)
        .frame(input.lineup.get(run.config.reference, Watertight::name), *shader, true, 0, image,
               [&](const BounceView& view) {
                   stop_if_interrupted();
                   Batch& batch = batches.emplace_back(
                       record_batch(view.bounce, view.rays, view.slots, run.config.batch_rays));
                   batch.hit_hash = record_hits(batch, view.hits).hash();
               });
    return batches;
}

// What the first valid contender has accumulated; the others have the same.
void write_images(const RunContext& run, const ContestInput& input,
                  const std::vector<FrameEntrant>& entrants) {
    for (const FrameEntrant& e : entrants) {
        if (!run.results.cells[e.cell].valid || e.image.size() == 0) continue;
        std::string name = input.workload.name();
        std::replace(name.begin(), name.end(), '/', '-');
        for (const char* type : {".exr", ".png"})
            write_image(run.folder / (name + type), run.config.width, run.config.height, e.image,
                        input.scene.exposure);
        return;
    }
}

std::unique_ptr<BatchTracer> tracer_of(const RunContext& run, const ContestInput& input, const Contender& c) {
    if (c.backend == "cuda") return input.cuda->tracer(c.strategy, c.methods);
    return std::make_unique<CpuTracer>(run.backend, input.lineup.get(c.strategy, c.methods),
                                       input.view.geometry().extent);
}

std::unique_ptr<FramePipeline> pipeline_of(const RunContext& run, const ContestInput& input,
                                           Renderer& renderer, const Contender& c) {
    if (c.backend == "cuda") {
        const Config& config = run.config;
        return input.cuda->pipeline(c.strategy, c.methods, c.shade, cuda_launch(c.launch), input.scene.camera,
                                    {config.width, config.height, config.bounces, config.seed, true});
    }
    return std::make_unique<CpuPipeline>(renderer, input.lineup.get(c.strategy, c.methods),
                                         make_shader(c.shade, input.view.materials()));
}

}  // namespace

bool is_exact(const Contender& contender) { return methods_exact(contender.methods); }

CellResult cell_of(const ContestInput& input, const Contender& contender) {
    CellResult cell;
    cell.workload = input.workload, cell.contender = contender;
    cell.scene_source = input.in_results.source, cell.triangles = input.scene.mesh.triangles.size();
    return cell;
}

void run_intersect_contest(const RunContext& run, const ContestInput& input,
                           const std::vector<Contender>& contenders) {
    std::vector<Batch> batches = record_frame(run, input);
    Contest contest(run.backend, input.view.geometry(), batches, input.oracle, run.config.oracle_rays);
    std::vector<Entrant> entrants;
    for (const Contender& c : contenders) {
        const bool yardstick = c.is_yardstick();
        if (yardstick && c.backend == "cpu" && embree_version().empty()) {
            run.note(c.label() + ": left out, this program was built without Embree");
            continue;
        }
        entrants.push_back({run.results.cells.size(),
                            tracer_of(run, input, c),
                            c.restart_carries_t,
                            is_exact(c),
                            // CUDA's yardstick ignores spheres.
                            !yardstick || (c.backend == "cuda" && input.workload.spheres == 0),
                            {}});
        enter(run, cell_of(input, c),
              static_cast<double>(entrants.size()) / static_cast<double>(contenders.size()),
              [&](CellResult& cell) { return contest.verify(entrants.back(), cell); });
    }
    input.in_results.sphere_hit_share = contest.sphere_hit_share();
    run_rounds(run, contest, entrants);
}

void run_frame_contest(const RunContext& run, const ContestInput& input,
                       const std::vector<Contender>& contenders) {
    Renderer renderer = renderer_of(run, input, true);
    FrameContest contest(input.view.geometry(), run.backend, input.oracle, run.config.oracle_rays);
    std::vector<FrameEntrant> entrants;
    for (const Contender& c : contenders) {
        entrants.push_back({run.results.cells.size(), pipeline_of(run, input, renderer, c),
                            c.restart_carries_t, is_exact(c)});
        enter(run, cell_of(input, c),
              static_cast<double>(entrants.size()) / static_cast<double>(contenders.size()),
              [&](CellResult& cell) { return contest.verify(entrants.back(), cell); });
    }
    try {
        run_rounds(run, contest, entrants);
    } catch (const Interrupted&) {
        if (run.config.images) write_images(run, input, entrants);
        throw;
    }
    if (run.config.images) write_images(run, input, entrants);
}

}  // namespace ctpbench
