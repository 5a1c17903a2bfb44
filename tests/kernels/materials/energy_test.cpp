// What a material reflects of a constant illumination: the mean of its samples' weights must be the integral
// of shade() times the cosine, and never more than arrives. And light that goes back the way it came is
// reflected alike.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/materials/hemisphere.h"
#include "looks.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::gray;
using test::Hemisphere;

// One channel of what is reflected towards wo.
template <class M>
double reflected(const M& material, const Hemisphere& hemisphere, int channel, double tolerance = 1e-4) {
    const auto f = [&](Vec3 wi) {
        return material.shade(hemisphere.point(), wi)[channel] * hemisphere.cosine_of(wi);
    };
    return test::Integral(hemisphere, f).over_all(15, 30, tolerance);
}

Hemisphere over(test::Random& random, double cosine) {
    const Vec3 normal = random.direction();
    return {normal, random.direction(), cosine};
}

TEST(MaterialEnergy, MatteReflectsItsAlbedo) {
    test::Random random(1);
    const Vec3 albedo{1.0f, 0.5f, 0.0f};
    const Matte material = Matte::make(test::matte(albedo));
    for (const double cosine : {1.0, 0.3, 0.01}) {
        const Hemisphere h = over(random, cosine);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(reflected(material, h, c), albedo[c], 1e-5);
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const Scattering s = material.sample(h.point(), PathRandom{1, i, 0, 0});
            ASSERT_EQ(s.event, ScatterEvent::scattered);
            ASSERT_EQ(s.weight, albedo);
        }
        EXPECT_EQ(material.shade(h.point(), h.direction(-0.5, 1.0)), gray(0.0f)) << "from behind";
    }
}

TEST(MaterialEnergy, PlasticsSamplesHaveTheMeanOfTheirIntegral) {
    constexpr std::uint32_t n = 40000;
    test::Random random(2);
    for (const auto& [kd, ks] : {std::pair<Vec3, Vec3>{{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}},
                                 {{0.7f, 0.2f, 0.0f}, {0.1f, 0.3f, 0.9f}},
                                 {{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}},
                                 {{1.0f, 0.8f, 0.1f}, {0.9f, 0.9f, 0.2f}}})  // make() must halve these
        for (const float exponent : {0.0f, 5.0f, 40.0f, 100.0f, 1000.0f})
            for (const double cosine : {1.0, 0.6, 0.1, 0.01}) {
                SCOPED_TRACE(testing::Message() << "kd " << kd.x << ", ks " << ks.x << ", exponent "
                                                << exponent << ", wo at " << cosine);
                const Plastic material = Plastic::make(test::plastic(kd, ks, exponent));
                const Hemisphere h = over(random, cosine);
                double sum[3] = {}, squares[3] = {};
                for (std::uint32_t i = 0; i < n; ++i) {
                    const Vec3 w = material.sample(h.point(), PathRandom{3, i, 0, 0}).weight;
                    for (int c = 0; c < 3; ++c) sum[c] += w[c], squares[c] += double{w[c]} * w[c];
                }
                for (int c = 0; c < 3; ++c) {
                    const double mean = sum[c] / n;
                    const double sigma = std::sqrt(std::fmax(0.0, squares[c] / n - mean * mean) / n);
                    const double integral = reflected(material, h, c);
                    EXPECT_NEAR(mean, integral, 4.0 * sigma + 1e-4);
                    EXPECT_LE(integral, 1.0 + 1e-4);
                }
            }
}

// Whatever is described, more does not come back than arrives, and nothing comes back negative.
TEST(MaterialEnergy, PlasticNeverReflectsMoreThanArrives) {
    test::Random random(4);
    double most = 0.0;
    for (int i = 0; i < 150; ++i) {
        const float exponent = std::pow(10.0f, random.uniform(-2.0f, 3.0f));
        const Plastic material =
            Plastic::make(test::plastic(random.point(0.0f, 1.0f), random.point(0.0f, 1.0f), exponent));
        const double cosine = std::pow(random.uniform(0.03f, 1.0f), 2.0f);
        const Hemisphere h = over(random, cosine);
        for (int c = 0; c < 3; ++c) {
            const double r = reflected(material, h, c);
            ASSERT_GE(r, 0.0);
            ASSERT_LE(r, 1.0 + 1e-4) << "exponent " << exponent << ", wo at " << cosine;
            most = std::fmax(most, r);
        }
    }
    EXPECT_GT(most, 0.95) << "the bound is approached, or it was not tried";
}

// Where nothing of the lobe is below the horizon nothing is lost: V-shaped grooves only redirect.
TEST(MaterialEnergy, ANarrowLobeFromAboveLosesNothing) {
    test::Random random(5);
    const Plastic material = Plastic::make(test::plastic(gray(0.0f), gray(1.0f), 1000.0f));
    EXPECT_NEAR(reflected(material, over(random, 0.9), 0), 1.0, 1e-3);
}

TEST(MaterialEnergy, ScalesDownWhatWouldReflectMoreThanArrives) {
    const Plastic over_bright = Plastic::make(test::plastic({1.0f, 0.6f, 0.2f}, {1.0f, 0.2f, 0.2f}, 10.0f));
    EXPECT_EQ(over_bright.color.factor, (Vec3{0.5f, 0.3f, 0.1f}));
    EXPECT_EQ(over_bright.specular, (Vec3{0.5f, 0.1f, 0.1f}));
    const Plastic fair = Plastic::make(test::plastic({0.5f, 0.4f, 0.1f}, {0.5f, 0.2f, 0.2f}, 10.0f));
    EXPECT_EQ(fair.color.factor, (Vec3{0.5f, 0.4f, 0.1f}));
    EXPECT_EQ(fair.specular, (Vec3{0.5f, 0.2f, 0.2f}));
}

TEST(MaterialEnergy, LightThatGoesBackIsReflectedAlike) {
    test::Random random(6);
    const Matte matte = Matte::make(test::matte({0.2f, 0.5f, 0.8f}));
    for (int i = 0; i < 20000; ++i) {
        const Hemisphere forth = over(random, random.uniform(0.02f, 1.0f));
        const Vec3 wi = forth.direction(random.uniform(0.02f, 1.0f), random.uniform(0.0f, 6.28f));
        SurfacePoint back = forth.point();
        back.wo = wi;
        EXPECT_EQ(matte.shade(forth.point(), wi), matte.shade(back, forth.point().wo));
        const float exponent = std::pow(10.0f, random.uniform(-1.0f, 3.0f));
        const Plastic plastic =
            Plastic::make(test::plastic({0.2f, 0.1f, 0.0f}, {0.3f, 0.6f, 0.9f}, exponent));
        const Vec3 a = plastic.shade(forth.point(), wi), b = plastic.shade(back, forth.point().wo);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(a[c], b[c], 1e-4f * a[c]) << "exponent " << exponent;
    }
}

}  // namespace
}  // namespace ctpbench
