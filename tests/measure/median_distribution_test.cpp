#include "measure/median_distribution.h"

#include <gtest/gtest.h>

#include <map>

#include "measure/statistics.h"
#include "support.h"

namespace ctpbench {
namespace {

// Medians of all n^n resamples, one by one.
std::map<double, double> enumerated(const std::vector<double>& x) {
    const std::size_t n = x.size();
    std::size_t count = 1;
    for (std::size_t i = 0; i < n; ++i) count *= n;
    std::map<double, double> probability;
    for (std::size_t code = 0; code < count; ++code) {
        std::vector<double> drawn;
        for (std::size_t i = 0, rest = code; i < n; ++i, rest /= n) drawn.push_back(x[rest % n]);
        probability[median(drawn)] += 1.0 / static_cast<double>(count);
    }
    return probability;
}

std::map<double, double> exact(const std::vector<double>& x) {
    std::map<double, double> probability;
    const MedianDistribution medians(x);
    for (const auto& [value, p] : medians.atoms()) probability[value] += p;
    return probability;
}

TEST(MedianDistribution, IsThatOfAllResamples) {
    for (const std::vector<double>& x : std::vector<std::vector<double>>{{3},
                                                                         {1, 4},
                                                                         {5, 1, 2},
                                                                         {1, 2, 4, 8},
                                                                         {7, 1, 3, 3, 20},
                                                                         {1, 2, 4, 8, 16, 32},
                                                                         {1, 9, 2, 8, 3, 7, 4}}) {
        std::map<double, double> ours = exact(x), all = enumerated(x);
        for (const auto& [value, p] : all) EXPECT_NEAR(ours[value], p, 1e-12) << x.size() << ": " << value;
        for (const auto& [value, p] : ours) EXPECT_NEAR(all[value], p, 1e-12) << x.size() << ": " << value;
    }
}

TEST(MedianDistribution, LosesNoProbabilityWithManySamples) {
    for (const std::size_t n : {60u, 61u, 1000u, 1001u}) {
        test::Random random(n);
        std::vector<double> x(n);
        for (double& v : x) v = random.uniform(1.0f, 2.0f);
        double sum = 0.0, previous = 0.0;
        const MedianDistribution medians(x);
        for (const auto& [value, p] : medians.atoms()) {
            EXPECT_GE(value, previous);
            EXPECT_GE(p, 0.0);
            sum += p, previous = value;
        }
        EXPECT_NEAR(sum, 1.0, 1e-9) << n;
        EXPECT_LT(medians.quantile(0.025), median(x));
        EXPECT_GT(medians.quantile(0.975), median(x));
    }
}

TEST(MedianDistribution, OfRunsDrawsRunsThenRounds) {
    const std::vector<std::vector<double>> runs = {{1.0, 1.2, 1.1}, {2.0, 2.5, 2.2}, {0.5, 1.15, 3.0}};
    std::vector<std::pair<double, double>> drawn;  // a run's median, and how probable
    for (const auto& run : runs)
        for (const auto& [value, p] : enumerated(run)) drawn.emplace_back(value, p / 3.0);
    std::map<double, double> expected;
    for (const auto& [x, p] : drawn)
        for (const auto& [y, q] : drawn)
            for (const auto& [z, r] : drawn) expected[median({x, y, z})] += p * q * r;
    std::map<double, double> ours;
    const MedianDistribution medians(runs);
    for (const auto& [value, p] : medians.atoms()) ours[value] += p;
    for (const auto& [value, p] : expected) EXPECT_NEAR(ours[value], p, 1e-12) << value;

    const MedianDistribution one(std::vector<std::vector<double>>{runs[0]}), plain(runs[0]);
    ASSERT_EQ(one.atoms().size(), plain.atoms().size());
    for (std::size_t i = 0; i < plain.atoms().size(); ++i)
        EXPECT_NEAR(one.atoms()[i].probability, plain.atoms()[i].probability, 1e-12);
}

TEST(RatioDistribution, IsThatOfAllPairs) {
    const std::vector<double> a = {1.0, 1.1, 0.9, 1.3}, b = {2.0, 2.4, 1.9};
    const MedianDistribution of_a(a), of_b(b);
    const RatioDistribution ratio(of_a, of_b);
    for (const double limit : {0.3, 0.42, 0.5, 0.55, 0.7}) {
        double below = 0.0, up_to = 0.0;
        for (const auto& [x, p] : enumerated(a))
            for (const auto& [y, q] : enumerated(b)) {
                below += x < limit * y ? p * q : 0.0;
                up_to += x <= limit * y ? p * q : 0.0;
            }
        EXPECT_NEAR(ratio.below(limit), below, 1e-12) << limit;
        EXPECT_NEAR(ratio.up_to(limit), up_to, 1e-12) << limit;
    }
    for (const double share : {0.025, 0.5, 0.975}) {
        const double q = ratio.quantile(share);
        EXPECT_GE(ratio.up_to(q * (1.0 + 1e-9)), share);
        EXPECT_LT(ratio.below(q * (1.0 - 1e-9)), share);
    }
}

}  // namespace
}  // namespace ctpbench
