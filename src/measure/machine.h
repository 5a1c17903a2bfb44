// What this machine is and what it is doing, for meta.json.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace ctpbench {

nlohmann::json describe_machine();

// What the compiler, its flags and the libraries were.
nlohmann::json describe_build();

// Largest resident size of this process so far, bytes.
std::size_t peak_memory_bytes();

}  // namespace ctpbench
