// One run's results from those of its shards.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace ctpbench {

// Writes to `out` what one process would have written that had measured all of them. Throws Error(usage),
// with everything that is wrong, if they are not shards of one run (other schema, config, cells or program),
// of the same scenes, each workload finished in one of them. Machines may differ, which is noted. Returns
// oracle if a contender was rejected, else ok.
ExitCode merge_runs(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
                    const std::string& command);

}  // namespace ctpbench
