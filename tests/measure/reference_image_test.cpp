#include "measure/reference_image.h"

#include <gtest/gtest.h>

#include "measure/noisy_images.h"

namespace ctpbench {
namespace {

using test::noisy_image;
using test::relmse_of;

// Without noise it is the formula.
TEST(ReferenceImage, RelmseOfAnExactReference) {
    const ReferenceImage reference(noisy_image(1, 1, 0.0), noisy_image(2, 1, 0.0));
    EXPECT_EQ(reference.pixels(), test::kNoisyPixels);
    EXPECT_EQ(reference.noise(), 0.0);
    EXPECT_EQ(reference.relmse(noisy_image(3, 1, 0.0)), 0.0);
    EXPECT_NEAR(reference.relmse(noisy_image(3, 1, 0.0, 0.25)), relmse_of(0.0625), 1e-5 * relmse_of(0.0625));
}

// With 64 samples of deviation 0.1 in the reference, its noise is as large as the error looked for, and is
// told apart. An estimate has a standard error of sqrt(2 / 2700), 3 %.
TEST(ReferenceImage, RelmseIsFreeOfTheReferencesNoise) {
    const ReferenceImage reference(noisy_image(1, 32, 0.1), noisy_image(2, 32, 0.1));
    const double error = 0.01 / 64;
    EXPECT_NEAR(reference.noise(), relmse_of(error), 0.1 * relmse_of(error));
    EXPECT_NEAR(reference.relmse(noisy_image(3, 64, 0.1)), relmse_of(error), 0.2 * relmse_of(error));
    EXPECT_NEAR(reference.relmse(noisy_image(4, 1, 0.0)), 0.0, 0.2 * relmse_of(error));
}

}  // namespace
}  // namespace ctpbench
