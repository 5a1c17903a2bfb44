#include "report/judgement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "measure/finding.h"
#include "noise.h"
#include "report/console.h"
#include "report/csv_table.h"
#include "report/summary.h"

namespace ctpbench {
namespace {

CellResult cell(const std::string& strategy, const std::vector<double>& mrays) {
    CellResult c;
    c.workload = {"smoke", 0, 0.03, "quality"};
    c.contender = {"cpu", strategy, true, "single", "watertight"};
    c.valid = true;
    for (const double speed : mrays) c.add("intersect", 100, speed, 1.0);
    return c;
}

// Machine phases that all contenders share, and noise of their own.
Results results(std::size_t rounds, const std::vector<std::pair<std::string, double>>& contenders) {
    test::Noise noise(1);
    const std::vector<double> machine = noise.rounds(rounds, 1.0, 0.3);
    Results r;
    for (const auto& [name, speed] : contenders) {
        std::vector<double> mrays = noise.rounds(rounds, speed, 0.01);
        for (std::size_t i = 0; i < rounds; ++i) mrays[i] *= machine[i];
        r.cells.push_back(cell(name, mrays));
    }
    return r;
}

TEST(Judgements, AreOfPairedRatiosToTheReference) {
    const Results r = results(21, {{"ctp", 1.0}, {"oop", 0.8}, {"restart", 1.01}, {"typed_leaves", 1.3}});
    const Judgements judgements(Config{}, r);
    const auto verdict = [&](std::size_t i) { return judgements.find(r.cells[i], "intersect")->verdict; };
    EXPECT_EQ(verdict(0), "");  // the reference itself
    EXPECT_EQ(verdict(1), "SLOWER");
    EXPECT_EQ(verdict(2), "SAME");
    EXPECT_EQ(verdict(3), "FASTER");
    EXPECT_EQ(judgements.find(r.cells[1], "shade"), nullptr);
}

TEST(Judgements, StandInSummaryAndConsole) {
    const Results r = results(21, {{"ctp", 1.0}, {"oop", 0.8}});
    const CsvTable table = CsvTable::parse(summary_csv(Config{}, r), "summary.csv");
    EXPECT_EQ(table.field(0, table.column("verdict")), "");
    EXPECT_EQ(table.field(1, table.column("verdict")), "SLOWER");
    EXPECT_EQ(table.field(1, table.column("bimodal")), "false");
    EXPECT_EQ(table.number(1, table.column("drift")), 0.0);
    EXPECT_NE(table_text(Config{}, r).find("SLOWER"), std::string::npos);
}

TEST(Judgements, LeaveRejectedContendersOut) {
    Results r = results(21, {{"ctp", 1.0}, {"oop", 0.8}, {"restart", 0.8}});
    r.cells[1].valid = false;
    const Judgements judgements(Config{}, r);
    EXPECT_EQ(judgements.find(r.cells[1], "intersect")->verdict, "");
    EXPECT_EQ(judgements.find(r.cells[2], "intersect")->verdict, "SLOWER");
}

TEST(Judgements, SayHowManyRoundsTheyLack) {
    const Results few = results(8, {{"ctp", 1.0}, {"oop", 0.5}});
    EXPECT_EQ(Judgements(Config{}, few).find(few.cells[1], "intersect")->verdict, "UNCLEAR");
    EXPECT_EQ(
        Judgements(Config{}, few).warnings(),
        std::vector<std::string>{"1 comparisons need 9 rounds before each can have a verdict; there were 8"});
    const Results enough = results(9, {{"ctp", 1.0}, {"oop", 0.5}});
    EXPECT_EQ(Judgements(Config{}, enough).find(enough.cells[1], "intersect")->verdict, "SLOWER");
    EXPECT_TRUE(Judgements(Config{}, enough).warnings().empty());
}

TEST(Judgements, WarnOfDoubtfulSeries) {
    Results r = results(30, {{"ctp", 1.0}, {"oop", 0.5}});
    for (std::size_t i = 0; i < 30; i += 2) r.cells[1].kernels[0].mrays[i] *= 1.2;
    const std::vector<std::string> warnings = Judgements(Config{}, r).warnings();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "smoke/0/oop, intersect: doubtful: bimodal");
    EXPECT_NE(table_text(Config{}, r).find(warnings[0]), std::string::npos);
}

TEST(NoiseOf, IsThatOfTheRatioNotOfTheMachine) {
    const Results r = results(21, {{"ctp", 1.0}, {"oop", 0.8}, {"embree_robust", 1.2}});
    EXPECT_GT(noise_of(r.cells[1], r, "ctp"), 0.0);
    EXPECT_LT(noise_of(r.cells[1], r, "ctp"), 0.02);
    EXPECT_LT(noise_of(r.cells[0], r, "ctp"), 0.02);               // the reference beside the yardstick
    EXPECT_GT(noise_of(r.cells[0], results(0, {}), "ctp"), 0.05);  // alone
    EXPECT_EQ(noise_of(CellResult{}, r, "ctp"), 0.0);
}

}  // namespace
}  // namespace ctpbench
