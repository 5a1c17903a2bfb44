// The judge must find each kind of fault, and only those.
#include "oracle/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oracle/exact.h"
#include "support.h"
#include "wavefront/scene_view.h"

namespace ctpbench {
namespace {

using test::kInfinity;

// Two triangles that share the edge x = 0 in the plane z = 0, a third behind them at z = 1, and a sphere.
struct Fixture {
    Scene scene;
    Fixture() {
        scene.materials.push_back({});
        scene.mesh.positions = {{0, -1, 0},  {0, 1, 0},  {-1, 0, 0}, {1, 0, 0},
                                {-9, -9, 1}, {9, -9, 1}, {0, 9, 1}};
        scene.mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}};
        scene.mesh.material = {0, 0, 0};
        scene.spheres = {{{0, 0, 5}, 1}};
    }
    Verdict verdict(Vec3 origin, Hit ours, Hit theirs) const {
        const SceneView view(scene);
        Verdict v;
        Judge(view.geometry()).ray({origin, {0, 0, 1}, kInfinity}, ours, theirs, v);
        EXPECT_EQ(v.rays, 1u);
        return v;
    }
};

const Hit kMiss = {kInfinity, kNoPrimitive, 0, 0};
Hit hit(std::uint32_t id, float t) { return {t, id, 0, 0}; }

TEST(Judge, AcceptsAgreement) {
    const Fixture f;
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(1, 2.0f), hit(1, 2.0f)).match, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, 2}, hit(3, 2.0460606f), hit(3, 2.046061f)).match, 1u) << "a sphere";
    EXPECT_EQ(f.verdict({99, 0, -2}, kMiss, kMiss).match, 1u);
}

TEST(Judge, FindsAWrongDistance) {
    const Fixture f;
    const Verdict v = f.verdict({0.3f, 0, -2}, hit(1, 2.001f), hit(1, 2.0f));
    EXPECT_EQ(v.t_mismatch, 1u);
    EXPECT_FALSE(v.accepted(true));
    EXPECT_FALSE(v.accepted(false));
}

TEST(Judge, FindsAHitThatIsNotThere) {
    const Fixture f;
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(0, 2.0f), hit(1, 2.0f)).false_hit, 1u);
    EXPECT_EQ(f.verdict({99, 0, -2}, hit(1, 2.0f), kMiss).false_hit, 1u);
}

TEST(Judge, FindsWhatWasMissed) {
    const Fixture f;
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, kMiss, hit(1, 2.0f)).missed, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(2, 3.0f), hit(1, 2.0f)).wrong_primitive, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, 2}, kMiss, hit(3, 2.0460606f)).missed, 1u);
}

TEST(Judge, FindsALeakBetweenNeighbours) {
    const Fixture f;
    const Verdict v = f.verdict({0, 0.1f, -2}, hit(2, 3.0f), hit(1, 2.0f));
    EXPECT_EQ(v.leak, 1u);
    EXPECT_FALSE(v.accepted(true));
    EXPECT_TRUE(v.accepted(false)) << "methods that are known to leak are reported, not rejected";
    EXPECT_GT(v.mismatch_rate(), 0.0);
}

TEST(Judge, LeavesTheRimOfAnOpenMeshUndecided) {
    const Fixture f;
    // The edge from (1, 0) to (0, 1) belongs to one triangle only.
    EXPECT_EQ(f.verdict({0.5f, 0.5f, -2}, hit(2, 3.0f), hit(1, 2.0f)).boundary, 1u);
    EXPECT_EQ(f.verdict({0.5f, 0.5f, -2}, hit(1, 2.0f), hit(2, 3.0f)).boundary, 1u);
}

TEST(Judge, AllowsTies) {
    const Fixture f;
    const Verdict v = f.verdict({0, 0.1f, -2}, hit(0, 2.0f), hit(1, 2.0f));
    EXPECT_EQ(v.tie, 1u);
    EXPECT_TRUE(v.accepted(true));
    EXPECT_EQ(v.mismatch_rate(), 0.0);
}

TEST(Judge, IsNotMisledByAWrongReference) {
    const Fixture f;
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(1, 2.0f), hit(2, 3.0f)).reference_wrong, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(1, 2.0f), kMiss).reference_wrong, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(1, 2.0f), hit(0, 1.0f)).reference_wrong, 1u);
}

