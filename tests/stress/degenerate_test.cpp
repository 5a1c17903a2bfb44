// Scenes that have nothing to split must build and trace in bounded time and memory.
#include <gtest/gtest.h>

#include <limits>

#include "accel/scene_primitives.h"
#include "measure/exam.h"
#include "support.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/forest.h"
#include "wavefront/scene_view.h"

namespace ctpbench {
namespace {

// A million, a tenth of that under sanitizers. Time is bounded by the test's limit; what takes more than
// linear memory or depth shows in the tree.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::uint32_t kMany = 100'000;
#else
constexpr std::uint32_t kMany = 1'000'000;
#endif

void add(Scene& scene, Vec3 a, Vec3 b, Vec3 c) {
    const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
    for (const Vec3& p : {a, b, c}) scene.mesh.positions.push_back(p);
    scene.mesh.triangles.push_back({first, first + 1, first + 2});
    scene.mesh.material.push_back(0);
}

// Builds with both settings, checks the bounds, and judges the default methods on the rays.
Verdict build_and_trace(const Scene& scene, const std::vector<Ray>& rays) {
    CpuBackend backend(2);
    const SceneView view(scene);
    const Judge judge(view.geometry());
    Verdict verdict;
    for (const BuilderInfo& builder : tree_builders()) {
        const Forest forest = build_forest(backend, scene, {TreeKind::mixed}, builder.settings, nullptr,
                                           [](const std::string&, double) {});
        const Tree& tree = *forest.mixed;
        const std::size_t n = view.geometry().size();
        EXPECT_LE(tree.refs.size(), 2 * n);
        EXPECT_LE(tree.nodes.size(), 2 * tree.refs.size() + 1);
        EXPECT_LE(tree.depth, kMaxTreeDepth);
        const auto intersector = make_intersector("ctp", "watertight", forest.layout_input(view.geometry()));
        CpuTracer tracer(backend, *intersector, view.geometry().extent);
        Batch batch = stress_batch(backend, static_cast<std::uint32_t>(rays.size()),
                                   [&](std::uint32_t i) { return rays[i]; });
        const ExactTracer exact(judge, tree);
        RayExam exam(backend, judge, exact, batch, [] {});
        const Accuracy accuracy = exam.take(tracer);
        EXPECT_EQ(accuracy.failures(), 0u) << builder.name << ": " << accuracy.verdict.text();
        verdict += accuracy.verdict;
    }
    return verdict;
}

std::vector<Ray> rays_at(Vec3 target, int count, float distance) {
    test::Random random(3);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Vec3 origin = target + distance * random.direction();
        rays.push_back({origin, target - origin, test::kInfinity});
    }
    return rays;
}

Scene empty_scene() {
    Scene scene;
    scene.materials.push_back({});
    return scene;
}

TEST(Degenerate, AMillionCoincidentTriangles) {
    Scene scene = empty_scene();
    scene.mesh.positions = {{0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0.25f}};
    scene.mesh.triangles.assign(kMany, {0, 1, 2});
    scene.mesh.material.assign(kMany, 0);
    build_and_trace(scene, rays_at({0.25f, 0.25f, 0.1875f}, 8, 2.0f));
}

TEST(Degenerate, AMillionDuplicatesOfAMesh) {
    Scene scene = empty_scene();
    const Mesh star = test::star(1, 1.0f, {0, 0, 0}, 4);
    scene.mesh.positions = star.positions;
    for (std::uint32_t i = 0; i < kMany; ++i)
        scene.mesh.triangles.push_back(star.triangles[i % star.triangles.size()]);
    scene.mesh.material.assign(kMany, 0);
    build_and_trace(scene, rays_at(scene.mesh.positions[0] * 0.3f, 8, 0.2f));
}

TEST(Degenerate, TrianglesThatHalveSinkIntoNothing) {
    Scene scene = empty_scene();
    for (int i = 0; i < 126; ++i) {
        const float s = std::ldexp(1.0f, -i);
        add(scene, {s, 0, 0}, {s, 0.5f * s, 0}, {s, 0, 0.5f * s});
    }
    std::vector<Ray> rays;
    for (int i = 0; i < 30; ++i) {
        const float s = std::ldexp(1.0f, -i);
        rays.push_back({{2.0f, 0.125f * s, 0.125f * s}, {-1, 0, 0}, test::kInfinity});
    }
    const Verdict verdict = build_and_trace(scene, rays);
    EXPECT_EQ(verdict.match + verdict.boundary, verdict.rays);
    EXPECT_GT(verdict.match, verdict.rays / 2);
}

TEST(Degenerate, NothingButNans) {
    Scene scene = empty_scene();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 1000; ++i) add(scene, {nan, 0, 0}, {1, nan, 0}, {0, 1, nan});
    for (int i = 0; i < 1000; ++i) scene.spheres.push_back({{nan, 0, 0}, 1.0f});
    const Verdict verdict = build_and_trace(scene, rays_at({0, 0, 0}, 100, 2.0f));
    EXPECT_EQ(verdict.match, verdict.rays) << "there is nothing to hit";
}

}  // namespace
}  // namespace ctpbench
