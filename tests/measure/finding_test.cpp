#include "measure/finding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "noise.h"

namespace ctpbench {
namespace {

using test::Noise;

Finding found(const std::vector<double>& fresh, const std::vector<double>& base) {
    const MedianDistribution a(fresh), b(base);
    return findings({claims_of(RatioDistribution(a, b), fresh.size(), base.size())}).front();
}

TEST(Holm, AdjustsStepByStep) {
    const std::vector<double> p = holm({0.01, 0.04, 0.03, 0.005});
    EXPECT_DOUBLE_EQ(p[0], 0.03);
    EXPECT_DOUBLE_EQ(p[1], 0.06);
    EXPECT_DOUBLE_EQ(p[2], 0.06);
    EXPECT_DOUBLE_EQ(p[3], 0.02);
    EXPECT_EQ(holm({0.7, 0.8}), (std::vector<double>{1.0, 1.0}));
    EXPECT_TRUE(holm({}).empty());
}

TEST(Findings, TellWhatIsPlain) {
    Noise noise(1);
    const auto base = noise.rounds(31, 2.0, 0.01);
    EXPECT_EQ(found(base, base), Finding::same);
    EXPECT_EQ(found(noise.rounds(31, 2.2, 0.01), base), Finding::faster);
    EXPECT_EQ(found(noise.rounds(31, 1.8, 0.01), base), Finding::slower);
    EXPECT_EQ(found(noise.rounds(31, 2.0, 0.5), base), Finding::unclear);  // too noisy
    EXPECT_EQ(found(noise.rounds(31, 2.0 * kRunBand, 0.01), base),
              Finding::unclear);  // at the edge of the band
}

TEST(Findings, NeedNineRounds) {
    const std::vector<double> eight(8, 1.0), nine(9, 1.0), slow(9, 0.5);
    EXPECT_EQ(found(eight, nine), Finding::unclear);
    EXPECT_EQ(found(nine, eight), Finding::unclear);
    EXPECT_EQ(found(nine, nine), Finding::same);
    EXPECT_EQ(found(slow, nine), Finding::slower);
    EXPECT_EQ(findings({claims_of(eight)}).front(), Finding::unclear);
    EXPECT_EQ(findings({claims_of(slow)}).front(), Finding::slower);
}

// Nine rounds that agree have one chance in 512 to do so by luck: enough alone, not among a hundred.
TEST(Findings, CountTheirComparisons) {
    const Claims slow = claims_of(std::vector<double>(9, 0.5));
    EXPECT_EQ(findings({slow}).front(), Finding::slower);
    EXPECT_EQ(findings(std::vector<Claims>(100, slow)).front(), Finding::unclear);
    EXPECT_EQ(rounds_for(1), 9u);
    EXPECT_EQ(
        findings(std::vector<Claims>(100, claims_of(std::vector<double>(rounds_for(100), 0.5)))).front(),
        Finding::slower);
    // What has too few rounds is not among them.
    std::vector<Claims> others(100, claims_of(std::vector<double>(3, 0.5)));
    others.push_back(slow);
    EXPECT_EQ(findings(others).back(), Finding::slower);
    EXPECT_EQ(findings(others).front(), Finding::unclear);
}

TEST(Findings, AreMirroredWhenTheSidesAre) {
    Noise noise(2);
    const auto mirrored = [](Finding f) {
        return f == Finding::faster ? Finding::slower : f == Finding::slower ? Finding::faster : f;
    };
    for (int i = 0; i < 60; ++i) {
        const auto a = noise.rounds(15, 1.0 + 0.005 * (i - 30), 0.03), b = noise.rounds(15, 1.0, 0.03);
        EXPECT_EQ(found(a, b), mirrored(found(b, a))) << i;
    }
}

// Two runs of one binary as shared machines have them: rounds scatter by 5 %, processes by 1.3 %. In 95 of
// 100 such pairs all four contenders are SAME, and none is called anything else but UNCLEAR; where one
// contender takes 15 % longer, that one is found to be slower, and no other.
TEST(Findings, OfTwoRunsOfOneBinaryAndOfASlowedOne) {
    constexpr int tries = 100;
    constexpr std::size_t contenders = 4, rounds = 81;
    int all_same = 0, differences = 0, caught = 0, others_blamed = 0;
    Noise noise(3);
    for (int t = 0; t < tries; ++t)
        for (const bool slowed : {false, true}) {
            std::vector<Claims> claims;
            for (std::size_t c = 0; c < contenders; ++c) {
                const auto process = [&] { return std::exp(0.013 * noise.normal()); };
                const double level = slowed && c == 2 ? 1.0 / 1.15 : 1.0;
                const auto base = noise.rounds(rounds, process(), 0.05);
                const auto fresh = noise.rounds(rounds, level * process(), 0.05);
                const MedianDistribution a(fresh), b(base);
                claims.push_back(claims_of(RatioDistribution(a, b), rounds, rounds));
            }
            const std::vector<Finding> found = findings(claims);
            std::size_t same = 0, different = 0;
            for (const Finding f : found) {
                same += f == Finding::same;
                different += f == Finding::faster || f == Finding::slower;
            }
            if (slowed) {
                caught += found[2] == Finding::slower;
                others_blamed += different - (found[2] == Finding::slower);
            } else {
                all_same += same == contenders;
                differences += different > 0;
            }
        }
    EXPECT_GE(all_same, tries * 95 / 100);
    EXPECT_EQ(differences, 0);
    EXPECT_GE(caught, tries * 95 / 100);
    EXPECT_EQ(others_blamed, 0);
}

// A table has a wrong claim in about 5 % of cases at most, also where all its contenders sit just outside the
// band and SAME is what noise suggests.
TEST(Findings, OfAWholeTableAreSeldomWrong) {
    Noise noise(4);
    int wrong = 0;
    constexpr int tables = 300;
    for (int t = 0; t < tables; ++t) {
        std::vector<Claims> claims;
        for (int c = 0; c < 10; ++c) claims.push_back(claims_of(noise.rounds(21, 0.945, 0.03)));
        bool any = false;
        for (const Finding f : findings(claims)) any = any || f == Finding::same || f == Finding::faster;
        wrong += any;
    }
    EXPECT_LE(wrong, tables * 8 / 100);
}

TEST(ClaimBelow, NeedsTheUpperEndBelowTheLimit) {
    Noise noise(5);
    const auto base = noise.rounds(41, 1.0, 0.02);
    const auto fresh = noise.rounds(41, 0.8, 0.02);
    const MedianDistribution a(fresh), b(base);
    const RatioDistribution ratio(a, b);
    EXPECT_LE(claim_below(ratio, 0.9, 41, 41), kError);
    EXPECT_GT(claim_below(ratio, 0.8, 41, 41), kError);
    EXPECT_GT(claim_below(ratio, 0.7, 41, 41), kError);
    EXPECT_LE(claim_below(ratio, ratio.quantile(0.975) * 1.0001, 41, 41), kError * 1.0001);
    EXPECT_EQ(claim_below(ratio, 0.9, 41, 8), 1.0);
}

}  // namespace
}  // namespace ctpbench
