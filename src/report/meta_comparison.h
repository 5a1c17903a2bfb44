// Whether two processes measure the same: what their meta.json say beside each other.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace ctpbench {

// Throws Error(usage) if the folder has none that can be read.
nlohmann::json read_meta(const std::filesystem::path& folder);

// What rows of one table have in common: schema, config, cells, threads, instruction set and program. A line
// for each that differs: `/config/rounds: 3 there, 5 here`.
std::vector<std::string> differences(const nlohmann::json& there, const nlohmann::json& here);

// What rows of one run have in common beyond that: machine and share.
std::vector<std::string> differences_of_machine(const nlohmann::json& there, const nlohmann::json& here);

}  // namespace ctpbench
