// meta.json: all that one needs to judge a run's figures, to repeat it and to go on with it.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "backends/cuda.h"
#include "config/config.h"
#include "config/plan.h"
#include "measure/results.h"

namespace ctpbench {

inline constexpr int kMetaSchemaVersion = 1;  // of meta.json and of the files that lie beside it

// That a run was taken up again after it had been cut short.
struct Resumption {
    std::string command;
    std::size_t workloads_kept = 0;
};

// What a run is, before anything is measured.
struct RunRecord {
    std::string run_id;
    std::string command;
    std::vector<Resumption> resumed{};
    Shard shard{};
    std::vector<PlannedWorkload> workloads{};  // of all shards
    int threads = 0;
    std::string isa;                     // of kernels over packs
    std::optional<CudaDevice> device{};  // none: no cell is for CUDA
};

// `state` is running, interrupted or complete.
nlohmann::json meta_of(const Config& config, const RunRecord& run, const Results& results,
                       const std::string& state);
void write_meta(const std::filesystem::path& folder, const nlohmann::json& meta);

}  // namespace ctpbench
