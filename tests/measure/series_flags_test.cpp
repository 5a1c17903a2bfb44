#include "measure/series_flags.h"

#include <gtest/gtest.h>

#include "noise.h"

namespace ctpbench {
namespace {

TEST(SeriesFlags, SeldomDoubtPlainNoise) {
    test::Noise noise(1);
    for (const std::size_t n : {9u, 11u, 21u, 81u}) {
        int drifts = 0, bimodal = 0;
        for (int i = 0; i < 1000; ++i) {
            const SeriesFlags flags = flags_of(noise.rounds(n, 3.0, 0.05));
            drifts += flags.drift != 0.0, bimodal += flags.bimodal;
        }
        EXPECT_LE(drifts, 20) << n;
        EXPECT_LE(bimodal, 10) << n;
    }
}

TEST(SeriesFlags, FindADrift) {
    test::Noise noise(2);
    std::vector<double> series = noise.rounds(30, 1.0, 0.01);
    for (std::size_t i = 0; i < series.size(); ++i) series[i] *= 1.0 - 0.1 * static_cast<double>(i) / 29.0;
    const SeriesFlags flags = flags_of(series);
    EXPECT_NEAR(flags.drift, -0.067, 0.015);  // between the middles of the outer thirds
    EXPECT_NE(flags.text().find("drift -"), std::string::npos);
}

TEST(SeriesFlags, FindTwoGroups) {
    test::Noise noise(3);
    std::vector<double> series = noise.rounds(30, 1.0, 0.01);
    for (std::size_t i = 0; i < series.size(); i += 3) series[i] *= 1.1;
    EXPECT_TRUE(flags_of(series).bimodal);
    EXPECT_EQ(flags_of(series).drift, 0.0);
    EXPECT_EQ(flags_of(series).text(), "bimodal");
}

TEST(SeriesFlags, SayNothingOfWhatDoesNotMatterOrCannotBeTold) {
    std::vector<double> climbs, two;
    for (int i = 0; i < 30; ++i) climbs.push_back(1.0 + 1e-4 * i), two.push_back(i % 2 == 0 ? 1.0 : 1.001);
    EXPECT_FALSE(flags_of(climbs).any());
    EXPECT_FALSE(flags_of(two).any());
    EXPECT_FALSE(flags_of({1, 2, 3, 4, 5, 6, 7, 8}).any());
    EXPECT_FALSE(flags_of(std::vector<double>(20, 1.0)).any());
    EXPECT_FALSE(flags_of(std::vector<double>(20, 0.0)).any());
    EXPECT_TRUE(flags_of({}).text().empty());
}

}  // namespace
}  // namespace ctpbench
