#include "contests.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/clock.h"
#include "kernels/registry.h"
#include "measure/contest.h"
#include "measure/frame_contest.h"
#include "measure/stop_rule.h"
#include "oracle/embree.h"
#include "report/image.h"
#include "report/judgement.h"
#include "report/output_file.h"
#include "scene_exam.h"
#include "wavefront/device_demand.h"
#include "wavefront/methods.h"

namespace ctpbench {
namespace {

// Shares of a workload's time, for the progress line; loading and trees come before.
constexpr double kFrame = 0.45, kVerified = 0.55;

// Verifies an entrant and enters its cell. `verify` returns the rows of an entrant that is rejected.
template <class Verify>
void enter(const RunContext& run, CellResult cell, double share, Verify&& verify) {
    stop_if_interrupted();
    const std::string name = cell.workload.name() + "/" + cell.contender.label();
    run.progress.step("checking " + cell.contender.label(), kFrame + (kVerified - kFrame) * share,
                      Work::rays);
    const std::vector<Row> rows = verify(cell);
    if (!cell.valid) run.note(name + ": rejected: " + cell.reason);
    run.results.cells.push_back(std::move(cell));
    if (!run.results.cells.back().valid) run.rows.append(run.results, rows);
}

template <class Contest, class Entrants>
void run_rounds(const RunContext& run, Contest& contest, Entrants& entrants) {
    const Config& config = run.config;
    const StopRule rule{config.rounds, config.min_time, config.max_noise, config.timeout};
    const auto noise = [&] {
        double widest = 0.0;
        for (const auto& e : entrants)
            widest = std::max(widest, noise_of(run.results.cells[e.cell], run.results, config.reference));
        return widest;
    };
    double seconds = 0.0;
    std::string reason;
    for (std::uint32_t round = 0; reason.empty(); ++round) {
        const bool counted = round < config.rounds;  // else it goes on until the noise is as asked for
        run.progress.step(
            "round " + std::to_string(round + 1) + (counted ? " of " + std::to_string(config.rounds) : ""),
            kVerified + (1.0 - kVerified) * rule.done(round, seconds), Work::round);
        seconds += seconds_of(
            [&] { run.rows.append(run.results, contest.round(round, entrants, run.results, interrupted)); });
        stop_if_interrupted();
        reason = rule.reason(round + 1, seconds, max_rounds, noise);
    }
    for (const auto& e : entrants) run.results.cells[e.cell].stopped_by = reason;
    if (reason != "timeout" && reason != "max_rounds") return;
    char text[64];
    std::snprintf(text, sizeof text, "stopped by %s after %.3g s, noise %.1f %%", reason.c_str(), seconds,
                  100.0 * noise());
    run.note(run.results.cells[entrants.front().cell].workload.name() + ": " + text);
}

bool is_recorded(const Config& config, std::uint32_t bounce) {
    const auto& wanted = config.batch_bounces;
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), bounce) != wanted.end();
}

// Why a contender is left out of the contest; empty if it is not.
std::string obstacle(const Contender& c) {
    if (const std::string why = embree_obstacle(c.strategy); !why.empty()) return why;
    const int allowed = ThreadPools::allowed();
    if (static_cast<int>(c.threads) <= allowed) return {};
    return "this machine allows " + std::to_string(allowed) + (allowed == 1 ? " thread" : " threads");
}

// Without its type. `contender`: of whom; empty: of the first.
std::string picture_name(const Workload& workload, const std::string& contender) {
    std::string name = workload.name() + (contender.empty() ? "" : "--" + contender);
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
}

// What contenders have accumulated: the first valid one's under the workload's name, and under its own name
// too each that differs, as those of other methods and backends do.
void write_images(const RunContext& run, const ContestInput& input,
                  const std::vector<FrameEntrant>& entrants) {
    std::set<std::uint64_t> written;
    for (const FrameEntrant& e : entrants) {
        const CellResult& cell = run.results.cells[e.cell];
        if (!cell.valid || e.image.size() == 0) continue;
        if (!written.insert(e.image.hash()).second) continue;
        run.progress.step("writing the picture", 1.0, Work::rays);
        const std::string name =
            picture_name(input.workload, written.size() == 1 ? "" : cell.contender.label());
        for (const char* type : {".exr", ".png"}) {
            write_image(run.folder / (name + type), run.config.width, run.config.height, e.image,
                        input.scene.exposure);
            sync_file(run.folder / (name + type));
        }
    }
}

}  // namespace

bool is_picture_of(const Workload& workload, const std::string& file) {
    const std::string name = picture_name(workload, "");
    if (!file.ends_with(".exr") && !file.ends_with(".png")) return false;
    return file.starts_with(name + ".") || file.starts_with(name + "--");
}

