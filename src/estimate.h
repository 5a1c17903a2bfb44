// How long a run would take. No model of machine and scene is within a factor of two, so a small part of the
// run is measured: every workload is loaded and its trees are built, then fewer pixels and rays are traced,
// in one round, by the very code that the run would go through. What grows with rays, rounds and frames is
// then multiplied.
#pragma once

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "config/cells.h"
#include "config/config.h"
#include "experiment.h"

namespace ctpbench {

// How much smaller the measured part is than the run: pixels and rays by `shrink`, the rest by its own.
struct Pilot {
    Config config;
    double rays = 1.0, rounds = 1.0, references = 1.0;

    double least = 0.0, most = 0.0;  // seconds of rounds; most 0: no limit

    // Of a workload.
    double seconds(const WorkSeconds& measured) const {
        double in_rounds = std::max(rays * rounds * measured.round, least);
        if (most > 0.0) in_rounds = std::min(in_rounds, most);
        return measured.once + rays * (measured.rays + references * measured.reference) + in_rounds;
    }
};
Pilot pilot_of(const Config& config, const std::vector<Cell>& cells, int threads);

// For --dry-run: prints the cells of the share, then, as it is measured, the time of each workload and of all
// of them. Without a device it says why there is no estimate. Writes nothing that stays.
ExitCode estimate(const Config& config, const std::vector<Cell>& cells, RunOptions options);

}  // namespace ctpbench
