// meta.json: all that one needs to judge a run's figures and to repeat it.
#pragma once

#include <string>

#include "backends/cuda.h"
#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

std::string meta_json(const Config& config, const Results& results, const std::string& run_id,
                      const std::string& state, const std::string& command, int threads,
                      const CudaDevice* device, const std::string& isa);

}  // namespace ctpbench
