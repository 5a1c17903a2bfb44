#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "tests/accel/check_tree.h"
#include "tests/accel/soups.h"

namespace ctpbench::test {
namespace {

Tree build_with_threads(const Scene& scene, const SbvhSettings& settings, int threads) {
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(threads);
    Tree tree;
    arena.execute([&] { tree = build_sbvh(ScenePrimitives(scene), settings); });
    return tree;
}

// Large enough for several chunks and many tasks, with a budget that runs out.
TEST(SbvhDeterminism, SameTreeForAnyNumberOfThreads) {
    Scene scene = needles(18000, {0, 0, 0}, 1, 1);
    add_spheres(scene, 2000, {0, 0, 0}, 1, 0.02f, 2);
    for (const float budget : {1.2f, 2.0f}) {
        for (SbvhSettings settings : {SbvhSettings::quality(), SbvhSettings::paper()}) {
            settings.reference_budget = budget;
            const Tree one = build_with_threads(scene, settings, 1);
            EXPECT_GT(one.refs.size(), 22000u);
            for (const int threads : {2, 3}) {
                const Tree more = build_with_threads(scene, settings, threads);
                EXPECT_EQ(hash(one), hash(more));
                EXPECT_EQ(one.sah, more.sah);
                EXPECT_EQ(one.depth, more.depth);
            }
        }
    }
}

}  // namespace
}  // namespace ctpbench::test