TEST(Judge, CountsHitsThatAreNotFinite) {
    const Fixture f;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(1, nan), hit(1, 2.0f)).not_finite, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, -2}, hit(1, kInfinity), hit(1, 2.0f)).not_finite, 1u);
    const Verdict v = f.verdict({0.3f, 0, -2}, {2.0f, 1, nan, 0}, hit(1, 2.0f));
    EXPECT_EQ(v.not_finite, 1u);
    EXPECT_FALSE(v.accepted(false));
}

TEST(Judge, LeavesTheStartOfARayUndecided) {
    const Fixture f;
    // From the plane of the first two triangles: they may be hit at 0, or not.
    EXPECT_EQ(f.verdict({0.3f, 0, 0}, hit(1, 1e-7f), hit(2, 1.0f)).boundary, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, 0}, hit(2, 1.0f), hit(1, 1e-7f)).boundary, 1u);
    EXPECT_EQ(f.verdict({0.3f, 0, 0}, hit(1, 1e-4f), hit(2, 1.0f)).t_mismatch, 1u) << "but not after it";
    // From the sphere's near side inwards: 0 and the far side are both right, what is between is not.
    EXPECT_EQ(f.verdict({0, 0, 4}, hit(3, 2.0f), hit(3, 2.0f)).match, 1u);
    EXPECT_EQ(f.verdict({0, 0, 4}, hit(3, 1e-7f), hit(3, 2.0f)).match, 1u);
    EXPECT_EQ(f.verdict({0, 0, 4}, hit(3, 1.0f), hit(3, 2.0f)).t_mismatch, 1u);
    EXPECT_EQ(f.verdict({0, 0, 4}, kMiss, hit(3, 2.0f)).missed, 1u);
}

TEST(Judge, ReturnsTheScaledErrorOfT) {
    const Fixture f;
    const SceneView view(f.scene);
    const Judge judge(view.geometry());
    const Ray ray = {{0.3f, 0, -2}, {0, 0, 1}, kInfinity};
    Verdict v;
    EXPECT_EQ(judge.ray(ray, hit(1, 2.0f), hit(1, 2.0f), v), 0.0);
    // M = 2, kappa = 2^2 / (2 x 1): an ulp of t, 2^-22, is e = 2^-22 / (2^-24 x 2 x 2) = 1.
    EXPECT_DOUBLE_EQ(judge.ray(ray, hit(1, std::nextafter(2.0f, 3.0f)), hit(1, 2.0f), v), 1.0);
    EXPECT_TRUE(std::isnan(judge.ray(ray, kMiss, hit(1, 2.0f), v)));
    EXPECT_TRUE(std::isnan(judge.ray(ray, hit(0, 2.0f), hit(1, 2.0f), v)))
        << "a false hit has no t to speak of";
}

TEST(ExactHit, NearACornerTheCornerIsNearest) {
    // Needle of 1e-3 at its tip: 1e-3 beyond it along its axis the lines of the edges are 1e-6 away.
    const TriangleShape needle = {{0, 0, 1}, {1, 5e-4f, 1}, {1, -5e-4f, 1}};
    EXPECT_NEAR(exact_hit(needle, Ray{{-1e-3f, 0, 0}, {0, 0, 1}, kInfinity}).margin, -1e-3, 1e-9);
}

TEST(ExactHit, MeasuresTheDistanceToTheOutline) {
    const TriangleShape t = {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
    EXPECT_NEAR(exact_hit(t, Ray{{1, 0.5f, 0}, {0, 0, 2}, kInfinity}).margin, 0.5, 1e-12);
    EXPECT_NEAR(exact_hit(t, Ray{{1, -0.5f, 0}, {0, 0, 2}, kInfinity}).margin, -0.5, 1e-12);
    EXPECT_NEAR(exact_hit(t, Ray{{1, 0.5f, 0}, {0, 0, 2}, kInfinity}).t, 1.0, 1e-15);
    EXPECT_TRUE(exact_hit(t, Ray{{1, 0.5f, 0}, {0, 0, -2}, kInfinity}).outside()) << "behind the origin";
    const SphereShape s = {{0, 0, 3}, 1};
    EXPECT_NEAR(exact_hit(s, Ray{{0, 0.25f, 0}, {0, 0, 1}, kInfinity}).margin, 0.75, 1e-12);
    EXPECT_NEAR(exact_hit(s, Ray{{0, 0, 3}, {0, 0, 1}, kInfinity}).t, 1.0, 1e-12) << "from inside";
}

}  // namespace
}  // namespace ctpbench
