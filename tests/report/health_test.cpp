#include "report/health.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "measure/machine.h"

namespace ctpbench {
namespace {

using State = Diagnosis::State;
using nlohmann::json;

json quiet_machine() {
    return {{"cpu", "a processor"},
            {"cores", 4},
            {"governor", "performance"},
            {"cgroup_cpu_max", "max 100000"},
            {"memory_bytes", 64e9},
            {"memory_available_bytes", 32e9},
            {"transparent_huge_pages", "always [madvise] never"},
            {"clock_step_seconds", 2e-8},
            {"load_1min", 0.5},
            {"steal_share_since_boot", 0.0}};
}

Diagnosis diagnosis(const std::vector<Diagnosis>& all, const std::string& what) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Diagnosis& f) { return f.what == what; });
    EXPECT_NE(found, all.end()) << what;
    return found == all.end() ? Diagnosis{} : *found;
}

TEST(Health, OfAQuietMachineIsGood) {
    for (const Diagnosis& f : examine_machine(quiet_machine())) EXPECT_EQ(f.state, State::ok) << f.what;
}

TEST(Health, NamesWhatDisturbsMeasurementsAndTheRemedy) {
    const struct {
        const char *key, *what;
        json value;
        const char* remedy;
    } cases[] = {{"cgroup_cpu_max", "cpu quota", "250000 100000", "--threads 2"},
                 {"cgroup_cpu_max", "cpu quota", "50000 100000", "--threads 1"},
                 {"governor", "governor", "powersave", "cpupower"},
                 {"transparent_huge_pages", "huge pages", "always madvise [never]", "transparent_hugepage"},
                 {"memory_available_bytes", "memory", 1e9, "san_miguel"},
                 {"load_1min", "load", 1.5, "stop other work"},
                 {"steal_share_since_boot", "steal", 0.05, "virtual machines"},
                 {"clock_step_seconds", "clock", 4e-3, "clocksource"}};
    for (const auto& c : cases) {
        json machine = quiet_machine();
        machine[c.key] = c.value;
        for (const Diagnosis& f : examine_machine(machine)) {
            EXPECT_EQ(f.state, f.what == c.what ? State::warning : State::ok) << c.what << ": " << f.what;
            if (f.what == c.what) {
                EXPECT_NE(f.remedy.find(c.remedy), std::string::npos) << f.remedy;
            }
        }
    }
    json machine = quiet_machine();
    machine["cgroup_cpu_max"] = "400000 100000";  // as many as there are
    EXPECT_EQ(diagnosis(examine_machine(machine), "cpu quota").state, State::ok);
    machine["governor"] = "", machine["load_1min"] = nullptr;  // not to be read
    EXPECT_EQ(diagnosis(examine_machine(machine), "governor").state, State::ok);
    EXPECT_EQ(diagnosis(examine_machine(machine), "load").state, State::ok);
}

TEST(Health, UnderstandsWhatIsWrittenOfThisMachineAndBuild) {
    EXPECT_EQ(examine_machine(describe_machine()).size(), examine_machine(quiet_machine()).size());
    EXPECT_FALSE(examine_build(describe_build()).empty());
    EXPECT_LT(describe_machine().at("clock_step_seconds"), 1e-3);
}

TEST(Health, OfABuild) {
    json build = {{"compiler", "GNU 12"},
                  {"build_type", "Release"},
                  {"git_commit", "0123456789abcdef"},
                  {"git_dirty", false},
                  {"embree", "3.13.5"}};
    for (const Diagnosis& f : examine_build(build)) EXPECT_EQ(f.state, State::ok) << f.what;
    build["build_type"] = "Debug", build["git_dirty"] = true, build["embree"] = "";
    EXPECT_EQ(diagnosis(examine_build(build), "build type").state, State::warning);
    EXPECT_EQ(diagnosis(examine_build(build), "git").state, State::warning);
    EXPECT_EQ(diagnosis(examine_build(build), "Embree").state, State::missing);
    EXPECT_EQ(exit_code_of(examine_build(build)), ExitCode::ok);  // it runs without
}

TEST(Health, ALineEachAndTheFirstFailureIsTheExitCode) {
    const std::vector<Diagnosis> diagnoses = {
        {State::ok, "a", "fine"},
        {State::missing, "longer", "gone", "fetch it", ExitCode::scene_missing},
        {State::missing, "c", "gone", "", ExitCode::output}};
    EXPECT_EQ(diagnoses_text(diagnoses),
              "ok       a       fine\n"
              "missing  longer  gone: fetch it\n"
              "missing  c       gone\n");
    EXPECT_EQ(exit_code_of(diagnoses), ExitCode::scene_missing);
}

}  // namespace
}  // namespace ctpbench
