// How much memory there is left, and refusing up front what would not fit: the kernel would rather end this
// process, or another, than say no to an allocation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace ctpbench {

// Bytes that this process may still take: what the machine has left, or its control group if that is less.
// Where the system does not say, all that can be addressed. `root` is where /proc and /sys lie.
std::uint64_t available_memory_bytes(const std::filesystem::path& root = "/");

// Throws Error(usage) that names both numbers if there are fewer bytes than that: `what` needs them, and
// `remedy` says how it needs less.
void require_memory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace ctpbench
