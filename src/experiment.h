// From a config to rows and tables.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "config/cells.h"
#include "config/config.h"
#include "config/plan.h"
#include "report/progress.h"
#include "scene/load_scene.h"

namespace ctpbench {

// All names that a config may use.
KnownNames known_names();

struct RunOptions {
    std::filesystem::path out;  // empty: results/<run id>
    Folders scene_dirs;
    SceneChoice scenes = SceneChoice::auto_;
    bool quiet = false;
    int device = 0;       // of CUDA
    std::string isa;      // of kernels over packs, one of usable_isas()
    std::string notice;   // to be kept with the results; may be empty
    std::string command;  // recorded, so that the run can be repeated
    Shard shard;
    bool resume = false;  // goes on with the run in `out`, if there is one
    // If any, called after each workload: what is measured then is time, and nobody will look at the results.
    std::function<void(const Workload&, const WorkSeconds&)> on_workload;
};

// Measures the cells and writes rows and tables. Returns oracle if a contender was rejected, interrupted
// after Ctrl-C (what was measured is kept), else ok.
ExitCode run_experiment(const Config& config, const std::vector<Cell>& cells, const RunOptions& options);

}  // namespace ctpbench
