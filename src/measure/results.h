// What a run measured, in the shape that tables are made from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/cells.h"
#include "kernels/interleaved/profile.h"
#include "measure/bounded_value.h"
#include "measure/exam.h"
#include "scene/columns.h"
#include "scene/needs.h"

namespace ctpbench {

// One timing: a repetition of a kernel on the rays of one bounce.
struct Row {
    std::size_t cell = 0;  // in Results::cells
    std::string kernel;
    std::uint32_t bounce = 0;
    std::uint32_t round = 0;
    std::uint32_t active_rays = 0;  // paths active at this bounce in the whole frame
    std::uint32_t rays = 0;         // rays timed
    double seconds = 0.0;
    std::uint64_t hit_hash = 0;    // of an intersect contest; 0 otherwise
    std::uint32_t dropped = 0;     // samples of a direction in which nothing is reflected; they count as 0
    std::uint32_t clamped = 0;     // samples that were no number, infinite or negative; they count as 0
    std::uint64_t image_hash = 0;  // of the image so far, in rows of the blend kernel
    double start_seconds = -1.0;   // after the frame's first kernel began; negative: not known

    double mrays_per_second() const { return seconds > 0.0 ? rays / seconds * 1e-6 : 0.0; }
};

// What was measured of one kernel of a contender, by round.
struct KernelSeries {
    std::string kernel;
    std::uint64_t rays = 0;       // timed in a round
    std::vector<double> mrays;    // Mrays/s over all bounces
    std::vector<double> seconds;  // of the frame
};

// What was measured of a contender on the recorded rays of one bounce.
struct BounceSeries {
    std::uint32_t bounce = 0;
    std::vector<double> mrays;  // Mrays/s, by round
    Verdict against_reference;  // its hits beside those that the rays' own frame found; no rays: not compared
};

// How the error of a contender's pictures falls. By seed, then by k: after 2^k samples per pixel.
struct Convergence {
    std::vector<std::vector<double>> seconds, relmse;
    BoundedValue bias;  // squared and relative, as relMSE is: what remains of it after any number of samples
};

// One contender on one workload.
struct CellResult {
    Workload workload;
    Contender contender;
    std::string scene_source;  // "mesh" or "stand-in"
    std::size_t triangles = 0;
    bool checked = false;  // an oracle looked at its hits
    bool valid = false;
    std::string reason;  // why it is not valid
    Verdict verdict;
    std::optional<Accuracy> accuracy;                    // where failures are counted beside the speed
    std::vector<KernelSeries> kernels;                   // in the order of the pipeline
    std::vector<BounceSeries> bounces;                   // of recorded rays, in the order of the batches
    std::size_t layout_bytes = 0;                        // on a CPU, beside the trees; 0: not known
    std::string stopped_by;                              // what ended its rounds; empty: they did not end
    std::uint64_t image_hash = 0;                        // of a frame contest, after the last whole round
    std::uint32_t samples = 0;                           // per pixel in that image
    std::uint64_t shaded = 0, dropped = 0, clamped = 0;  // over all rounds
    Convergence convergence{};                           // of that study alone

    double dropped_per_million() const {
        return shaded == 0 ? 0.0 : 1e6 * static_cast<double>(dropped) / static_cast<double>(shaded);
    }

    const KernelSeries* find(std::string_view kernel) const {
        for (const KernelSeries& k : kernels)
            if (k.kernel == kernel) return &k;
        return nullptr;
    }
    // Appends a round.
    void add(std::string_view kernel, std::uint64_t rays, double mrays, double seconds) {
        auto k = std::find_if(kernels.begin(), kernels.end(),
                              [&](const KernelSeries& s) { return s.kernel == kernel; });
        if (k == kernels.end()) k = kernels.insert(k, {std::string(kernel), rays, {}, {}});
        k->mrays.push_back(mrays), k->seconds.push_back(seconds);
    }

    // For tables: "true", "false", or "unchecked" where there was no oracle to ask.
    const char* validity() const { return !valid ? "false" : checked ? "true" : "unchecked"; }
};

// One tree that was built, ours or Embree's.
struct TreeResult {
    Workload workload;
    std::string kind;  // mixed, typed_leaves, triangles, spheres, embree_robust, ...
    std::size_t primitives = 0;
    std::size_t nodes = 0, references = 0;  // 0 where the builder does not tell
    std::uint32_t depth = 0;
    float sah = 0.0f;
    double build_seconds = 0.0;
    std::size_t bytes = 0;
    std::uint64_t hash = 0;
};

// A scene as it was measured.
struct SceneResult {
    std::string name;
    std::uint32_t spheres = 0;
    std::string source;
    std::size_t triangles = 0, dropped_triangles = 0;
    std::uint64_t hash = 0;       // of its content
    std::uint64_t base_hash = 0;  // of what it has in common with the same scene with other spheres
    SceneNeeds needs;
    SceneSavings savings;
    std::vector<SceneColumn> columns;
    double sphere_hit_share = 0.0;  // of the rays that hit anything, over all bounces
};

// What rays in flight do with the rays of one bounce.
struct ProfileResult {
    Workload workload;
    std::uint32_t bounce = 0;
    std::uint64_t rays = 0;
    std::string isa;
    FlightProfile profile;
};

// One method on one stress workload. Kind and method are what the config calls them (Contender::kind(),
// method()).
struct StabilityRow {
    std::string kind, method, backend;
    bool is_default;  // whether it is what a run uses that asks for nothing else
    std::string workload;
    Accuracy accuracy;
};

struct Results {
    std::vector<CellResult> cells;
    std::vector<ProfileResult> profiles;
    std::vector<TreeResult> trees;
    std::vector<SceneResult> scenes;
    std::vector<StabilityRow> stability;  // of that study alone
    std::vector<std::string> notices;     // each once

    const CellResult* find(const Workload& workload, const std::string& label) const {
        for (const CellResult& c : cells)
            if (c.workload == workload && c.contender.label() == label) return &c;
        return nullptr;
    }
};

}  // namespace ctpbench
