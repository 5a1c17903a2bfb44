#include "measure/bounded_value.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>

namespace ctpbench {
namespace {

TEST(StudentT, IsTheQuantile) {
    for (const std::size_t degrees : {3u, 4u, 7u, 15u, 100u, 10000u}) {
        const double exact =
            boost::math::quantile(boost::math::students_t(static_cast<double>(degrees)), 0.975);
        EXPECT_NEAR(student_t(degrees), exact, (degrees < 7 ? 0.01 : 0.001) * exact) << degrees;
    }
}

TEST(MeanInterval, NeedsValues) {
    EXPECT_TRUE(std::isnan(mean_interval({}).value));
    EXPECT_EQ(mean_interval({1, 2, 6}).value, 3.0);
    EXPECT_TRUE(std::isnan(mean_interval({1, 2, 6}).lo));
    const BoundedValue four = mean_interval({1, 2, 3, 4});
    EXPECT_EQ(four.value, 2.5);
    EXPECT_NEAR(four.hi - four.value, 3.182 * std::sqrt(5.0 / 3.0 / 4.0), 0.03);
    EXPECT_DOUBLE_EQ(four.hi - four.value, four.value - four.lo);
}

// Over 2000 experiments of eight values the share that holds the truth has a standard error of 0.5 %.
TEST(MeanInterval, CoversTheMeanInNinetyFiveOfAHundred) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(5.0, 2.0);
    int covered = 0;
    for (int i = 0; i < 2000; ++i) {
        std::vector<double> values(8);
        for (double& v : values) v = normal(random);
        const BoundedValue interval = mean_interval(values);
        covered += interval.lo <= 5.0 && 5.0 <= interval.hi;
    }
    EXPECT_NEAR(covered / 2000.0, 0.95, 0.02);
}

// Of a mean, the jackknife is Student's interval.
TEST(JackknifeInterval, OfAMeanIsItsInterval) {
    const std::vector<double> values = {3, 1, 4, 1, 5, 9, 2, 6};
    const BoundedValue mean = mean_interval(values);
    const BoundedValue jackknife = jackknife_interval(
        mean.value, values.size(), [&](std::size_t i) { return (8.0 * mean.value - values[i]) / 7.0; });
    EXPECT_NEAR(jackknife.lo, mean.lo, 1e-12);
    EXPECT_NEAR(jackknife.hi, mean.hi, 1e-12);
    EXPECT_TRUE(std::isnan(jackknife_interval(1.0, 3, [](std::size_t) { return 1.0; }).lo));
}

}  // namespace
}  // namespace ctpbench
