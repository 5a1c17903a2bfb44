// Sphere tests: all find the near side from outside and the far side from inside; they differ in how far away
// and how near they can be trusted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/methods/lists.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

template <class Test>
class SphereTest : public testing::Test {};
using AllSphereTests = Rebind<testing::Types, SphereTests>;
TYPED_TEST_SUITE(SphereTest, AllSphereTests);

TYPED_TEST(SphereTest, HitsTheNearSideFromOutsideAndTheFarSideFromInside) {
    const auto shape = TypeParam::shape({{0, 0, 5}, 1});
    const auto t_of = [&](Vec3 origin) {
        const Ray ray = {origin, {0, 0, 2}, kInfinity};
        Hit hit = no_hit(ray);
        TypeParam::intersect(shape, 1, TypeParam::setup(ray), hit);
        return hit.primitive == 1 ? hit.t : -1.0f;
    };
    EXPECT_FLOAT_EQ(t_of({0, 0, 0}), 2.0f);
    EXPECT_FLOAT_EQ(t_of({0, 0, 5}), 0.5f);
    EXPECT_EQ(t_of({0, 0, 7}), -1.0f);
    EXPECT_EQ(t_of({0, 1.01f, 0}), -1.0f);
}

TYPED_TEST(SphereTest, TiesGoToTheLowestId) {
    const auto shape = TypeParam::shape({{0, 0, 5}, 1});
    const Ray ray = {{0, 0, 0}, {0, 0, 1}, kInfinity};
    Hit hit = no_hit(ray);
    for (const std::uint32_t id : {7u, 3u, 9u}) TypeParam::intersect(shape, id, TypeParam::setup(ray), hit);
    EXPECT_EQ(hit.primitive, 3u);
}

// Rays that start on the sphere along its tangent: origin and both roots are rounding, but what is reported
// lies on the sphere.
TEST(StableSphere, AGrazingStartIsReportedOnTheSphere) {
    Random random(5);
    const auto shape = StableSphere::shape({{0, 0, 0}, 1});
    double worst = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const Vec3 origin = random.direction();
        const Vec3 d = normalize(cross(origin, random.direction())) - random.uniform(0, 1e-4f) * origin;
        const Ray ray = {origin, 3.0f * d, kInfinity};
        Hit hit = no_hit(ray);
        StableSphere::intersect(shape, 0, StableSphere::setup(ray), hit);
        if (hit.primitive != 0) continue;
        double rr = 0.0;
        for (int a = 0; a < 3; ++a) {
            const double p = double{ray.origin[a]} + double{hit.t} * double{ray.direction[a]};
            rr += p * p;
        }
        worst = std::max(worst, std::fabs(std::sqrt(rr) - 1.0));
    }
    EXPECT_LT(worst, 16 * 0x1p-24);
}

struct Wrong {
    double missed, false_hits;  // per million rays that should hit, and that should not
};

// Rays from so many radii away: at a disk of 0.99 radii, evenly, and past it by 1 to 10 %.
template <class Test>
Wrong wrong_at(float distance) {
    constexpr int kRays = 50000;
    Random random(2);
    int missed = 0, false_hits = 0;
    for (int i = 0; i < 2 * kRays; ++i) {
        const bool hits = i % 2 == 0;
        const Vec3 d = random.direction(), side = normalize(cross(d, random.direction()));
        const float impact = hits ? 0.99f * std::sqrt(random.uniform(0, 1)) : random.uniform(1.01f, 1.1f);
        const Ray ray = {side * impact - d * distance, d, kInfinity};
        Hit hit = no_hit(ray);
        Test::intersect(Test::shape({{0, 0, 0}, 1}), 0, Test::setup(ray), hit);
        if (hits)
            missed += hit.primitive != 0;
        else
            false_hits += hit.primitive == 0;
    }
    testing::Test::RecordProperty("missed_at_" + std::to_string(static_cast<int>(distance)), missed);
    return {1e6 * missed / kRays, 1e6 * false_hits / kRays};
}

TEST(Spheres, TheTextbookFormFraysWithDistance) {
    EXPECT_EQ(wrong_at<TextbookSphere>(10.0f).missed, 0.0);
    const Wrong near = wrong_at<TextbookSphere>(1e3f), far = wrong_at<TextbookSphere>(1e4f);
    EXPECT_GT(near.missed, 1e3);
    EXPECT_LT(near.missed, 40e3);
    EXPECT_GT(far.missed, 150e3);
    EXPECT_GT(far.false_hits, 500e3);
}

TEST(Spheres, StableFormsDoNot) {
    for (const float distance : {10.0f, 1e3f, 4e3f, 1e4f}) {
        const Wrong single = wrong_at<StableSphere>(distance), twice = wrong_at<StableSphere64>(distance);
        EXPECT_EQ(single.missed + single.false_hits, 0.0) << distance;
        EXPECT_EQ(twice.missed + twice.false_hits, 0.0) << distance;
    }
}

// Largest error of t on a planet of a million units, from a height of one.
template <class Test>
double planet_error() {
    const double height = 1e6 + 1;
    Random random(2);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        Vec3 d = random.direction();
        d.y = -std::fabs(d.y) - 0.2f;
        d = normalize(d);
        const Ray ray = {{0, 1000001.0f, 0}, d, kInfinity};
        Hit hit = no_hit(ray);
        Test::intersect(Test::shape({{0, 0, 0}, 1e6f}), 0, Test::setup(ray), hit);
        EXPECT_EQ(hit.primitive, 0u);
        const double dd = double{d.x} * d.x + double{d.y} * d.y + double{d.z} * d.z, b = height * d.y;
        const double t = (height * height - 1e12) / (-b + std::sqrt(b * b - dd * (height * height - 1e12)));
        worst = std::fmax(worst, std::fabs(hit.t - t));
    }
    return worst;
}

TEST(Spheres, OnlyFloat64StandsOnAPlanet) {
    EXPECT_GT(planet_error<StableSphere>(), 0.01);
    EXPECT_GT(planet_error<TextbookSphere>(), 0.01);
    EXPECT_LT(planet_error<StableSphere64>(), 1e-5);
}

}  // namespace
}  // namespace ctpbench