void record_frame(const RunContext& run, ContestInput& input) {
    run.progress.step("tracing the reference frame", kFrame, Work::rays);
    ImageStorage image;
    const Contender recording = recording_contender(run.config);
    PipelineMaker(run, input)
        .make(recording, frame_settings(run.config, recording))
        ->frame(true, 0, image, [&](const BounceView& view) {
            stop_if_interrupted();
            if (!is_recorded(run.config, view.bounce)) return;
            Batch& batch = input.batches.emplace_back(
                record_batch(view.bounce, view.rays, view.slots, run.config.batch_rays, view.excluded));
            HitStorage found = record_hits(batch, view.hits);
            batch.hit_hash = found.hash();
            if (input.compares) input.found.push_back(std::move(found));
        });
    for (const std::uint32_t bounce : run.config.batch_bounces)
        if (std::none_of(input.batches.begin(), input.batches.end(),
                         [&](const Batch& b) { return b.bounce == bounce; }))
            run.note(input.workload.name() + ": no path reaches bounce " + std::to_string(bounce) +
                     ", so that no rays of it are traced");
    if (input.examined != nullptr) input.batches.push_back(exam_batch(run, input, run.config.stress_rays));
}

std::unique_ptr<CudaWorkload> cuda_workload(const RunContext& run, ContestInput& input,
                                            const std::vector<Contender>& contenders) {
    DeviceDemand demand;
    for (const Contender& c : contenders) {
        if (c.backend != "cuda") continue;
        demand.intersectors.insert({c.strategy, intersect_key(c), intersected_on_device(c.types)});
        if (!c.renders()) continue;
        demand.shaders.push_back({c.shade, c.types, offset_name(c)});
        demand.frames = frame_settings(run.config, c);
        demand.excludes |= offset_name(c) == ExcludeId::name;
    }
    if (demand.intersectors.empty()) return nullptr;
    run.progress.step("counting what the device will hold", kFrame);
    require_device_memory(input.workload.name(), bytes_demanded(demand, input.scenes, input.batches),
                          cuda_memory());
    return make_cuda_workload(input.scenes, input.batches, shade_keys(demand, input.scenes));
}

void run_intersect_contest(const RunContext& run, ContestInput& input,
                           const std::vector<Contender>& contenders) {
    std::span<Batch> recorded(input.batches);
    std::optional<SceneExam> exam;
    if (input.examined != nullptr) {
        run.progress.step("finding the exam's answers", kFrame, Work::rays);
        exam.emplace(run, input, *input.examined, recorded.back());
        recorded = recorded.first(recorded.size() - 1);
    }
    std::optional<HitComparison> comparison;
    if (input.compares) comparison.emplace(run.backend, input.view.geometry(), input.found);
    Contest contest(run.backend, input.view.geometry(), recorded, input.oracle, run.config.oracle_rays,
                    comparison ? &*comparison : nullptr);
    std::vector<Entrant> entrants;
    for (const Contender& c : contenders) {
        const bool yardstick = c.is_yardstick();
        if (const std::string why = obstacle(c); !why.empty()) {
            run.note(c.label() + ": left out, " + why);
            continue;
        }
        entrants.push_back(
            {run.results.cells.size(),
             tracer_of(run, input, c),
             c.restart_carries_t,
             is_exact(c) ? intersect_key(c) : "",
             // CUDA's yardstick ignores spheres. Where failures are counted, methods that
             // are known to fail are there to be timed all the same.
             yardstick ? c.backend == "cuda" && input.workload.spheres == 0 : !exam || is_exact(c),
             {}});
        enter(run, cell_of(input, c),
              static_cast<double>(entrants.size()) / static_cast<double>(contenders.size()),
              [&](CellResult& cell) {
                  std::vector<Row> rows = contest.verify(entrants.back(), cell);
                  if (exam) cell.accuracy = exam->take(*entrants.back().tracer);
                  if (c.backend == "cpu")
                      cell.layout_bytes =
                          input.lineup.get(c.strategy, intersect_key(c), c.types, c.traversal).bytes();
                  return rows;
              });
    }
    input.in_results.sphere_hit_share = contest.sphere_hit_share();
    run_rounds(run, contest, entrants);
}

void run_frame_contest(const RunContext& run, const ContestInput& input,
                       const std::vector<Contender>& contenders) {
    PipelineMaker pipelines(run, input);
    FrameContest contest(input.view.geometry(), run.backend, input.oracle, run.config.oracle_rays);
    std::vector<FrameEntrant> entrants;
    for (const Contender& c : contenders) {
        FrameSettings settings = frame_settings(run.config, c);
        settings.copies = true;
        entrants.push_back(
            {run.results.cells.size(), pipelines.make(c, settings), c.restart_carries_t, is_exact(c)});
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
