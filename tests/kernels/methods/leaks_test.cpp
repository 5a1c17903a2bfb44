// How often each triangle test fails where tests fail: expectations are the ranges that are known of the
// methods. What is sound never fails; what is not fails about as often as it should, or the rays prove
// nothing.
#include <gtest/gtest.h>

#include "kernels/methods/rays_at_meshes.h"

namespace ctpbench {
namespace {

using test::Aim;
using test::leaks;

struct Range {
    double least, most;  // failures per million
};
constexpr Range kNever{0, 0};

void expect_within(double rate, Range range, const char* what) {
    EXPECT_GE(rate, range.least) << what;
    EXPECT_LE(rate, range.most) << what;
    testing::Test::RecordProperty(what, std::to_string(rate));
}

// Rays at needles, 10^4 times as long as they are wide, aimed at a third of their width.
template <class Test>
double missed_needles() {
    test::Random random(7);
    constexpr int kRays = 100000;
    int missed = 0;
    for (int i = 0; i < kRays; ++i) {
        const Vec3 a = random.point(-1, 1), along = random.direction();
        const Vec3 side = normalize(cross(along, random.direction()));
        const TriangleShape s = {a, a + along, a + 0.5f * along + 1e-4f * side};
        const Vec3 at =
            s.a + random.uniform(0.2f, 0.4f) * (s.b - s.a) + random.uniform(0.2f, 0.4f) * (s.c - s.a);
        const Vec3 origin = at + random.uniform(1, 3) * random.direction();
        const Ray ray = {origin, at - origin, test::kInfinity};
        Hit hit = no_hit(ray);
        Test::intersect(Test::shape(s), 0, Test::setup(ray), hit);
        missed += hit.primitive != 0;
    }
    return 1e6 * missed / kRays;
}

template <class Test>
void expect_rates(Range edges, Range vertices, Range far_away) {
    const Vec3 far = {3e6f, -3e6f, 1.5e6f};
    expect_within(leaks<Test>(Aim::edges), edges, "edges");
    expect_within(leaks<Test>(Aim::vertices), vertices, "vertices");
    expect_within(leaks<Test>(Aim::interiors), kNever, "interiors");
    expect_within(leaks<Test>(Aim::interiors, 1e-6f), kNever, "interiors_at_1e-6");
    // Where coordinates have few digits to differ in, all but Baldwin & Weber's sums of products are exact.
    expect_within(leaks<Test>(Aim::edges, 50.0f, far), far_away, "edges_3e6_away");
    expect_within(missed_needles<Test>(), {0, 2500}, "needles");
}

TEST(Leaks, OfWoopNeverHappen) {
    expect_rates<WatertightTriangle>(kNever, kNever, kNever);
    expect_within(leaks<WatertightTriangle>(Aim::edges, 1.0f, {1.5e5f, -1.5e5f, 7.5e4f}), kNever,
                  "far_edges");
    expect_within(leaks<WatertightTriangle>(Aim::vertices, 1.0f, {1.5e5f, -1.5e5f, 7.5e4f}), kNever,
                  "far_vertices");
}
TEST(Leaks, OfMoellerAndTrumboreAreManyAtEdgesAndVertices) {
    expect_rates<MoellerTrumbore>({40e3, 150e3}, {30e3, 120e3}, kNever);
}
TEST(Leaks, OfPlueckerAreFewAndAtVerticesAlone) { expect_rates<Pluecker>(kNever, {2e3, 10e3}, kNever); }
TEST(Leaks, OfBaldwinAndWeberAreManyAndTrianglesFarAwayAreLost) {
    expect_rates<BaldwinWeber>({25e3, 150e3}, {5e3, 100e3}, {5e3, 200e3});
}
// Where a ray meets a vertex exactly, the sign of what should be 0 is left to rounding in float64 too.
TEST(Leaks, OfMoellerAndTrumboreInFloat64AreNoneAtEdges) {
    expect_rates<MoellerTrumbore64>(kNever, {0, 3e3}, kNever);
}

}  // namespace
}  // namespace ctpbench
