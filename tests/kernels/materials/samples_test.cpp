// Single samples: what each material does with a path, also at grazing angles and with the extremes of what
// random numbers can be.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/materials/hemisphere.h"
#include "looks.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::gray;
using test::Hemisphere;

// With seed 1, the pixels whose first, second or third number is the least there is, or the largest.
struct Extreme {
    std::uint32_t pixel;
    int number;
    float value;
};
constexpr float kTop = 1.0f - 0x1p-24f;
constexpr Extreme kExtremes[] = {{6099793, 0, 0.0f},  {10223920, 0, kTop}, {3806399, 1, 0.0f},
                                 {37492293, 1, kTop}, {2102087, 2, 0.0f},  {25035411, 2, kTop}};

// Normals at random and along the axes, where frames have their seams.
Vec3 some_normal(test::Random& random, int i) {
    const Vec3 axes[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    return i % 8 < 4 ? axes[i % 8] : random.direction();
}
// Cosines from 1 down to 1e-7.
Hemisphere over(test::Random& random, int i) {
    return {some_normal(random, i), random.direction(), std::pow(10.0, random.uniform(-7.0f, 0.0f))};
}

template <class M>
void expect_sound(const M& material, const SurfacePoint& point, const PathRandom& random) {
    const Scattering s = material.sample(point, random);
    for (int c = 0; c < 3; ++c) {
        ASSERT_GE(s.weight[c], 0.0f);  // and is a number
        ASSERT_LT(s.weight[c], 1e3f);
        ASSERT_EQ(s.emitted[c], 0.0f);
    }
    if (s.event == ScatterEvent::dropped) {
        ASSERT_EQ(s.weight, gray(0.0f));
        return;
    }
    ASSERT_EQ(s.event, ScatterEvent::scattered);
    ASSERT_NEAR(length(s.direction), 1.0f, 1e-5f);
    ASSERT_GE(dot(s.direction, point.normal), -1e-6f);
    ASSERT_GE(material.pdf(point, s.direction), 0.0f);
    for (int c = 0; c < 3; ++c) ASSERT_GE(material.shade(point, s.direction)[c], 0.0f);
}

template <class M>
void expect_all_sound(const M& material, test::Random& random, int draws) {
    for (int i = 0; i < draws; ++i) {
        const Hemisphere h = over(random, i);
        ASSERT_NO_FATAL_FAILURE(expect_sound(material, h.point(), {7, static_cast<std::uint32_t>(i), 0, 0}));
        for (const Extreme& e : kExtremes)
            ASSERT_NO_FATAL_FAILURE(expect_sound(material, h.point(), {1, e.pixel, 0, 0}));
    }
}

TEST(MaterialSamples, AreTriedWithTheExtremesOfRandomNumbers) {
    for (const Extreme& e : kExtremes)
        EXPECT_EQ((PathRandom{1, e.pixel, 0, 0}.draw().v[e.number]), e.value) << "pixel " << e.pixel;
}

TEST(MaterialSamples, AreSoundWhateverTheAngle) {
    test::Random random(1);
    expect_all_sound(Matte::make(test::matte({1.0f, 0.5f, 0.0f})), random, 5000);
    expect_all_sound(Mirror::make(test::mirror({1.0f, 0.5f, 0.0f})), random, 5000);
    for (const float exponent : {0.0f, 1.0f, 100.0f, 1e3f, 1e5f})
        for (const float kd : {0.0f, 1e-6f, 0.5f, 1.0f}) {
            SCOPED_TRACE(testing::Message() << "exponent " << exponent << ", kd " << kd);
            expect_all_sound(Plastic::make(test::plastic(gray(kd), gray(1.0f - kd), exponent)), random, 1000);
        }
    expect_all_sound(Plastic::make(test::plastic(gray(0.0f), gray(0.0f), 10.0f)), random, 1000);
}

// A glossy lobe alone weighs at most 2 (and so does any mixture that a lobe is picked from fairly).
TEST(MaterialSamples, OfPlasticWeighAtMostTwo) {
    test::Random random(2);
    float most = 0.0f;
    for (const float kd : {0.0f, 0.3f, 0.9f})
        for (int i = 0; i < 20000; ++i) {
            const float exponent = std::pow(10.0f, random.uniform(-1.0f, 4.0f));
            const Plastic material = Plastic::make(test::plastic(gray(kd), gray(1.0f - kd), exponent));
            const Hemisphere h = over(random, i);
            const Vec3 w = material.sample(h.point(), {7, static_cast<std::uint32_t>(i), 0, 0}).weight;
            most = std::fmax(most, w.x);
        }
    EXPECT_LE(most, 2.0f + 1e-4f);
    EXPECT_GT(most, 1.9f);
}

TEST(MaterialSamples, OfAMirrorGoWhereLightIsReflected) {
    test::Random random(3);
    const Vec3 reflectance{0.9f, 0.8f, 0.0f};
    const Mirror material = Mirror::make(test::mirror(reflectance));
    for (int i = 0; i < 20000; ++i) {
        const Hemisphere h = over(random, i);
        const SurfacePoint& p = h.point();
        const Scattering s = material.sample(p, {1, 0, 0, 0});
        ASSERT_EQ(s.event, ScatterEvent::scattered);
        ASSERT_EQ(s.weight, reflectance);
        ASSERT_NEAR(dot(s.direction, p.normal), dot(p.wo, p.normal), 1e-6f) << "angle out is angle in";
        ASSERT_NEAR(length(s.direction), 1.0f, 1e-5f);
        // What wo and the new direction have in common is along the normal: they lie in a plane with it.
        ASSERT_NEAR(length(cross(s.direction + p.wo, p.normal)), 0.0f, 1e-6f);
        ASSERT_EQ(material.shade(p, s.direction), gray(0.0f)) << "a mirror has no density";
        ASSERT_EQ(material.pdf(p, s.direction), 0.0f);
    }
}

TEST(MaterialSamples, OfALightEndThePath) {
    test::Random random(4);
    const Vec3 radiance{3.0f, 2.0f, 0.5f};
    const Emissive material = Emissive::make(test::emissive(radiance));
    for (int i = 0; i < 100; ++i) {
        const Hemisphere h = over(random, i);
        const Scattering s = material.sample(h.point(), {1, 0, 0, 0});
        EXPECT_EQ(s.event, ScatterEvent::absorbed);
        EXPECT_EQ(s.emitted, radiance);
        EXPECT_EQ(s.weight, gray(0.0f));
        EXPECT_EQ(material.shade(h.point(), h.point().normal), gray(0.0f));
        EXPECT_EQ(material.pdf(h.point(), h.point().normal), 0.0f);
    }
}

// One triangle over a texture of two texels: on the left a hole, on the right a colour.
template <class M>
void expect_hole_and_tint(MaterialDescription description) {
    const std::array<Vec2, 3> texcoords = {{{0.25f, 0.5f}, {0.75f, 0.5f}, {0.25f, 0.5f}}};
    const Texel texels[] = {{65535, 65535, 65535, 0}, {65535, 32768, 0, 65535}};
    const SurfaceAttributes attributes{&texcoords, texels};
    description.texture = {0, 2, 1};
    const M material = M::make(description);
    SurfacePoint point{{0, 0, 1}, {0, 0.6f, 0.8f}, &attributes, 0, 0.0f, 0.0f};
    for (const float u : {0.0f, 0.2f, 0.49f}) {
        point.u = u;
        EXPECT_EQ(material.sample(point, {1, 0, 0, 0}).event, ScatterEvent::passed);
        EXPECT_EQ(material.shade(point, {0, 0, 1}), gray(0.0f));
    }
    for (const float u : {0.51f, 0.8f, 1.0f}) {
        point.u = u;
        EXPECT_NE(material.sample(point, {1, 0, 0, 0}).event, ScatterEvent::passed);
    }
    const float expected[] = {0.5f, 0.5f * 32768 / 65535, 0.0f};  // the constant tints
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(material.shade(point, {0, 0, 1})[c], expected[c] * kInvPi, 1e-6f);
    for (std::uint32_t i = 0; i < 100; ++i) {
        const Scattering s = material.sample(point, {1, i, 0, 0});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(s.weight[c], expected[c], 1e-6f);
    }
}
TEST(MaterialSamples, FindHolesAndTintInTextures) {
    expect_hole_and_tint<Matte>(test::matte(gray(0.5f)));
    expect_hole_and_tint<Plastic>(test::plastic(gray(0.5f), gray(0.0f), 10.0f));
}

}  // namespace
}  // namespace ctpbench
