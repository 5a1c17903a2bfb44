// What every triangle test must do with rays that are not made to break it.
#include <gtest/gtest.h>

#include "kernels/methods/lists.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

template <class Test>
class TriangleTest : public testing::Test {};
using AllTriangleTests = Rebind<testing::Types, TriangleTests>;
TYPED_TEST_SUITE(TriangleTest, AllTriangleTests);

TYPED_TEST(TriangleTest, FindsThePointThatTheRayWasAimedAt) {
    Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const TriangleShape s = {random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const float u = random.uniform(0.05f, 0.45f), v = random.uniform(0.05f, 0.45f);
        const Vec3 at = s.a + u * (s.b - s.a) + v * (s.c - s.a);
        const Vec3 origin = random.point(-3, 3);
        const Vec3 n = cross(s.b - s.a, s.c - s.a);
        const float cosine = std::fabs(dot(n, at - origin)) / (length(n) * length(at - origin));
        if (length(n) < 0.05f || cosine < 0.05f) continue;
        const Ray ray = {origin, 0.5f * (at - origin), kInfinity};  // t is in units of |d|
        Hit hit = no_hit(ray);
        TypeParam::intersect(TypeParam::shape(s), 7, TypeParam::setup(ray), hit);
        ASSERT_EQ(hit.primitive, 7u);
        EXPECT_NEAR(hit.t, 2.0f, 1e-4f);
        EXPECT_NEAR(hit.u, u, 1e-3f);
        EXPECT_NEAR(hit.v, v, 1e-3f);
    }
}

TYPED_TEST(TriangleTest, IgnoresWhatIsBehindOrBeyondTheBestHit) {
    const TriangleShape s = {{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}};
    const auto shape = TypeParam::shape(s);
    const auto test = [&](Vec3 d, Hit hit) {
        TypeParam::intersect(shape, 3, TypeParam::setup({{0, 0, 0}, d, kInfinity}), hit);
        return hit;
    };
    EXPECT_EQ(test({0, 0, 1}, {kInfinity, kNoPrimitive, 0, 0}).primitive, 3u);
    EXPECT_EQ(test({0, 0, -1}, {kInfinity, kNoPrimitive, 0, 0}).primitive, kNoPrimitive);
    EXPECT_EQ(test({0, 0, 1}, {1.5f, 9, 0, 0}).primitive, 9u);
    EXPECT_EQ(test({0, 0, 1}, {2.0f, 9, 0, 0}).primitive, 3u) << "a tie goes to the lower id";
    EXPECT_EQ(test({0, 0, 1}, {2.0f, 1, 0, 0}).primitive, 1u) << "a tie goes to the lower id";
}

// Three points on a line, or one: nothing to hit, whatever infinities the test meets on its way.
TYPED_TEST(TriangleTest, NeverHitsATriangleWithoutArea) {
    Random random(6);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 a = random.point(-1, 1), along = i % 3 == 0 ? Vec3{0, 0, 0} : random.direction();
        const TriangleShape s = {a, a + along, i % 2 == 0 ? a : a + along};
        const Vec3 origin = random.point(-3, 3);
        const Ray ray = {origin, i % 5 == 0 ? along : a - origin, kInfinity};
        if (dot(ray.direction, ray.direction) == 0.0f) continue;
        Hit hit = no_hit(ray);
        TypeParam::intersect(TypeParam::shape(s), 0, TypeParam::setup(ray), hit);
        EXPECT_EQ(hit.primitive, kNoPrimitive) << "t " << hit.t;
    }
}

// The floor of a conference room: thousands of units wide, a unit and a half below the origin. The offset of
// an origin on it is a few 1e-5, less than the rounding of anything that is as large as the floor.
TEST(WatertightTriangle, RaysThatLeaveALargeFloorDoNotHitIt) {
    Random random(12);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 corners[3] = {{-946.888f, -1.57216f, 668.489f},
                           {1653.25f, -1.57216f, 668.489f},
                           {1653.25f, -1.57216f, -1016.1f}};
        for (Vec3& c : corners) std::swap(c.y, c[axis]);
        const TriangleShape s = {corners[0], corners[1], corners[2]};
        Vec3 normal = {0, 0, 0};
        normal[axis] = 1.0f;
        int returned = 0;
        for (int i = 0; i < 50000; ++i) {
            const float u = random.uniform(0, 1), v = random.uniform(0, 1) * (1.0f - u);
            Vec3 d = random.direction();
            d[axis] = std::fabs(d[axis]);
            const Ray ray = {offset_origin(s.a + (u * (s.b - s.a) + v * (s.c - s.a)), normal), d, kInfinity};
            Hit hit = no_hit(ray);
            WatertightTriangle::intersect(WatertightTriangle::shape(s), 0, WatertightTriangle::setup(ray),
                                          hit);
            returned += hit.primitive == 0;
        }
        EXPECT_EQ(returned, 0) << "normal along axis " << axis;
    }
}

}  // namespace
}  // namespace ctpbench
