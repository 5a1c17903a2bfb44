#include "wavefront/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/hash.h"
#include "support.h"
#include "wavefront/batch.h"
#include "wavefront/compaction.h"
#include "wavefront/forest.h"

namespace ctpbench {
namespace {

std::unique_ptr<Intersector> intersector_of(CpuBackend& backend, const Scene& scene, const SceneView& view,
                                            Forest& forest) {
    forest = build_forest(backend, scene, {TreeKind::mixed}, SbvhSettings::quality(), nullptr,
                          [](const std::string&, double) {});
    return make_intersector("ctp", "watertight", forest.layout_input(view.geometry()));
}

TEST(Compaction, KeepsTheLivingInOrder) {
    CpuBackend backend(2);
    for (std::uint32_t count : {0u, 1u, 4095u, 4096u, 4097u, 50000u}) {
        HitStorage hits;
        hits.resize(count + 1);
        std::vector<std::uint32_t> index(count), compacted(count), expected;
        for (std::uint32_t i = 0; i < count; ++i) index[i] = count - i;
        test::Random random(count);
        for (std::uint32_t i = 0; i <= count; ++i)
            hits.view().primitive[i] = random.uniform(0, 1) < 0.3f ? kNoPrimitive : i;
        for (std::uint32_t i : index)
            if (hits.view().primitive[i] != kNoPrimitive) expected.push_back(i);
        Compaction compaction;
        compacted.resize(compaction.run(backend, hits.view(), index.data(), count, compacted.data()));
        EXPECT_EQ(compacted, expected) << count;
    }
}

TEST(Batch, TakesRunsAtEvenDistances) {
    constexpr std::uint32_t n = 100000;
    RayStorage rays;
    rays.resize(n);
    std::vector<std::uint32_t> index(n);
    std::iota(index.begin(), index.end(), 0u);
    for (std::uint32_t i = 0; i < n; ++i)
        rays.view().store(i, {{static_cast<float>(i), 0, 0}, {0, 0, 1}, 1.0f});
    for (std::uint32_t limit : {0u, 1u, 1024u, 5000u, 99999u, 200000u}) {
        Batch batch = record_batch(3, rays.view(), index.data(), n, limit);
        ASSERT_EQ(batch.rays.size(), limit == 0 ? n : std::min(n, limit));
        EXPECT_EQ(batch.active, n);
        EXPECT_EQ(batch.bounce, 3u);
        for (std::uint32_t i = 1; i < batch.rays.size(); ++i) {
            const float step = batch.rays.view().ox[i] - batch.rays.view().ox[i - 1];
            ASSERT_GE(step, 1.0f);
            if (i % 1024 != 0) {
                ASSERT_EQ(step, 1.0f);
            }
        }
    }
}

// Inside a closed convex mesh no path ever ends; what leaves it has found a leak or crossed a wall. (In a
// sharp crease the offset of an origin can cross the other wall: that is the offset method's price.)
TEST(TracePaths, NoPathLeavesAClosedMesh) {
    for (float offset : {0.0f, 300.0f}) {
        Scene scene;
        scene.mesh = test::star(3, 10.0f, {offset, offset, -offset}, 8, 0.0f);
        scene.materials.push_back({});
        const SceneView view(scene);
        CpuBackend backend(2);
        Forest forest;
        const auto intersector = intersector_of(backend, scene, view, forest);
        Camera camera;
        camera.eye = {offset, offset, -offset};
        camera.target = {offset, offset, -offset - 1};
        std::vector<std::uint32_t> active;
        trace_paths(
            backend, view, camera, *intersector, {128, 128, 10, 1},
            [&](std::uint32_t, RayColumns, const std::uint32_t*, std::uint32_t n) { active.push_back(n); });
        EXPECT_EQ(active, std::vector<std::uint32_t>(11, 128 * 128));
    }
}

TEST(TracePaths, GivesTheSameRaysWithAnyNumberOfThreads) {
    const Scene scene = test::soup(2000, 50, 4);
    const SceneView view(scene);
    Camera camera;
    camera.eye = {0, 0, 3};
    std::vector<std::vector<std::uint64_t>> runs;
    for (int threads : {1, 2}) {
        CpuBackend backend(threads);
        Forest forest;
        const auto intersector = intersector_of(backend, scene, view, forest);
        auto& hashes = runs.emplace_back();
        trace_paths(backend, view, camera, *intersector, {97, 61, 4, 5},
                    [&](std::uint32_t bounce, RayColumns rays, const std::uint32_t* index, std::uint32_t n) {
                        Batch batch = record_batch(bounce, rays, index, n, 0);
                        const float* columns[] = {batch.rays.view().ox, batch.rays.view().oy,
                                                  batch.rays.view().oz, batch.rays.view().dx,
                                                  batch.rays.view().dy, batch.rays.view().dz};
                        std::uint64_t hash = n;
                        for (const float* c : columns) hash = hash_bytes(c, n * sizeof(float), hash);
                        hashes.push_back(hash);
                    });
        EXPECT_EQ(hashes.size(), 5u);
    }
    EXPECT_EQ(runs[0], runs[1]);
}

}  // namespace
}  // namespace ctpbench
