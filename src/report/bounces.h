// What tables over recorded bounces share: which bounces there are, what they are called, who has them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "measure/results.h"

namespace ctpbench {

// The scene, with what else tells its workloads apart: `conference`, `smoke/200`.
std::string scene_of(const Workload& workload);

// primary for the camera's rays, else bounce1 and so on.
std::string rays_of(std::uint32_t bounce);

// Null unless `cell` is there, was accepted, and timed these recorded rays on the CPU.
const BounceSeries* cpu_series(const CellResult* cell, std::uint32_t bounce);

// As many threads as the contender asks for; else the run's.
std::string threads_of(const Contender& contender, int threads);

// Who it is, whatever its number of threads.
std::string label_without_threads(Contender contender);

// The workloads and bounces that are there, each once, in order of appearance.
std::vector<std::pair<Workload, std::uint32_t>> recorded_bounces(const Results& results);

}  // namespace ctpbench
