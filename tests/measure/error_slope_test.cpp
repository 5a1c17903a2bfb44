#include "measure/error_slope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/noisy_images.h"
#include "measure/reference_image.h"

namespace ctpbench {
namespace {

TEST(RmseSlope, OfAPowerLawIsItsExponent) {
    std::vector<std::vector<double>> relmse(8);
    for (auto& of_seed : relmse)
        for (int k = 0; k <= 7; ++k) of_seed.push_back(3.0 * std::pow(2.0, -0.8 * k));
    const BoundedValue slope = rmse_slope(relmse);
    EXPECT_NEAR(slope.value, -0.4, 1e-12);
    EXPECT_NEAR(slope.lo, -0.4, 1e-12);
    EXPECT_NEAR(slope.hi, -0.4, 1e-12);
}

std::vector<std::vector<double>> errors(std::uint64_t seed, double bias) {
    const ReferenceImage reference(test::noisy_image(seed, 128), test::noisy_image(seed + 1, 128));
    std::vector<std::vector<double>> relmse(8);
    for (std::size_t s = 0; s < relmse.size(); ++s) {
        test::NoisyImage image(seed + 2 + s, 0.5, bias);
        for (int k = 0; k <= 6; ++k) {
            image.add_samples(k == 0 ? 1 : 1 << (k - 1));
            relmse[s].push_back(reference.relmse(image.image()));
        }
    }
    return relmse;
}

// Six doublings of progressive images.
TEST(RmseSlope, OfIndependentSamplesIsMinusOneHalf) {
    int covered = 0;
    for (std::uint64_t i = 0; i < 10; ++i) {
        const BoundedValue slope = rmse_slope(errors(100 * i, 0.0));
        EXPECT_NEAR(slope.value, -0.5, 0.03);
        EXPECT_LT(slope.hi - slope.lo, 0.06);
        covered += slope.lo <= -0.5 && -0.5 <= slope.hi;
    }
    EXPECT_GE(covered, 7);
}

TEST(RmseSlope, IsFlattenedByABias) {
    const BoundedValue slope = rmse_slope(errors(1, 0.2));
    EXPECT_GT(slope.lo, -0.45);
    EXPECT_LT(slope.hi, -0.05);
}

TEST(RmseSlope, IsUnknownWhereAnErrorIsNotPositive) {
    EXPECT_TRUE(std::isnan(rmse_slope({{0.1, -0.2}, {0.1, 0.1}, {0.1, 0.0}, {0.1, 0.0}}).value));
    EXPECT_TRUE(std::isnan(rmse_slope({}).value));
    EXPECT_TRUE(std::isnan(rmse_slope({{0.1}}).value));
}

}  // namespace
}  // namespace ctpbench
