// The study of convergence on one workload: how the error of a contender's pictures falls with the time spent
// on them, and to what.
#pragma once

#include <vector>

#include "entrants.h"

namespace ctpbench {

// Renders the reference, checks every contender, then renders `seeds` pictures of each. Throws Interrupted
// after Ctrl-C, with the finished seeds kept.
void run_convergence(const RunContext& run, const ContestInput& input,
                     const std::vector<Contender>& contenders);

}  // namespace ctpbench
