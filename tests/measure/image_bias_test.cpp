#include "measure/image_bias.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/noisy_images.h"

namespace ctpbench {
namespace {

using test::noisy_image;
using test::relmse_of;

ReferenceImage reference(std::uint64_t seed) {
    return {noisy_image(seed, 128, 0.2), noisy_image(seed + 1, 128, 0.2)};
}

ImageBias bias_of(std::uint64_t seed, int samples, double bias) {
    ImageBias sum;
    for (std::uint64_t s = 0; s < 8; ++s) sum.add(noisy_image(seed + s, samples, 0.2, bias));
    return sum;
}

// The images' own error is forty times the squared bias. One experiment finds that within a quarter of it
// (one standard error), the mean of twenty within 6 %.
TEST(ImageBias, IsFoundFarBelowTheNoise) {
    const double bias = 0.0316, truth = relmse_of(bias * bias);
    double sum = 0.0;
    int covered = 0;
    for (std::uint64_t i = 0; i < 20; ++i) {
        const BoundedValue found = bias_of(10 + 20 * i, 1, bias).relmse(reference(20 + 20 * i));
        sum += found.value;
        covered += found.lo <= truth && truth <= found.hi;
    }
    EXPECT_NEAR(sum / 20.0, truth, 0.2 * truth);
    EXPECT_GE(covered, 16);
    EXPECT_GT(bias_of(10, 4, 2.0 * bias).relmse(reference(100)).lo, 0.0);
}

// Zero is in the interval 95 times in 100: of 60 experiments in 57, with a standard error of 1.7.
TEST(ImageBias, OfAnUnbiasedRendererHoldsZero) {
    int covered = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const BoundedValue found = bias_of(1000 + 20 * i, 2, 0.0).relmse(reference(1010 + 20 * i));
        covered += found.lo <= 0.0 && 0.0 <= found.hi;
        EXPECT_LT(found.hi, 0.03 * relmse_of(0.02));  // of the error of one image
    }
    EXPECT_GE(covered, 52);
    EXPECT_LT(covered, 60);
}

TEST(ImageBias, NeedsTwoImages) {
    ImageBias sum;
    EXPECT_TRUE(std::isnan(sum.relmse(reference(1)).value));
    sum.add(noisy_image(5, 1));
    EXPECT_TRUE(std::isnan(sum.relmse(reference(1)).value));
    sum.add(noisy_image(6, 1));
    EXPECT_FALSE(std::isnan(sum.relmse(reference(1)).value));
    EXPECT_EQ(sum.images(), 2u);
}

}  // namespace
}  // namespace ctpbench
