// What a run is to do: its workloads, each with a hash by which a later process knows it again, and which of
// them are this process' share.
//
// A workload with all its contenders is what is finished, resumed and shared out as one. Its contenders are
// measured in the same rounds, so that what slows the machine slows them all; measured apart, their ratios
// would compare two moments of the machine.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/cells.h"

namespace ctpbench {

struct PlannedWorkload {
    WorkloadCells cells;
    std::string hash;  // of all that its rows depend on but the scene's content, the program and the machine
};

// In the order of the cells. `isa` is that of kernels over packs, `threads` that of the run.
std::vector<PlannedWorkload> plan(const Config& config, const std::vector<Cell>& cells,
                                  const std::string& isa, int threads);

// Share `index` of `count`, from 1: every count-th workload, so that neighbours, which tend to be alike, go
// to different shares.
struct Shard {
    std::uint32_t index = 1, count = 1;

    std::string text() const { return std::to_string(index) + "/" + std::to_string(count); }
    bool has(std::size_t workload) const { return workload % count == index - 1; }
    bool operator==(const Shard&) const = default;
};

// Reads `2/8`. Throws Error(usage).
Shard parse_shard(const std::string& text);

// The cells of its workloads.
std::vector<Cell> cells_of(const Shard& shard, const std::vector<Cell>& cells);

}  // namespace ctpbench
