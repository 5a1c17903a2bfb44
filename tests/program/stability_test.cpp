// The study of stability as a user runs it.
#include "run_program.h"

namespace ctpbench::test {
namespace {

class StabilityStudy : public ProgramTest {};

TEST_F(StabilityStudy, HasARowOfEveryMethodOnEveryWorkloadThatItMeets) {
    const Outcome outcome =
        run("--out $D/s --config $C/stability.json --backend cpu --set /stress_rays=3000 "
            "--set '/stress=[\"edges\",\"sphere_at_1e4\",\"leave_ball\"]'");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("failures per million"), std::string::npos) << outcome.output;
    std::map<std::string, std::map<std::string, std::map<std::string, std::string>>> rows;
    std::size_t count = 0;
    for (const auto& row : read_csv(folder_ / "s/stability.csv")) {
        rows[row.at("workload")][row.at("kind") + "/" + row.at("method")] = row;
        EXPECT_EQ(row.at("rays"), "3000");
        for (const auto& [column, field] : row)
            EXPECT_EQ(field.empty(), column == "p99_scaled_error" && row.at("workload") == "leave_ball")
                << column;
        EXPECT_EQ(row.at("not_finite"), "0");
        if (row.at("is_default") == "true") {
            EXPECT_EQ(row.at("failures"), "0") << row.at("workload");
        }
        ++count;
    }
#ifdef CTPBENCH_EMBREE
    const std::size_t embree = 2;
#else
    const std::size_t embree = 0;
#endif
    // Bundles, one of them in flight too, tests of triangles and boxes; bundles, tests of spheres and boxes;
    // bundles and offsets.
    EXPECT_EQ(rows["edges"].size(), 5u + 5 + 3 + embree);
    EXPECT_EQ(rows["sphere_at_1e4"].size(), 5u + 3 + 3 + embree);
    EXPECT_EQ(rows["leave_ball"].size(), 5u + 4);
    EXPECT_EQ(count, rows["edges"].size() + rows["sphere_at_1e4"].size() + rows["leave_ball"].size())
        << "no method has two rows";
    EXPECT_EQ(rows["edges"]["triangle/woop"].at("is_default"), "true");
    EXPECT_GT(std::stod(rows["edges"]["triangle/moeller_trumbore"].at("failures_per_million")), 9e4);
    EXPECT_GT(std::stoi(rows["sphere_at_1e4"]["sphere/textbook"].at("failures")), 600);
    EXPECT_EQ(rows["leave_ball"]["offset/exclude_id"].at("failures"), "0");
}

}  // namespace
}  // namespace ctpbench::test
