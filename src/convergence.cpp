#include "convergence.h"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "measure/convergence_contest.h"
#include "measure/frame_contest.h"
#include "wavefront/renderer.h"

namespace ctpbench {
namespace {

// Of a workload's time, for the progress line: where loading and trees end.
constexpr double kLoaded = 0.30;

// A contender's pipeline with a renderer of its own, since each picture has its seed.
class PicturePipeline final : public FramePipeline {
public:
    PicturePipeline(CpuBackend& backend, const ContestInput& input, const Contender& c,
                    const FrameSettings& settings)
        : renderer_(backend, input.view, input.scene.camera, settings),
          pipeline_(renderer_, input.lineup.get(c.strategy, c.methods),
                    make_shader(c.shade, input.view.materials())) {}

    std::vector<StageTime> frame(bool carry_t, std::uint32_t sample, ImageStorage& image,
                                 const BounceObserver& observe) override {
        return pipeline_.frame(carry_t, sample, image, observe);
    }

private:
    Renderer renderer_;
    CpuPipeline pipeline_;
};

class ConvergenceStudy {
public:
    ConvergenceStudy(const RunContext& run, const ContestInput& input,
                     const std::vector<Contender>& contenders)
        : run_(run), input_(input), contenders_(contenders) {
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
            if (!contest.round(round, entrants_, run_.results, [&] { return next_frame(); })) break;
        }
        contest.conclude(entrants_, run_.results);
        stop_if_interrupted();
    }

private:
    const Config& config() const { return run_.config; }

    // Shows that a frame comes next. True after Ctrl-C.
    bool next_frame() {
        run_.progress.step(what_, std::min(kLoaded + (1.0 - kLoaded) * done_++ / frames_, 1.0));
        return interrupted();
    }

    std::uint32_t bounces_of(const Contender& c) const {
        return c.bounce_limit != 0 ? c.bounce_limit : config().bounces;
    }
    FrameSettings settings_of(const Contender& c, std::uint64_t seed) const {
        return {config().width, config().height, bounces_of(c), seed};
    }

    // The seeds of the pictures come first, then those of the reference's two halves.
    ImageStorage reference_half(std::uint32_t half) {
        what_ = "rendering the reference";
        Contender best;
        best.strategy = contenders_.front().strategy, best.methods = Watertight::name, best.shade = "ctp";
        for (const Contender& c : contenders_) best.bounce_limit = std::max(best.bounce_limit, bounces_of(c));
        PicturePipeline pipeline(run_.backend, input_, best,
                                 settings_of(best, config().seed + config().seeds + half));
        ImageStorage image;
        for (std::uint32_t sample = 0; sample < config().reference_samples / 2; ++sample) {
            if (next_frame()) throw Interrupted{};
            pipeline.frame(true, sample, image, {});
        }
        return image;
    }

    std::unique_ptr<FramePipeline> pipeline_of(const Contender& c, std::uint64_t seed) const {
        return std::make_unique<PicturePipeline>(run_.backend, input_, c, settings_of(c, seed));
    }

    // Contenders that must render the same pictures have the same name here. Where hits depend on the tree,
    // each has its own.
    std::string pictures_of(const Contender& c) const {
        if (!is_exact(c)) return c.label();
        return c.backend + "/" + c.methods + c.exchanged() + "/" + std::to_string(bounces_of(c));
    }

    // What is rejected is not rendered any further.
    void enter_all() {
        std::map<std::string, FrameContest> checks;
        for (const Contender& c : contenders_) {
            what_ = "checking " + c.label();
            if (next_frame()) throw Interrupted{};
            CellResult cell = cell_of(input_, c);
            const std::string pictures = pictures_of(c);
            FrameContest& check = checks
                                      .try_emplace(pictures, input_.view.geometry(), run_.backend,
                                                   input_.oracle, config().oracle_rays)
                                      .first->second;
            FrameEntrant checked{run_.results.cells.size(), pipeline_of(c, config().seed),
                                 c.restart_carries_t, is_exact(c)};
            const std::vector<Row> rows = check.verify(checked, cell);
            if (!cell.valid) run_.note(cell.workload.name() + "/" + c.label() + ": rejected: " + cell.reason);
            entrants_.push_back({run_.results.cells.size(),
                                 [this, c](std::uint64_t seed) { return pipeline_of(c, seed); },
                                 c.restart_carries_t, pictures});
            run_.results.cells.push_back(std::move(cell));
            if (!run_.results.cells.back().valid) run_.rows.append(run_.results, rows);
        }
    }

    const RunContext& run_;
    const ContestInput& input_;
    const std::vector<Contender>& contenders_;
    std::vector<ConvergenceEntrant> entrants_;
    std::string what_;
    double done_ = 0.0, frames_;
};

}  // namespace

void run_convergence(const RunContext& run, const ContestInput& input,
                     const std::vector<Contender>& contenders) {
    ConvergenceStudy(run, input, contenders).run();
}

}  // namespace ctpbench
