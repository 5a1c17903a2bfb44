// The oracle over whole scenes must say what a test of every primitive says.
#include "oracle/exact_tracer.h"

#include <gtest/gtest.h>

#include <vector>

#include "accel/scene_primitives.h"
#include "support.h"
#include "wavefront/scene_view.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

struct Bed {
    Scene scene;
    SceneView view;
    Judge judge;
    Tree tree;
    ExactTracer exact;
    explicit Bed(Scene s)
        : scene(std::move(s)),
          view(scene),
          judge(view.geometry()),
          tree(build_sbvh(ScenePrimitives(scene), SbvhSettings::quality())),
          exact(judge, tree) {}
};

Scene with_material(Mesh mesh) {
    Scene scene;
    scene.materials.push_back({});
    scene.mesh = std::move(mesh);
    return scene;
}

void compare_with_all_primitives(const Scene& scene, float scale, Vec3 offset) {
    const Bed bed(scene);
    Random random(7);
    int decided = 0;
    for (int i = 0; i < 400; ++i) {
        Vec3 d = random.direction();
        if (i % 5 == 0) d[i % 3] = 0.0f;
        const Ray ray = {offset + scale * random.point(-2.0f, 2.0f), d, kInfinity};
        std::uint32_t nearest = kNoPrimitive;
        double t = kInfinity;
        bool doubt = false;
        for (std::uint32_t id = 0; id < bed.view.geometry().size(); ++id) {
            const ExactHit hit = bed.judge.exact(id, ray);
            if (hit.inside() && hit.t < t) t = hit.t, nearest = id;
            doubt |= !hit.inside() && !hit.outside();
        }
        const ExactClosest found = bed.exact.closest(ray);
        if (!found.decided && found.primitive != kNoPrimitive) {
            EXPECT_TRUE(doubt) << "ray " << i;
            EXPECT_LT(found.t, t);
            continue;
        }
        ASSERT_EQ(found.primitive, nearest) << "ray " << i << ", scale " << scale;
        EXPECT_EQ(found.t, t);
        decided += nearest != kNoPrimitive;
    }
    EXPECT_GT(decided, 50) << "or there was nothing to compare";
}

TEST(ExactTracer, FindsWhatATestOfEveryPrimitiveFinds) {
    for (const float scale : {1e-6f, 1.0f, 1e6f})
        compare_with_all_primitives(test::soup(600, 60, 5, scale), scale, {0, 0, 0});
    compare_with_all_primitives(test::soup(600, 60, 6, 10.0f, {1.5e5f, -1.5e5f, 1e4f}), 10.0f,
                                {1.5e5f, -1.5e5f, 1e4f});
}

TEST(ExactTracer, ARayAtAnEdgeOfAClosedMeshMustHit) {
    const Bed bed(with_material(test::star(2, 1.0f, {0, 0, 0}, 3)));
    Random random(8);
    int undecided = 0;
    for (int i = 0; i < 500; ++i) {
        const auto& t =
            bed.scene.mesh.triangles[static_cast<std::size_t>(i) % bed.scene.mesh.triangles.size()];
        const Vec3 a = bed.scene.mesh.positions[t[0]], b = bed.scene.mesh.positions[t[1]];
        const Vec3 target = i % 2 == 0 ? a : a + random.uniform(0, 1) * (b - a);
        const Vec3 origin = 0.3f * random.point(-1, 1);
        const ExactClosest found = bed.exact.closest(Ray{origin, target - origin, kInfinity});
        ASSERT_NE(found.primitive, kNoPrimitive) << "ray " << i;
        EXPECT_NEAR(found.t, 1.0, 1e-5);
        undecided += !found.decided;
    }
    EXPECT_GT(undecided, 400) << "or the rays were not at edges";
}

TEST(ExactTracer, APathHitsNeitherItsStartNorItsNeighboursButTheFarSideOfASphere) {
    const Bed bed(with_material(test::star(2, 1.0f, {0, 0, 0}, 3, 0.0f)));
    const TriangleShape t = bed.scene.mesh.triangle(5);
    const auto outward = [](double s) { return std::array<double, 3>{s, s, s}; };
    std::array<double, 3> on{};
    for (int a = 0; a < 3; ++a) on[static_cast<std::size_t>(a)] = (double{t.a[a]} + t.b[a] + t.c[a]) / 3.0;
    const double toward = on[0] + on[1] + on[2] > 0.0 ? 1.0 : -1.0;
    EXPECT_EQ(bed.exact.after_departure({on, outward(toward)}, 5).primitive, kNoPrimitive);
    const ExactClosest inward = bed.exact.after_departure({on, outward(-toward)}, 5);
    EXPECT_NE(inward.primitive, kNoPrimitive);
    EXPECT_NE(inward.primitive, 5u);

    Scene ball = with_material({});
    ball.spheres = {{{1e4f, 0, 0}, 1.0f}};
    const Bed sphere(std::move(ball));
    EXPECT_EQ(sphere.exact.after_departure({{1e4 - 1.0, 0, 0}, {-1, 0.1, 0}}, 0).primitive, kNoPrimitive);
    const ExactClosest far = sphere.exact.after_departure({{1e4 - 1.0, 0, 0}, {1, 0, 0}}, 0);
    EXPECT_EQ(far.primitive, 0u);
    EXPECT_NEAR(far.t, 2.0, 1e-9);
}

TEST(ExactTracer, AnEmptyTreeHasNoHits) {
    Scene scene = with_material({});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scene.mesh.positions = {{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.mesh.triangles = {{0, 1, 2}};
    scene.mesh.material = {0};
    const Bed bed(std::move(scene));
    EXPECT_EQ(bed.exact.reference({{0.2f, 0.2f, -1}, {0, 0, 1}, kInfinity}).primitive, kNoPrimitive);
}

}  // namespace
}  // namespace ctpbench
