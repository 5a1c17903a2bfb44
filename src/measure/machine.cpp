#include "measure/machine.h"

#include <oneapi/tbb/version.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

#include "base/hash.h"
#include "base/memory.h"
#include "build_info.h"
#include "oracle/embree.h"
#include "scene/mapped_file.h"

namespace ctpbench {
namespace {

std::string first_line(const char* path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

// The value of the first "key : value" line of /proc/cpuinfo.
std::string cpuinfo(const std::string& key) {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind(key, 0) == 0 && line.find(':') != std::string::npos) {
            const std::size_t at = line.find_first_not_of(" \t", line.find(':') + 1);
            return at == std::string::npos ? "" : line.substr(at);
        }
    return {};
}

// Share of processor time that the hypervisor has given to others since boot.
double steal_share() {
    std::ifstream file("/proc/stat");
    std::string cpu;
    file >> cpu;
    double total = 0.0, steal = 0.0, value = 0.0;
    for (int i = 0; i < 8 && file >> value; ++i) {
        total += value;
        if (i == 7) steal = value;
    }
    return total > 0.0 ? steal / total : 0.0;
}

// The shortest time that the clock of measurements tells from none.
double clock_step_seconds() {
    using Clock = std::chrono::steady_clock;
    Clock::duration least = Clock::duration::max();
    for (int i = 0; i < 1000; ++i) {
        const auto start = Clock::now();
        auto now = start;
        while (now == start) now = Clock::now();
        least = std::min(least, now - start);
    }
    return std::chrono::duration<double>(least).count();
}

bool flushes_denormals() {
#if defined(__SSE__)
    return (_mm_getcsr() & 0x8040u) != 0;  // FTZ is bit 15, DAZ bit 6
#else
    return false;
#endif
}

// Of the executable: a commit does not tell builds apart that were changed since.
std::string program_hash() {
    const MappedFile program("/proc/self/exe");
    return hex(hash_bytes(program.bytes().data(), program.bytes().size()));
}

}  // namespace

nlohmann::json describe_machine() {
    utsname system{};
    uname(&system);
    double load[1] = {0.0};
    if (getloadavg(load, 1) != 1) load[0] = std::nan("");
    nlohmann::json machine = {
        {"cpu", cpuinfo("model name")},
        // Hypervisors shorten the name; the numbers are the processor's own.
        {"cpu_model", cpuinfo("cpu family") + "-" + cpuinfo("model\t") + "-" + cpuinfo("stepping")},
        {"isa_flags", cpuinfo("flags")},
        {"cores", std::thread::hardware_concurrency()},
        {"governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")},
        {"cgroup_cpu_max", first_line("/sys/fs/cgroup/cpu.max")},
        {"memory_bytes",
         static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE))},
        {"memory_available_bytes", available_memory_bytes()},
        {"transparent_huge_pages", first_line("/sys/kernel/mm/transparent_hugepage/enabled")},
        {"clock_step_seconds", clock_step_seconds()},
        {"load_1min", load[0]},
        {"steal_share_since_boot", steal_share()},
        {"system", std::string(system.sysname) + " " + system.release + " " + system.machine},
        {"flush_denormals", flushes_denormals()},
    };
    return machine;
}

nlohmann::json describe_build() {
    static const std::string program = program_hash();
    return {
        {"version", CTPBENCH_VERSION},
        {"git_commit", CTPBENCH_GIT_COMMIT},
        {"git_dirty", CTPBENCH_GIT_DIRTY},
        {"program", program},
        {"compiler", CTPBENCH_COMPILER},
        {"flags", CTPBENCH_COMPILE_FLAGS},
        {"build_type", CTPBENCH_BUILD_TYPE},
        {"embree", embree_version()},
        {"onetbb", TBB_VERSION_STRING},
        {"nlohmann_json", std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
                              std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
                              std::to_string(NLOHMANN_JSON_VERSION_PATCH)},
    };
}

std::size_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace ctpbench
