// The tables of a run, all from what it measured; a run that was resumed or merged writes those that an
// unbroken one would have written.
#pragma once

#include <filesystem>

#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

// `threads`: of those contenders that do not ask for a number of their own.
void write_tables(const std::filesystem::path& folder, const Config& config, const Results& results,
                  int threads);

}  // namespace ctpbench
