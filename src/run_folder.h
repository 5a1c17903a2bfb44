// The folder that a run writes to: a new one, or that of a run that was cut short and now goes on.
#pragma once

#include <filesystem>
#include <functional>

#include "config/config.h"
#include "report/finished.h"
#include "report/meta.h"

namespace ctpbench {

// What the scene of a workload is now.
using LookAtScene = std::function<SceneResult(const Workload&)>;

// With `resume`, what the folder has of this run is kept: the finished workloads are returned and `run` is
// completed by what was said of it before. Else, or if no run was started there, nothing is kept. Either way
// meta.json then says that the run is running.
//
// Throws Error(output) if the folder cannot be written to or holds another run, and Error(usage), with
// nothing touched, if what it holds could not stand in one table with what would be measured now.
FinishedLog open_run_folder(const std::filesystem::path& folder, const Config& config, RunRecord& run,
                            bool resume, const LookAtScene& look);

}  // namespace ctpbench
