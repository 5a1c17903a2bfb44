// The tests of geometry by what they promise: no leaks, boxes that never lose a hit, offsets that leave
// the surface.
#include <gtest/gtest.h>

#include "kernels/methods/bundles.h"
#include "kernels/methods/offset_waechter_binder.h"
#include "kernels/primitives/list.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

template <class Test>
Hit trace_all(const Mesh& mesh, const Ray& ray) {
    Hit hit = no_hit(ray);
    const auto setup = Test::setup(ray);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        Test::intersect(Test::shape(mesh.triangle(i)), i, setup, hit);
    return hit;
}

// Rays from inside a closed mesh at points on its edges and at its vertices, rounded to float: any miss is
// a leak.
template <class Test>
int leaks(float offset, int rays) {
    const Vec3 center = {offset, -offset, 0.5f * offset};
    const Mesh mesh = test::star(2, 1.0f, center, 3);
    Random random(5);
    int missed = 0;
    for (int i = 0; i < rays; ++i) {
        const auto& t = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
        const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]];
        const Vec3 origin = center + 0.3f * random.point(-1.0f, 1.0f);
        const Vec3 at = i % 2 == 0 ? a + random.uniform(0.0f, 1.0f) * (b - a) : a;
        missed += trace_all<Test>(mesh, {origin, at - origin, kInfinity}).primitive == kNoPrimitive;
    }
    return missed;
}

TEST(WatertightTriangle, NeverLeaks) {
    EXPECT_EQ(leaks<WatertightTriangle>(0.0f, 20000), 0);
    EXPECT_EQ(leaks<WatertightTriangle>(1.5e5f, 20000), 0);
}

// What the watertight test is there for; were this to fail, the rays above would prove nothing.
TEST(MoellerTrumboreTriangle, LeaksAtEdges) { EXPECT_GT(leaks<MoellerTrumbore>(0.0f, 20000), 100); }

template <class Test>
class TriangleTest : public testing::Test {};
using TriangleTests = testing::Types<WatertightTriangle, MoellerTrumbore>;
TYPED_TEST_SUITE(TriangleTest, TriangleTests);

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

TEST(StableSphere, HitsTheNearSideFromOutsideAndTheFarSideFromInside) {
    const auto shape = StableSphere::shape({{0, 0, 5}, 1});
    const auto t_of = [&](Vec3 origin) {
        const Ray ray = {origin, {0, 0, 2}, kInfinity};
        Hit hit = no_hit(ray);
        StableSphere::intersect(shape, 1, StableSphere::setup(ray), hit);
        return hit.primitive == 1 ? hit.t : -1.0f;
    };
    EXPECT_FLOAT_EQ(t_of({0, 0, 0}), 2.0f);
    EXPECT_FLOAT_EQ(t_of({0, 0, 5}), 0.5f);
    EXPECT_EQ(t_of({0, 0, 7}), -1.0f);
    EXPECT_EQ(t_of({0, 1.01f, 0}), -1.0f);
}

// accuracy.md's failure of the textbook form: far away it misses and hits at random.
TEST(StableSphere, IsSoundAtADistanceOfTenThousandRadii) {
    Random random(2);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 d = random.direction();
        const Vec3 side = normalize(cross(d, random.direction()));
        const float impact = i % 2 == 0 ? random.uniform(0.0f, 0.99f) : random.uniform(1.01f, 1.1f);
        const Ray ray = {side * impact - d * 1e4f, d, kInfinity};
        Hit hit = no_hit(ray);
        StableSphere::intersect(StableSphere::shape({{0, 0, 0}, 1}), 0, StableSphere::setup(ray), hit);
        wrong += (hit.primitive == 0) != (impact < 1.0f);
    }
    EXPECT_EQ(wrong, 0);
}

BvhNode node_of(const Box& box) {
    BvhNode node{};
    node.set_box(box);
    return node;
}

// Flat boxes, rays along their planes, origins on grid planes, zero components: the box of a point that
// the ray passes is never missed, and never entered after it.
TEST(PaddedBox, NeverLosesAPointOfTheRay) {
    Random random(9);
    for (float scale : {1e-6f, 1.0f, 1.5e5f}) {
        const float extent = 4.0f * scale;
        for (int i = 0; i < 50000; ++i) {
            Vec3 origin = scale * random.point(-4, 4), d = random.direction();
            if (i % 3 == 0) d[i % 2] = i % 5 == 0 ? -0.0f : 0.0f;
            if (i % 7 == 0) origin[1] = scale * std::floor(random.uniform(-4, 4));
            const float t = scale * random.uniform(0.0f, 3.0f);
            const Vec3 p = origin + t * d;  // rounded: up to an ulp off the ray
            Box box = Box::empty();
            box.extend(p);
            if (i % 2 == 0) box.extend(p + scale * random.point(-0.5f, 0.5f));
            float near = 0.0f;
            ASSERT_TRUE(PaddedBox::test(node_of(box), PaddedBox::setup({origin, d, kInfinity}, extent),
                                        kInfinity, near))
                << "ray " << i << " scale " << scale;
            EXPECT_LE(near, t);
        }
    }
}

TEST(PaddedBox, StillCulls) {
    const BvhNode node = node_of({{1, 1, 1}, {2, 2, 2}});
    float near;
    const auto hits = [&](Vec3 o, Vec3 d, float tmax) {
        return PaddedBox::test(node, PaddedBox::setup({o, d, tmax}, 2.0f), tmax, near);
    };
    EXPECT_TRUE(hits({0, 0, 0}, {1, 1, 1}, kInfinity));
    EXPECT_FALSE(hits({0, 0, 0}, {-1, -1, -1}, kInfinity));
    EXPECT_FALSE(hits({0, 0, 0}, {1, 1, 1}, 0.99f));
    EXPECT_FALSE(hits({0, 0, 0}, {1, 0, 0}, kInfinity)) << "parallel to the slab and outside it";
    EXPECT_TRUE(hits({0, 1.5f, 1.5f}, {1, 0, 0}, kInfinity));
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

TEST(OffsetOrigin, LeavesAConvexBallForGood) {
    Random random(4);
    for (float scale : {1.0f, 1e3f}) {
        for (float shift : {0.0f, 1e4f}) {
            const Vec3 center = {shift, -shift, shift};
            int returned = 0;
            for (int i = 0; i < 20000; ++i) {
                const Vec3 n = random.direction();
                const Vec3 p = center + scale * n;
                Vec3 d = random.direction();
                if (dot(d, n) < 0.0f) d = -d;
                const Ray ray = {offset_origin(p, n), d, kInfinity};
                Hit hit = no_hit(ray);
                StableSphere::intersect(StableSphere::shape({center, scale}), 0, StableSphere::setup(ray),
                                        hit);
                returned += hit.primitive == 0;
            }
            EXPECT_EQ(returned, 0) << "scale " << scale << ", shift " << shift;
        }
    }
}

}  // namespace
}  // namespace ctpbench
