// stability.csv as others read it.
#include "report/stability.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace ctpbench {
namespace {

StabilityRow row(const char* kind, const char* method, const char* workload, std::size_t leaks) {
    StabilityRow r{kind, method, "cpu", false, workload, {}};
    r.accuracy.verdict.rays = 1000000;
    r.accuracy.verdict.match = 1000000 - leaks;
    r.accuracy.verdict.leak = leaks;
    r.accuracy.p99_scaled_error = 1.5;
    return r;
}

TEST(StabilityCsv, HasTheColumnsThatChartsRead) {
    const auto folder = std::filesystem::temp_directory_path() / "ctpbench_stability_test";
    std::filesystem::create_directories(folder);
    {
        StabilityFile file(folder);
        StabilityRow none = row("triangle", "watertight", "edges", 0);
        none.is_default = true;
        file.append(none);
        StabilityRow some = row("triangle", "moeller_trumbore", "edges", 110000);
        some.accuracy.verdict.false_hit = 2, some.accuracy.verdict.not_finite = 3;
        file.append(some);
    }
    std::ifstream in(folder / "stability.csv");
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_EQ(
        text.str(),
        "kind,method,is_default,workload,rays,failures,failures_per_million,lo,hi,p99_scaled_error,backend,"
        "missed,false_hits,wrong_primitives,t_mismatches,leaks,boundary,not_finite\r\n"
        "triangle,watertight,true,edges,1000000,0,0,0,3,1.5,cpu,0,0,0,0,0,0,0\r\n"
        "triangle,moeller_trumbore,false,edges,1000000,110005,110005,109393,110620,1.5,cpu,0,2,0,0,110000,0,"
        "3\r\n");
    std::filesystem::remove_all(folder);
}

TEST(StabilityText, ShowsFailuresPerMillionAndWhatDoesNotMeet) {
    const std::string text =
        stability_text({row("triangle", "woop", "edges", 0), row("triangle", "plain", "edges", 4567),
                        row("sphere", "textbook", "sphere_at_1e4", 250000)});
    EXPECT_NE(text.find("edges             .  4.6k     -"), std::string::npos) << text;
    EXPECT_NE(text.find("sphere_at_1e4     -     -  250k"), std::string::npos) << text;
    EXPECT_NE(text.find("B  triangle plain"), std::string::npos) << text;
}

}  // namespace
}  // namespace ctpbench
