// The axis `types` through the whole program: tables, columns, and what is refused.
#include <gtest/gtest.h>

#include <set>

#include "run_program.h"

namespace ctpbench::test {
namespace {

class TypesRun : public ProgramTest {
protected:
    Outcome run_config(const std::string& body) {
        write("t.json",
              "{\"schema_version\": 1, \"experiment\": \"t\", \"width\": 48, \"height\": 32, "
              "\"bounces\": 2, \"rounds\": 2,\n" +
                  body + "}");
        std::filesystem::remove_all(folder_ / "r");
        return run("--quiet --config $D/t.json --out $D/r");
    }
};

TEST_F(TypesRun, NarrowingHasALineForEachContenderThatHasBoth) {
    const auto outcome = run_config(R"("matrix": {"scene": "conference_like", "spheres": 0,
        "strategy": ["ctp", "oop"], "types": ["all", "scene"]},
        "include": [{"scene": "conference_like", "spheres": 0, "strategy": "ctp", "types": ["all", "scene"],
                     "shade": ["ctp", "sort"]}], "tables": ["narrowing"])");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    const auto rows = read_csv(folder_ / "r/narrowing.csv");
    ASSERT_EQ(rows.size(), 4u);
    for (const auto& row : rows) {
        const bool intersect = row.at("kernel") == "intersect";
        EXPECT_EQ(row.at("types"), intersect ? "triangle" : "matte+plastic+mirror+emissive");
        EXPECT_GT(std::stod(row.at("gain")), 0.0);
    }
    EXPECT_LT(std::stoul(rows[0].at("scene_bytes")), std::stoul(rows[0].at("all_bytes")))
        << "ctp has no tags";
    std::set<std::string> types, hashes;
    for (const auto& row : read_csv(folder_ / "r/rows.csv")) {
        types.insert(row.at("types"));
        if (row.at("bounce") == "1" && row.at("shade") == "none") hashes.insert(row.at("hit_hash"));
    }
    EXPECT_EQ(types, (std::set<std::string>{"all", "scene"}));
    EXPECT_EQ(hashes.size(), 1u);
}

TEST_F(TypesRun, OfSyntheticTypesHasAllListsAndKernels) {
    const auto outcome = run_config(R"("matrix": {"scene": "conference_like", "spheres": 0,
        "strategy": ["ctp", "restart"], "types": ["synthetic_1", "synthetic_8", "synthetic_2_large"]},
        "include": [{"scene": "conference_like", "spheres": 0, "strategy": "ctp",
                     "types": ["synthetic_1", "synthetic_8"], "shade": ["ctp", "queues"]}],
        "tables": ["types"])");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    std::multiset<std::string> lines;
    for (const auto& row : read_csv(folder_ / "r/types.csv"))
        lines.insert(row.at("kernel") + " " + row.at("listed"));
    EXPECT_EQ(lines.count("intersect 8"), 2u);
    EXPECT_EQ(lines.count("intersect 2"), 2u);
    for (const char* kernel : {"shade", "sort+shade+compact", "frame"})
        EXPECT_EQ(lines.count(kernel + std::string(" 8")), 2u) << kernel;
}

TEST_F(TypesRun, RefusesWhatCannotBeHad) {
    const auto refused = [&](const std::string& body, const std::string& part) {
        const auto outcome = run_config(body);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
        EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
    };
    refused(R"("matrix": {"types": "sceen"})", "did you mean \"scene\"?");
    refused(R"("matrix": {"types": "synthetic_8", "spheres": 10})", "set /matrix/spheres to 0");
    refused(R"("matrix": {"types": "synthetic_8", "spheres": 0, "methods": "fast"})",
            "default methods alone");
    refused(R"("matrix": {"types": "all"}, "tables": ["narrowing"])", "name both in /matrix/types");
    refused(R"("matrix": {"types": "synthetic_8", "spheres": 0}, "tables": ["types"])", "synthetic_1");
}

}  // namespace
}  // namespace ctpbench::test
