#include "report/health.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

namespace ctpbench {
namespace {

using State = Diagnosis::State;
using nlohmann::json;

constexpr double kGiB = 1 << 30;
constexpr double kLeastMemory = 4 * kGiB;  // of which a large scene takes half while its trees are built
constexpr double kBusy = 0.25;             // load per core that disturbs
constexpr double kStolen = 0.01;
constexpr double kCoarseClock = 1e-6;  // seconds; kernels take milliseconds

std::string text_of(const json& object, const char* key) {
    const json& value = object.at(key);
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string shown(double value, const char* format = "%.3g") {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

Diagnosis judged(bool good, const char* what, const std::string& detail, const std::string& remedy) {
    if (good) return {State::ok, what, detail};
    return {State::warning, what, detail, remedy};
}

// Cores that the quota is worth: "200000 100000" is two; without one, all.
double quota_of(const json& machine) {
    std::istringstream text(text_of(machine, "cgroup_cpu_max"));
    double quota = 0, period = 0;
    return text >> quota >> period && period > 0 ? quota / period : INFINITY;
}

Diagnosis governor_of(const json& machine) {
    const std::string name = text_of(machine, "governor");
    if (name.empty()) return {State::ok, "governor", "not to be seen here, as usual in a virtual machine"};
    return judged(name == "performance", "governor", name,
                  "clocks vary with load; cpupower frequency-set -g performance");
}

// `always [madvise] never`: the one in brackets.
Diagnosis huge_pages_of(const json& machine) {
    const std::string modes = text_of(machine, "transparent_huge_pages");
    const std::size_t begin = modes.find('['), end = modes.find(']');
    const std::string mode =
        begin < end && end != std::string::npos ? modes.substr(begin + 1, end - begin - 1) : "none";
    return judged(mode == "always" || mode == "madvise", "huge pages", mode,
                  "trees are built and traversed more slowly; echo madvise > "
                  "/sys/kernel/mm/transparent_hugepage/enabled");
}

}  // namespace

std::vector<Diagnosis> examine_build(const json& build) {
    const std::string type = text_of(build, "build_type"), commit = text_of(build, "git_commit");
    std::vector<Diagnosis> diagnoses;
    diagnoses.push_back({State::ok, "compiler", text_of(build, "compiler")});
    diagnoses.push_back(judged(type == "Release", "build type", type,
                               "figures of this build mean nothing; build with cmake --preset release"));
    diagnoses.push_back(judged(commit != "unknown" && !build.at("git_dirty").get<bool>(), "git",
                               commit.substr(0, 12) + (build.at("git_dirty").get<bool>() ? ", changed" : ""),
                               "results do not say what made them; build from a clean commit"));
    const std::string embree = text_of(build, "embree");
    diagnoses.push_back(embree.empty()
                            ? Diagnosis{State::missing, "Embree", "not compiled in: no oracle, no yardstick",
                                        "apt-get install libembree-dev, and build again"}
                            : Diagnosis{State::ok, "Embree", embree});
    return diagnoses;
}

std::vector<Diagnosis> examine_machine(const json& machine) {
    const double cores = machine.at("cores"), quota = quota_of(machine);
    const double load = machine.at("load_1min").is_null() ? 0.0 : machine.at("load_1min").get<double>();
    const double steal = machine.at("steal_share_since_boot");
    const double total = machine.at("memory_bytes"), left = machine.at("memory_available_bytes");
    const double step = machine.at("clock_step_seconds");
    return {
        {State::ok, "processor", text_of(machine, "cpu") + ", " + shown(cores) + " cores"},
        judged(quota >= cores, "cpu quota", quota < cores ? shown(quota) + " cores" : "none",
               "threads are halted when it is used up; run with --threads " +
                   shown(std::max(1.0, std::floor(quota)), "%.0f")),
        governor_of(machine),
        huge_pages_of(machine),
        judged(left >= kLeastMemory, "memory",
               shown(left / kGiB) + " of " + shown(total / kGiB) + " GiB free",
               "large scenes may not fit; end other programs, or leave out san_miguel"),
        judged(load <= kBusy * cores, "load", shown(load) + " on " + shown(cores) + " cores",
               "stop other work, or expect wide intervals"),
        judged(steal <= kStolen, "steal", shown(100 * steal) + " % of the time since boot",
               "other virtual machines take this one's time; expect wide intervals"),
        judged(step <= kCoarseClock, "clock", "steps of " + shown(step * 1e9) + " ns",
               "short kernels cannot be timed; see /sys/devices/system/clocksource"),
    };
}

std::string diagnoses_text(const std::vector<Diagnosis>& diagnoses) {
    std::size_t widest = 0;
    for (const Diagnosis& f : diagnoses) widest = std::max(widest, f.what.size());
    std::string text;
    for (const Diagnosis& f : diagnoses) {
        const char* state = f.state == State::ok ? "ok" : f.state == State::warning ? "warning" : "missing";
        char line[64];
        std::snprintf(line, sizeof line, "%-7s  %-*.*s  ", state,
                      static_cast<int>(std::min(widest, std::size_t{40})), 40, f.what.c_str());
        text += line + f.detail + (f.remedy.empty() ? "" : ": " + f.remedy) + "\n";
    }
    return text;
}

ExitCode exit_code_of(const std::vector<Diagnosis>& diagnoses) {
    for (const Diagnosis& f : diagnoses)
        if (f.failure) return *f.failure;
    return ExitCode::ok;
}

}  // namespace ctpbench
