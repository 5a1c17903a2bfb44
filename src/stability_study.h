// The study of stability: every contender on every stress workload that its methods can meet.
#pragma once

#include <vector>

#include "config/cells.h"
#include "report/stability.h"
#include "run_context.h"

namespace ctpbench {

// The workloads that a config may name, and who can meet them.
std::vector<KnownNames::Stress> known_stress();

// One workload with all its contenders. Each row is written as soon as it is found, and kept with the
// results. Throws Interrupted after Ctrl-C.
void run_stability_study(const RunContext& run, const WorkloadCells& cells, StabilityFile& file);

}  // namespace ctpbench
