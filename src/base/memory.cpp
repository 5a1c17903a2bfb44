#include "base/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>

#include "base/error.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

// The number that a file holds; "max", or no file, is no limit.
std::uint64_t number_in(const fs::path& path) {
    std::uint64_t number = 0;
    return std::ifstream(path) >> number ? number : kNoLimit;
}

std::uint64_t left_in_machine(const fs::path& root) {
    std::ifstream file(root / "proc/meminfo");
    for (std::string key; file >> key;) {
        std::uint64_t kib = 0;
        if (key == "MemAvailable:" && file >> kib) return kib * 1024;
        file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return kNoLimit;
}

// Of every group from the process' own up to the root; version 2 of control groups.
std::uint64_t left_in_groups(const fs::path& root) {
    std::ifstream file(root / "proc/self/cgroup");
    std::uint64_t left = kNoLimit;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("0::/")) continue;
        for (fs::path group = line.substr(4);; group = group.parent_path()) {
            const fs::path folder = root / "sys/fs/cgroup" / group;
            const std::uint64_t most = number_in(folder / "memory.max");
            const std::uint64_t used = number_in(folder / "memory.current");
            if (most != kNoLimit && used != kNoLimit) left = std::min(left, most - std::min(most, used));
            if (group.empty()) break;
        }
    }
    return left;
}

}  // namespace

std::uint64_t available_memory_bytes(const fs::path& root) {
    return std::min(left_in_machine(root), left_in_groups(root));
}

void require_memory(double bytes, const std::string& what, const std::string& remedy) {
    const std::uint64_t left = available_memory_bytes();
    if (bytes <= static_cast<double>(left)) return;
    throw Error(ExitCode::usage, what + ": error: needs about " +
                                     std::to_string(static_cast<std::uint64_t>(bytes)) + " bytes, but only " +
                                     std::to_string(left) + " are free here; " + remedy);
}

}  // namespace ctpbench
