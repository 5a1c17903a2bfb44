#include "convergence.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "kernels/registry.h"
#include "measure/convergence_contest.h"
#include "measure/frame_contest.h"

namespace ctpbench {
namespace {

// Of a workload's time, for the progress line: where loading and trees end.
constexpr double kLoaded = 0.30;

class ConvergenceStudy {
public:
    ConvergenceStudy(const RunContext& run, const ContestInput& input,
                     const std::vector<Contender>& contenders)
        : run_(run), input_(input), contenders_(contenders), pipelines_(run, input) {
        const Config& c = run.config;
        frames_ = c.reference_samples / 2 * 2.0 + contenders.size() * c.seeds * double(c.samples);
    }

    void run() {
        const ReferenceImage reference(reference_half(0), reference_half(1));
        ConvergenceContest contest(reference, static_cast<std::uint32_t>(std::countr_zero(config().samples)),
                                   config().seed);
        enter_all();
        for (std::uint32_t round = 0; round < config().seeds; ++round) {
            what_ = "seed " + std::to_string(round + 1) + " of " + std::to_string(config().seeds);
            work_ = Work::round;
            if (!contest.round(round, entrants_, run_.results, [&] { return next_frame(); })) break;
        }
        contest.conclude(entrants_, run_.results);
        stop_if_interrupted();
    }

private:
    const Config& config() const { return run_.config; }

    // Shows that a frame comes next. True after Ctrl-C.
    bool next_frame() {
        run_.progress.step(what_, std::min(kLoaded + (1.0 - kLoaded) * done_++ / frames_, 1.0), work_);
        return interrupted();
    }

    std::unique_ptr<FramePipeline> pipeline_of(const Contender& c, std::uint64_t seed) {
        FrameSettings settings = frame_settings(config(), c);
        settings.seed = seed;
        return pipelines_.make(c, settings);
    }

    // The default methods, and as many bounces as any contender has. The seeds of the pictures come first,
    // then those of the reference's two halves.
    ImageStorage reference_half(std::uint32_t half) {
        what_ = "rendering the reference", work_ = Work::reference;
        Contender best;
        best.backend = "cpu", best.strategy = contenders_.front().strategy;
        best.methods = Watertight::name, best.shade = kRecordingShade;
        for (const Contender& c : contenders_)
            best.bounce_limit = std::max(best.bounce_limit, frame_settings(config(), c).bounces);
        const auto pipeline = pipeline_of(best, config().seed + config().seeds + half);
        ImageStorage image;
        for (std::uint32_t sample = 0; sample < config().reference_samples / 2; ++sample) {
            if (next_frame()) throw Interrupted{};
            pipeline->frame(true, sample, image, {});
        }
        return image;
    }

    // What is rejected is not rendered any further.
    void enter_all() {
        FrameContest check(input_.view.geometry(), run_.backend, input_.oracle, config().oracle_rays);
        for (const Contender& c : contenders_) {
            what_ = "checking " + c.label(), work_ = Work::rays;
            if (next_frame()) throw Interrupted{};
            CellResult cell = cell_of(input_, c);
            const std::size_t number = run_.results.cells.size();
            FrameEntrant checked{number, pipeline_of(c, config().seed), c.restart_carries_t, is_exact(c)};
            const std::vector<Row> rows = check.verify(checked, cell);
            if (!cell.valid) run_.note(cell.workload.name() + "/" + c.label() + ": rejected: " + cell.reason);
            entrants_.push_back({number, [this, c](std::uint64_t seed) { return pipeline_of(c, seed); },
                                 c.restart_carries_t, pictures_of(c, is_exact(c))});
            run_.results.cells.push_back(std::move(cell));
            if (!run_.results.cells.back().valid) run_.rows.append(run_.results, rows);
        }
    }

    const RunContext& run_;
    const ContestInput& input_;
    const std::vector<Contender>& contenders_;
    PipelineMaker pipelines_;
    std::vector<ConvergenceEntrant> entrants_;
    std::string what_;
    Work work_ = Work::reference;
    double done_ = 0.0, frames_;
};

}  // namespace

void run_convergence(const RunContext& run, const ContestInput& input,
                     const std::vector<Contender>& contenders) {
    ConvergenceStudy(run, input, contenders).run();
}

}  // namespace ctpbench
