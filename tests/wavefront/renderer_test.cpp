// The bounce loop: what holds of its paths whatever the materials.
#include "wavefront/renderer.h"

#include <gtest/gtest.h>

#include <set>

#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench {
namespace {

using test::looking_from;

// Inside a closed convex mesh no path ever ends; what leaves it has found a leak or crossed a wall. (In a
// sharp crease the offset of an origin can cross the other wall: that is the offset method's price.)
TEST(Renderer, NoPathLeavesAClosedMesh) {
    for (float offset : {0.0f, 300.0f}) {
        Scene scene;
        scene.mesh = test::star(3, 10.0f, {offset, offset, -offset}, 8, 0.0f);
        scene.materials.push_back({});
        test::Stage stage(scene, 2);
        const Camera camera = looking_from({offset, offset, -offset}, {offset, offset, -offset - 1});
        std::vector<std::size_t> active;
        const test::Frames frames =
            test::render(stage, camera, {128, 128, 10, 1}, 1, "ctp",
                         [&](const BounceView& view) { active.push_back(view.slots.size()); });
        EXPECT_EQ(active, std::vector<std::size_t>(11, 128 * 128));
        for (std::size_t i = 0; i < frames.image.size(); ++i)
            ASSERT_EQ(frames.image.at(i), (Vec3{0, 0, 0})) << "no light comes in";
    }
}

TEST(Renderer, GivesTheSameRaysWithAnyNumberOfThreads) {
    const Scene scene = test::soup(2000, 50, 4);
    std::vector<std::vector<std::uint64_t>> runs;
    for (int threads : {1, 2}) {
        test::Stage stage(scene, threads);
        auto& hashes = runs.emplace_back();
        test::render(stage, looking_from({0, 0, 3}, {0, 0, 0}), {97, 61, 4, 5}, 1, "ctp",
                     [&](const BounceView& view) {
                         Batch batch = record_batch(view.bounce, view.rays, view.slots, 0);
                         hashes.push_back(record_hits(batch, view.hits).hash());
                     });
        EXPECT_EQ(hashes.size(), 5u);
    }
    EXPECT_EQ(runs[0], runs[1]);
}

// Each pipeline has the stages of the paper's Figure 2, once per bounce, and each stage says what it handled.
TEST(Renderer, HasTheStagesOfItsPipeline) {
    const Scene scene = test::soup(2000, 50, 4);
    test::Stage stage(scene, 2);
    const Camera camera = looking_from({0, 0, 3}, {0, 0, 0});
    for (const auto& [shade, expected] : std::vector<std::pair<const char*, std::set<std::string>>>{
             {"ctp", {"generate", "intersect", "shade", "compact", "blend"}},
             {"sort", {"generate", "intersect", "sort", "shade", "compact", "blend"}},
             {"sort_restored", {"generate", "intersect", "sort", "shade", "compact", "blend"}},
             {"queues", {"generate", "intersect", "shade", "blend"}}}) {
        const test::Frames frames = test::render(stage, camera, {64, 64, 3, 5}, 1, shade);
        std::set<std::string> kernels;
        std::vector<std::uint32_t> intersected, shaded;
        for (const StageTime& s : frames.stages) {
            kernels.insert(s.kernel);
            EXPECT_GT(s.seconds, 0.0);
            if (std::string(s.kernel) == "intersect") intersected.push_back(s.rays);
            if (std::string(s.kernel) == "shade") shaded.push_back(s.rays);
        }
        EXPECT_EQ(kernels, expected) << shade;
        EXPECT_EQ(intersected.size(), 4u);
        EXPECT_EQ(intersected[0], 64u * 64u);
        EXPECT_EQ(intersected, shaded);
    }
}

// Samples that no pixel may hold are counted and do not reach the image.
TEST(Renderer, ClampsWhatIsNoLight) {
    Scene scene;
    scene.mesh.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    scene.mesh.triangles = {{0, 1, 2}}, scene.mesh.material = {0};
    scene.materials.push_back({});
    for (const float bad : {-1.0f, std::numeric_limits<float>::quiet_NaN(), test::kInfinity}) {
        scene.ambient = {bad, 1, 1};
        test::Stage stage(scene, 2);
        const test::Frames frames =
            test::render(stage, looking_from({0, 0, 3}, {0, 0, 9}), {16, 16, 1, 1}, 2);
        EXPECT_EQ(frames.stages.back().clamped, 256u);
        for (std::size_t i = 0; i < frames.image.size(); ++i) ASSERT_EQ(frames.image.at(i), (Vec3{0, 0, 0}));
    }
}

TEST(Renderer, AveragesItsSamples) {
    const Scene scene = test::soup(500, 10, 4);
    test::Stage stage(scene, 2);
    const Camera camera = looking_from({0, 0, 3}, {0, 0, 0});
    const FrameSettings settings{32, 32, 3, 5};
    const auto shader = make_shader("ctp", stage.materials);
    Renderer renderer(stage.backend, stage.view, camera, settings);
    ImageStorage mean, single;
    std::vector<double> sum(32 * 32, 0.0);
    for (std::uint32_t s = 0; s < 8; ++s) {
        renderer.frame(*stage.intersector, *shader, true, s, mean, {});
        // A mean of one sample is that sample, whichever number it has: start afresh at sample s by hand.
        ImageStorage before;
        before.resize(32 * 32);
        renderer.frame(*stage.intersector, *shader, true, s, before, {});
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += before.at(i).x * (s + 1.0);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) ASSERT_NEAR(mean.at(i).x, sum[i] / 8, 1e-5);
}

}  // namespace
}  // namespace ctpbench
