#include "estimate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "backends/thread_pools.h"
#include "base/clock.h"
#include "report/duration.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kLargestStep = 8;  // by which each side of the picture is divided
// Below these a batch is too small for its threads, and a picture for its batches.
constexpr double kFewestRays = 16384.0, kFewestPixels = 262144.0;
// Of a convergence study's pictures: the frames that are rendered besides warm up the pipeline.
constexpr std::uint32_t kPilotSamples = 4;

// A folder that goes with the object.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = (fs::temp_directory_path() / "ctpbench-dry-run-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw Error(ExitCode::output, pattern + ": error: cannot be made; name another folder in TMPDIR");
        path_ = pattern;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

// By how much each side of the picture is divided.
std::uint32_t step_of(const Config& config, const std::vector<Cell>& cells, int threads) {
    if (any_on_cuda(cells)) return 1;  // a device that is not full takes as long
    const double pixels = double(config.width) * config.height;
    const double rays = config.study == Study::stability ? config.stress_rays
                        : config.batch_rays == 0         ? pixels
                                                         : config.batch_rays;
    const double fewest_rays = kFewestRays * std::max(1, threads / 2);
    std::uint32_t step = 1;
    while (step < kLargestStep) {
        const double next = double(step + 1) * (step + 1);
        if (rays / next < fewest_rays) break;
        if (config.study != Study::stability && pixels / next < kFewestPixels) break;
        ++step;
    }
    return step;
}

// `12.3 s`, `2:03`
std::string shown(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", seconds);
    return seconds < 60.0 ? text : duration(seconds);
}

}  // namespace

Pilot pilot_of(const Config& config, const std::vector<Cell>& cells, int threads) {
    Pilot pilot;
    Config& small = pilot.config = config;
    const std::uint32_t step = step_of(config, cells, threads);
    small.width = std::max(1u, config.width / step), small.height = std::max(1u, config.height / step);
    pilot.rays = config.study == Study::stability
                     ? double(step) * step
                     : double(config.width) * config.height / (double(small.width) * small.height);
    const auto fewer = [&](std::uint32_t n) {
        return n == 0 ? 0 : std::max(1u, static_cast<std::uint32_t>(std::lround(n / pilot.rays)));
    };
    small.batch_rays = fewer(config.batch_rays), small.oracle_rays = fewer(config.oracle_rays);
    small.stress_rays = fewer(config.stress_rays);
    small.rounds = 1, pilot.rounds = config.rounds;
    small.min_time = small.max_noise = small.timeout = 0.0;
    pilot.least = config.min_time, pilot.most = config.timeout;
    if (config.study == Study::convergence) {
        small.seeds = 1, small.samples = std::min(config.samples, kPilotSamples), small.reference_samples = 2;
        // One frame more of each picture touches its memory.
        pilot.rounds = double(config.seeds) * (config.samples + 1.0) / (small.samples + 1.0);
        pilot.references = config.reference_samples / 2.0;
    }
    return pilot;
}

ExitCode estimate(const Config& config, const std::vector<Cell>& cells, RunOptions options) {
    const std::vector<Cell> ours = cells_of(options.shard, cells);
    std::printf("%s\n", format_cells(ours).c_str());
    std::fflush(stdout);
    const CpuBackend backend(static_cast<int>(config.threads));
    const Pilot pilot = pilot_of(config, ours, backend.threads());
    const ScratchFolder scratch;
    double total = 0.0, in_workloads = 0.0;
    options.on_workload = [&](const Workload& workload, const WorkSeconds& measured) {
        const double seconds = pilot.seconds(measured);
        total += seconds, in_workloads += measured.total();
        std::printf("%-32s about %9s, of it scene and trees %s\n", workload.name().c_str(),
                    shown(seconds).c_str(), shown(measured.once).c_str());
        std::fflush(stdout);
    };
    options.out = scratch.path(), options.resume = false, options.shard = {}, options.quiet = true;
    try {
        double taken = 0.0;
        ExitCode code = ExitCode::ok;
        if (!ours.empty()) taken = seconds_of([&] { code = run_experiment(pilot.config, ours, options); });
        if (code == ExitCode::interrupted) return code;
        total += taken - in_workloads;  // tables, and what else a run does once
        std::printf("%-32s about %9s, estimated in %s from one round with 1/%.0f of the rays\n", "all",
                    shown(total).c_str(), shown(taken).c_str(), pilot.rays);
        if (config.max_noise > 0.0) std::printf("rounds go on beyond that until the noise is as asked for\n");
    } catch (const Error& error) {
        if (error.code() != ExitCode::no_backend) throw;
        std::printf("no estimate: %s\n", error.what());
    }
    return ExitCode::ok;
}

}  // namespace ctpbench
