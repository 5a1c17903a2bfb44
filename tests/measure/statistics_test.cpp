#include "measure/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "measure/rounds.h"

namespace ctpbench {
namespace {

TEST(Median, OfOddAndEvenCounts) {
    EXPECT_EQ(median({3, 1, 2}), 2.0);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_EQ(median({5}), 5.0);
}

TEST(EstimateMedian, IntervalHoldsTheMedianAndIsRepeatable) {
    const std::vector<double> samples = {9, 1, 5, 3, 7, 8, 2, 6, 4};
    const Estimate a = estimate_median(samples), b = estimate_median(samples);
    EXPECT_EQ(a.median, 5.0);
    EXPECT_LT(a.lo, 5.0);
    EXPECT_GT(a.hi, 5.0);
    EXPECT_EQ(a.lo, b.lo);
    EXPECT_EQ(a.hi, b.hi);
    EXPECT_EQ(estimate_median({2, 2, 2, 2}).hi, 2.0);
}

// A 95 % interval of a median must hold it in about 95 of 100 experiments; with eleven samples the
// percentile bootstrap does so in 92 to 97.
TEST(EstimateMedian, CoversTheTrueMedian) {
    std::mt19937_64 random(7);
    int covered = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<double> samples(11);
        for (double& s : samples) s = static_cast<double>(random() >> 11) * 0x1p-53;
        const Estimate e = estimate_median(samples);
        covered += e.lo <= 0.5 && 0.5 <= e.hi;
    }
    EXPECT_GT(covered, 400 * 90 / 100);
    EXPECT_LT(covered, 400 * 99 / 100);
}

// The machine slows down by half midway: each contender's own median is useless, the paired ratio is not.
TEST(EstimatePairedRatio, CancelsWhatBothSuffer) {
    std::vector<double> a, b;
    for (int i = 0; i < 12; ++i) {
        const double machine = i < 6 ? 1.0 : 0.5;
        a.push_back(3.0 * machine), b.push_back(2.0 * machine);
    }
    const Estimate e = estimate_paired_ratio(a, b);
    EXPECT_DOUBLE_EQ(e.median, 1.5);
    EXPECT_DOUBLE_EQ(e.lo, 1.5);
    EXPECT_DOUBLE_EQ(e.hi, 1.5);
}

TEST(RoundOrder, VisitsEveryoneOnceAndFavoursNobody) {
    std::vector<double> mean_position(5, 0.0);
    std::set<std::size_t> firsts;
    for (std::size_t round = 0; round < 10; ++round) {
        const auto order = round_order(5, round);
        EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 5u);
        firsts.insert(order[0]);
        for (std::size_t i = 0; i < 5; ++i) mean_position[order[i]] += static_cast<double>(i) / 10.0;
    }
    for (double m : mean_position) EXPECT_DOUBLE_EQ(m, 2.0);
    EXPECT_EQ(firsts.size(), 5u);
    const auto forward = round_order(5, 2);
    EXPECT_EQ(round_order(5, 3), std::vector<std::size_t>(forward.rbegin(), forward.rend()));
}

TEST(BinomialInterval, HoldsKnownValues) {
    // Wilson's interval of 10 in 100 (e.g. Newcombe, Stat. Med. 17, 1998, method 3).
    const Interval i = binomial_interval(10, 100);
    EXPECT_NEAR(i.lo, 0.0552, 1e-4);
    EXPECT_NEAR(i.hi, 0.1744, 1e-4);
    EXPECT_EQ(binomial_interval(0, 1000).lo, 0.0);
    EXPECT_DOUBLE_EQ(binomial_interval(0, 1000).hi, 3e-3);
    EXPECT_DOUBLE_EQ(binomial_interval(1000, 1000).lo, 1.0 - 3e-3);
    EXPECT_EQ(binomial_interval(1000, 1000).hi, 1.0);
    EXPECT_EQ(binomial_interval(0, 1).hi, 1.0);
}

TEST(BinomialInterval, CoversNineteenInTwenty) {
    std::mt19937_64 engine(3);
    std::binomial_distribution<int> events(500, 0.02);
    int covered = 0;
    for (int i = 0; i < 4000; ++i) {
        const Interval in = binomial_interval(static_cast<std::size_t>(events(engine)), 500);
        covered += in.lo <= 0.02 && 0.02 <= in.hi;
    }
    EXPECT_NEAR(covered / 4000.0, 0.95, 0.02);
}

TEST(NearestRank, IsTheSmallestValueThatTheShareDoesNotExceed) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> values;
    for (int i = 100; i >= 1; --i) values.push_back(static_cast<float>(i)), values.push_back(nan);
    EXPECT_EQ(nearest_rank(values, 0.99), 99.0);
    EXPECT_EQ(nearest_rank(values, 0.991), 100.0);
    EXPECT_EQ(nearest_rank(values, 0.0), 1.0);
    EXPECT_EQ(nearest_rank({5.0f}, 0.99), 5.0);
    EXPECT_TRUE(std::isnan(nearest_rank({nan}, 0.5)));
}

}  // namespace
}  // namespace ctpbench
