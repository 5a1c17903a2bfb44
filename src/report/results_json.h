// What a run measured as JSON and back, nothing lost: tables that are made from what was read back are those
// that the run itself would have written.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "measure/results.h"

namespace ctpbench {

nlohmann::json results_to_json(const Results& results);

// Throws nlohmann::json::exception if it is not what results_to_json() gave.
Results results_from_json(const nlohmann::json& json);

}  // namespace ctpbench
