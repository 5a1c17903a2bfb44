// Does sample() pick directions with the density that pdf() says? Counts over a grid of directions against
// integrals of pdf() over its cells, by Pearson's test; samples that are dropped have a cell of their own,
// which expects what pdf() leaves out above the horizon.
#include <gtest/gtest.h>

#include <vector>

#include "kernels/materials/chi_square.h"
#include "kernels/materials/hemisphere.h"
#include "looks.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::gray;
using test::Hemisphere;

constexpr double kCosines[] = {1.0, 0.9, 0.5, 0.1, 0.01};  // of wo
constexpr int kRows = 30, kColumns = 60;
constexpr std::uint32_t kSamples = 60000;
constexpr double kFalseAlarms = 1e-4;  // of a whole test, however many cases it has

struct Judged {
    test::ChiSquare chi_square;
    double density;  // pdf() summed over all directions
    std::uint32_t dropped;
};

template <class M>
Judged judge(const M& material, const Hemisphere& hemisphere, std::uint64_t seed) {
    const SurfacePoint& point = hemisphere.point();
    const auto pdf = [&](Vec3 wi) { return static_cast<double>(material.pdf(point, wi)); };
    const test::Integral integral(hemisphere, pdf);
    std::vector<double> expected, observed(kRows * kColumns + 1, 0.0);
    Judged judged{{}, 0.0, 0};
    for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < kColumns; ++j) {
            const double p = integral.over(integral.cell(i, j, kRows, kColumns), 1e-6);
            judged.density += p;
            expected.push_back(kSamples * p);
        }
    expected.push_back(kSamples * std::max(0.0, 1.0 - judged.density));

    for (std::uint32_t s = 0; s < kSamples; ++s) {
        const Scattering scattering = material.sample(point, PathRandom{seed, s, 0, 0});
        const double cosine = hemisphere.cosine_of(scattering.direction);
        if (scattering.event == ScatterEvent::dropped) {
            ++judged.dropped;
            observed.back() += 1.0;
            continue;
        }
        EXPECT_EQ(scattering.event, ScatterEvent::scattered);
        EXPECT_GT(cosine, -1e-6);
        const double angle = std::acos(std::min(std::max(cosine, 0.0), 1.0));
        const int i = std::min(kRows - 1, static_cast<int>(angle * (kRows / (0.5 * test::kPi))));
        const double turn = hemisphere.azimuth_of(scattering.direction) / (2.0 * test::kPi);
        observed[i * kColumns + std::min(kColumns - 1, static_cast<int>(turn * kColumns))] += 1.0;
    }
    judged.chi_square = test::chi_square(observed, expected);
    return judged;
}

// A new normal for each case, so that the samplers' frames are tested with them.
Hemisphere over(test::Random& random, double cosine) {
    const Vec3 normal = random.direction();
    return {normal, random.direction(), cosine};
}

TEST(MaterialSampling, MatteFollowsItsDensity) {
    test::Random random(1);
    const Matte material = Matte::make(test::matte(gray(0.5f)));
    std::uint64_t seed = 100;
    double least = 1.0;
    for (const double cosine : kCosines) {
        const Judged j = judge(material, over(random, cosine), seed++);
        EXPECT_GT(j.chi_square.p_value, kFalseAlarms / std::size(kCosines)) << "wo at " << cosine;
        EXPECT_GT(j.chi_square.cells, 500u);
        EXPECT_NEAR(j.density, 1.0, 1e-5);
        EXPECT_EQ(j.dropped, 0u);
        least = std::min(least, j.chi_square.p_value);
    }
    RecordProperty("least_p_value", std::to_string(least));
}

TEST(MaterialSampling, PlasticFollowsItsDensity) {
    constexpr float exponents[] = {0.0f, 5.0f, 40.0f, 100.0f, 1000.0f};
    constexpr float shares[] = {0.0f, 0.25f, 0.75f, 1.0f};  // of the Lambertian lobe
    constexpr double cases = std::size(exponents) * std::size(shares) * std::size(kCosines);
    test::Random random(3);
    std::uint64_t seed = 100;
    double least = 1.0;
    for (const float exponent : exponents)
        for (const float share : shares)
            for (const double cosine : kCosines) {
                SCOPED_TRACE(testing::Message() << "exponent " << exponent << ", Lambertian share " << share
                                                << ", wo at " << cosine);
                const Plastic material =
                    Plastic::make(test::plastic(gray(0.8f * share), gray(0.8f * (1.0f - share)), exponent));
                ASSERT_NEAR(material.diffuse_share, share, 1e-6);
                const Judged j = judge(material, over(random, cosine), seed++);
                EXPECT_GT(j.chi_square.p_value, kFalseAlarms / cases)
                    << "chi-square " << j.chi_square.statistic << " over " << j.chi_square.cells << " cells";
                EXPECT_GT(j.chi_square.cells, 10u);
                EXPECT_LE(j.density, 1.0 + 1e-4);
                EXPECT_TRUE(share < 1.0f || j.dropped == 0);
                least = std::min(least, j.chi_square.p_value);
            }
    RecordProperty("least_p_value", std::to_string(least));
}

// The figure for a lobe of exponent 100 that is seen at a grazing angle: half of its directions point into
// the surface.
TEST(MaterialSampling, HalfOfAGrazingLobeIsBelowTheHorizon) {
    test::Random random(5);
    const Plastic material = Plastic::make(test::plastic(gray(0.0f), gray(0.9f), 100.0f));
    const Judged j = judge(material, over(random, 0.001), 6);
    EXPECT_NEAR(j.dropped / double{kSamples}, 0.5, 0.02);
}

// The test itself: it finds a density that is wrong by a few percent, and is not fooled by what is right.
TEST(MaterialSampling, IsTestedSharply) {
    std::vector<double> expected(100, 100.0), right(expected), wrong(expected);
    test::Random random(7);
    for (int i = 0; i < 100; ++i) {
        right[i] += random.uniform(-17.0f, 17.0f);  // a variance of 96
        wrong[i] += i % 2 == 0 ? 20.0 : -20.0;
    }
    EXPECT_GT(test::chi_square(right, expected).p_value, 0.01);
    EXPECT_LT(test::chi_square(wrong, expected).p_value, 1e-10);
    // Counts where there should be none are not lost in the pool.
    expected.push_back(0.0), right.push_back(150.0);
    EXPECT_LT(test::chi_square(right, expected).p_value, 1e-4);
}

}  // namespace
}  // namespace ctpbench
