#include "report/tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/console.h"
#include "report/csv.h"
#include "report/figures.h"
#include "report/summary.h"

namespace ctpbench {
namespace {

CellResult cell(const std::string& strategy, std::uint32_t spheres, std::vector<double> mrays) {
    CellResult c;
    c.workload = {"conference", spheres, 0.03, "quality"};
    c.contender = {"cpu", strategy, true, "single", "watertight"};
    c.scene_source = "mesh";
    c.triangles = 12;
    c.checked = c.valid = true;
    for (const double speed : mrays) c.add("intersect", 100, speed, 1.0);
    return c;
}

Results results() {
    Results r;
    r.cells = {cell("ctp", 1000, {2, 4, 3}), cell("oop", 1000, {1, 2, 1.5}), cell("restart", 1000, {4, 8, 6}),
               cell("ctp", 10000, {3, 3, 3}), cell("oop", 10000, {2, 2, 2})};
    return r;
}

TEST(Csv, QuotesWhatNeedsIt) {
    EXPECT_EQ(csv_line({"a", "b c", ""}), "a,b c,\r\n");
    EXPECT_EQ(csv_line({"a,b", "say \"x\"", "two\nlines"}), "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\r\n");
    EXPECT_EQ(csv_number(1.5), "1.5");
    EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(RatioOf, PairsRounds) {
    const Results r = results();
    const Estimate ratio = ratio_of(&r.cells[0], &r.cells[1]);
    EXPECT_EQ(ratio.median, 2.0);
    EXPECT_EQ(ratio.lo, 2.0);  // every round has the same ratio, however its speed varied
    EXPECT_EQ(ratio.hi, 2.0);
    EXPECT_TRUE(std::isnan(ratio_of(&r.cells[0], nullptr).median));
}

TEST(Table3, HasARowPerSphereCountAndAColumnPerStrategy) {
    EXPECT_EQ(table3_csv(results()),
              "spheres,conference/cpu/ctp,conference/cpu/oop,conference/cpu/restart\r\n"
              "1000,3,1.5,6\r\n"
              "10000,3,2,\r\n");
}

TEST(Table3, LeavesRejectedContendersOut) {
    Results r = results();
    r.cells[1].valid = false;
    r.cells[1].reason = "the oracle disagrees";
    EXPECT_NE(table3_csv(r).find("1000,3,,6\r\n"), std::string::npos);
    EXPECT_TRUE(std::isnan(ratio_of(&r.cells[0], &r.cells[1]).median));
    Config config;
    EXPECT_NE(table_text(config, r).find("conference/1000/oop: rejected: the oracle disagrees"),
              std::string::npos);
    EXPECT_NE(summary_csv(config, r).find(",false,"), std::string::npos);
}

TEST(Table3, SetsThePapersRatiosBesideOurs) {
    const std::string text = table3_markdown(results());
    // The paper: 12.6 / 11.8 = 1.07 and 12.6 / 10.9 = 1.16 with 1K spheres.
    EXPECT_NE(
        text.find("| 1000 | 12.60 | 3.00 | 11.80 | 1.50 | 10.90 | 6.00 | 1.07 | 2.00 [2.00, 2.00] | 1.16 | "
                  "0.50 [0.50, 0.50] |"),
        std::string::npos)
        << text;
}

// A stand-in is another scene: nothing of the paper's may be set beside it.
TEST(Table3, SetsNothingOfThePaperBesideAStandIn) {
    Results r = results();
    for (CellResult& c : r.cells) c.scene_source = "stand-in";
    EXPECT_EQ(table3_markdown(r).find("12.60"), std::string::npos);
}

}  // namespace
}  // namespace ctpbench
