#include "report/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "program/run_program.h"
#include "report/noisy_run.h"

namespace ctpbench {
namespace {

using test::NoisyRun;

class ComparisonTest : public test::ProgramTest {
protected:
    Comparison compared(const NoisyRun& base, const NoisyRun& fresh, double fail_ratio = 0.9) {
        const auto a = folder_ / ("base" + std::to_string(++count_)),
                   b = folder_ / ("new" + std::to_string(count_));
        base.write(a, 2 * count_), fresh.write(b, 2 * count_ + 1);
        return compare(read_results(a), read_results(b), fail_ratio);
    }
    static const ComparedKernel& of(const Comparison& c, const std::string& strategy) {
        for (const ComparedKernel& k : c.kernels)
            if (k.name.find("/" + strategy + "/") != std::string::npos) return k;
        throw std::runtime_error("no " + strategy);
    }
    static bool says(const std::vector<std::string>& lines, const std::string& text) {
        return std::any_of(lines.begin(), lines.end(),
                           [&](const std::string& l) { return l.find(text) != std::string::npos; });
    }
    std::uint64_t count_ = 0;
};

TEST_F(ComparisonTest, OneBinaryTwiceIsTheSame) {
    const Comparison c = compared({}, {});
    ASSERT_EQ(c.kernels.size(), 3u);
    for (const ComparedKernel& k : c.kernels) EXPECT_EQ(k.finding, Finding::same) << k.name;
    EXPECT_FALSE(c.has_regression());
    EXPECT_FALSE(c.has_doubt());
    EXPECT_TRUE(c.unmatched.empty());
    EXPECT_TRUE(c.differences.empty());
    EXPECT_NEAR(of(c, "ctp").base, 0.8, 0.02);
    EXPECT_EQ(of(c, "ctp").base_rounds, 31u);
}

// As a contest counts: a batch stands for all paths that were active at its bounce.
TEST_F(ComparisonTest, SpeedIsThatOfTheWholeFrame) {
    NoisyRun run;
    run.noise = 0.0, run.contenders = {{"embree_robust", 2.0}};
    EXPECT_NEAR(compared(run, run).kernels.front().base, 2.0, 1e-3);
}

TEST_F(ComparisonTest, ASlowedContenderIsARegressionAndNoOther) {
    NoisyRun slow;
    slow.contenders[1].speed /= 1.3;
    const Comparison c = compared({}, slow);
    EXPECT_EQ(of(c, "oop").finding, Finding::slower);
    EXPECT_TRUE(of(c, "oop").regression);
    EXPECT_EQ(of(c, "ctp").finding, Finding::same);
    EXPECT_FALSE(of(c, "ctp").regression);
    EXPECT_TRUE(c.has_regression());
    // The same pair the other way around is no regression.
    EXPECT_EQ(of(compared(slow, {}), "oop").finding, Finding::faster);
    EXPECT_FALSE(compared(slow, {}).has_regression());
}

TEST_F(ComparisonTest, SlowerThanTheBandYetWithinTheLimitIsNoRegression) {
    NoisyRun slow;
    slow.contenders[0].speed *= 0.92, slow.noise = 0.005;
    NoisyRun base;
    base.noise = 0.005;
    EXPECT_EQ(of(compared(base, slow, 0.9), "ctp").finding, Finding::slower);
    EXPECT_FALSE(compared(base, slow, 0.9).has_regression());
    EXPECT_TRUE(compared(base, slow, 0.94).has_regression());
}

// A machine at half its speed, for all of a run or from its middle on, slows contender and yardstick alike.
TEST_F(ComparisonTest, TheYardstickTakesTheMachineOut) {
    NoisyRun slow, halfway;
    slow.machine = 0.5, halfway.slow_phase = 0.5;
    for (const NoisyRun& run : {slow, halfway}) {
        const Comparison c = compared({}, run);
        EXPECT_EQ(of(c, "ctp").finding, Finding::same);
        EXPECT_EQ(of(c, "oop").finding, Finding::same);
        EXPECT_FALSE(c.has_regression());
        EXPECT_FALSE(c.has_doubt());
    }
    // The yardstick itself is shown as it is, and is not what is under test.
    const Comparison c = compared({}, slow);
    EXPECT_EQ(of(c, "embree_robust").finding, Finding::slower);
    EXPECT_TRUE(of(c, "embree_robust").yardstick);
    EXPECT_FALSE(c.has_doubt());
}

TEST_F(ComparisonTest, WithoutAYardstickSpeedsAreComparedOnOneMachineOnly) {
    NoisyRun bare, slow;
    bare.contenders = {{"ctp", 0.8}};
    slow.contenders = {{"ctp", 0.4}};
    Comparison c = compared(bare, slow);
    EXPECT_FALSE(c.kernels.front().normalised);
    EXPECT_TRUE(c.has_regression());
    EXPECT_TRUE(says(c.warnings, "without a yardstick"));
    slow.cpu = "another processor";
    c = compared(bare, slow);
    EXPECT_EQ(c.kernels.front().finding, Finding::unclear);
    EXPECT_FALSE(c.has_regression());
    EXPECT_TRUE(c.has_doubt());
}

TEST_F(ComparisonTest, StagesOfFramesAreNotSetBesideAYardstickOfOtherRounds) {
    NoisyRun frames;
    frames.contenders = {{"ctp", 0.8, true, "sort"}, {"ctp", 0.8}, {"embree_robust", 1.0}};
    const Comparison c = compared(frames, frames);
    EXPECT_FALSE(of(c, "ctp+sort").normalised);
    EXPECT_TRUE(of(c, "ctp").normalised);
}

TEST_F(ComparisonTest, SaysThatTheMachineDiffers) {
    NoisyRun other, unknown;
    other.cpu = "another processor", unknown.cpu = "";
    EXPECT_TRUE(compared({}, other).other_machine);
    EXPECT_TRUE(says(compared({}, other).differences, "cpu: a processor | another processor"));
    EXPECT_TRUE(compared({}, unknown).other_machine);
    EXPECT_TRUE(says(compared({}, unknown).differences, "no meta.json"));
}

TEST_F(ComparisonTest, NothingIsLeftOutSilently) {
    NoisyRun base, fresh;
    base.contenders = {{"ctp", 0.8}, {"restart", 0.5}, {"oop", 0.7}, {"embree_robust", 1.0}};
    fresh.contenders = {{"ctp", 0.8}, {"typed_leaves", 0.5}, {"oop", 0.7, false}, {"embree_robust", 1.0}};
    const Comparison c = compared(base, fresh);
    EXPECT_TRUE(says(c.unmatched, "smoke/0/restart/1thread, intersect: only in BASE"));
    EXPECT_TRUE(says(c.unmatched, "smoke/0/typed_leaves/1thread, intersect: only in NEW"));
    EXPECT_TRUE(says(c.unmatched, "oop/1thread, intersect: its hits were rejected in NEW"));
    EXPECT_EQ(c.unmatched.size(), 3u);
    EXPECT_EQ(c.kernels.size(), 2u);
    EXPECT_TRUE(c.has_doubt());
    const std::string text = comparison_text(c, 0.9);
    for (const std::string& line : c.unmatched) EXPECT_NE(text.find(line), std::string::npos);
}

TEST_F(ComparisonTest, OtherRaysAndOtherThreadsAreOtherMeasurements) {
    NoisyRun more_rays, more_threads;
    more_rays.batch = 2000, more_threads.threads = 2;
    EXPECT_TRUE(compared({}, more_rays).kernels.empty());
    EXPECT_TRUE(says(compared({}, more_rays).unmatched, "other rays"));
    EXPECT_TRUE(compared({}, more_threads).kernels.empty());
    EXPECT_TRUE(says(compared({}, more_threads).unmatched, "ctp/2threads, intersect: only in NEW"));
}

TEST_F(ComparisonTest, FewRoundsAreUnclear) {
    NoisyRun few;
    few.rounds = 8, few.contenders[0].speed /= 2.0;
    const Comparison c = compared({}, few);
    for (const ComparedKernel& k : c.kernels) EXPECT_EQ(k.finding, Finding::unclear);
    EXPECT_FALSE(c.has_regression());
    EXPECT_TRUE(c.has_doubt());
    EXPECT_TRUE(says(c.warnings, "fewer than 9 rounds"));
}

TEST_F(ComparisonTest, RoundsThatWereCutShortAreCounted) {
    NoisyRun run;
    run.write(folder_ / "a", 1), run.write(folder_ / "b", 2);
    // The last line is a bounce of the yardstick's last round.
    std::string rows = read(folder_ / "b" / "rows.csv");
    rows.erase(rows.rfind("\r\n", rows.size() - 3) + 2);
    write("b/rows.csv", rows);
    const Comparison c = compare(read_results(folder_ / "a"), read_results(folder_ / "b"), 0.9);
    EXPECT_TRUE(says(c.warnings, "embree_robust/1thread, intersect: 1 rounds in NEW lack bounces"));
    EXPECT_EQ(of(c, "ctp").fresh_rounds, 30u);
    EXPECT_EQ(of(c, "ctp").base_rounds, 31u);
}

TEST_F(ComparisonTest, SeveralRunsOfAFolderCountTogether) {
    NoisyRun run;
    run.write(folder_ / "many" / "1", 1), run.write(folder_ / "many" / "2", 2), run.write(folder_ / "one", 3);
    const Comparison c = compare(read_results(folder_ / "many"), read_results(folder_ / "one"), 0.9);
    EXPECT_EQ(of(c, "ctp").base_rounds, 62u);
    EXPECT_EQ(of(c, "ctp").fresh_rounds, 31u);
    EXPECT_EQ(of(c, "ctp").finding, Finding::same);
    EXPECT_THROW(read_results(folder_ / "none"), Error);
}

// Rounds alone, pooled, would be sure of something between the runs.
TEST_F(ComparisonTest, WhatRunsDifferByIsInTheInterval) {
    NoisyRun run, other;
    run.rounds = other.rounds = 201, other.contenders[0].speed *= 1.2;
    run.write(folder_ / "many/1", 1), other.write(folder_ / "many/2", 2), run.write(folder_ / "many/3", 3);
    run.write(folder_ / "one", 4);
    const Comparison c = compare(read_results(folder_ / "many"), read_results(folder_ / "one"), 0.9);
    EXPECT_EQ(of(c, "ctp").finding, Finding::unclear);
    EXPECT_LT(of(c, "ctp").ratio.lo, 1.0 / 1.15);
    EXPECT_NEAR(of(c, "ctp").ratio.hi, 1.0, 0.03);
    EXPECT_FALSE(c.has_regression());
    EXPECT_EQ(of(c, "oop").finding, Finding::same);
}

// Runs that disagree make one series of two groups.
TEST_F(ComparisonTest, DoubtfulSeriesAreNamed) {
    NoisyRun run, other, drifting;
    other.contenders[0].speed *= 1.25;
    run.write(folder_ / "many" / "1", 1), other.write(folder_ / "many" / "2", 2),
        run.write(folder_ / "one", 3);
    const Comparison c = compare(read_results(folder_ / "many"), read_results(folder_ / "one"), 0.9);
    EXPECT_TRUE(says(c.warnings, "ctp/1thread, intersect: doubtful in BASE: bimodal"));
    drifting.slow_phase = 0.5;
    EXPECT_TRUE(
        says(compared({}, drifting).warnings, "embree_robust/1thread, intersect: doubtful in NEW: drift -"));
}

TEST_F(ComparisonTest, IsUnmovedByOrderOfRuns) {
    NoisyRun run;
    run.write(folder_ / "a" / "1", 1), run.write(folder_ / "a" / "2", 2);
    run.write(folder_ / "b" / "1", 2), run.write(folder_ / "b" / "2", 1);
    const Comparison c = compare(read_results(folder_ / "a"), read_results(folder_ / "b"), 0.9);
    for (const ComparedKernel& k : c.kernels) {
        EXPECT_DOUBLE_EQ(k.ratio.median, 1.0);
        EXPECT_NEAR(k.ratio.lo * k.ratio.hi, 1.0, 1e-2);
    }
}

}  // namespace
}  // namespace ctpbench
