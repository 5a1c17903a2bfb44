// Embree's tree of a large scene takes gigabytes: contenders that differ in the call alone must share it.
#include "measure/lineup.h"

#include <gtest/gtest.h>

#include "kernels/simd/isa.h"
#include "oracle/embree.h"
#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench {
namespace {

TEST(Lineup, SharesEmbreesTreesAmongItsCalls) {
    if (embree_version().empty()) GTEST_SKIP() << "built without Embree";
    const Scene scene = test::soup(500, 20, 3);
    test::Stage stage(scene, 2);
    const Workload workload{"soup", 20, 0.03, "quality"};
    Results results;
    std::vector<std::string> steps;
    Lineup lineup(workload, scene, stage.scenes, stage.backend, ScalarIsa::name, results,
                  [&](const std::string& s) { steps.push_back(s); });
    for (const EmbreeContender& e : embree_contenders())
        if (embree_obstacle(e.name).empty()) {
            const Intersector& made = lineup.get(e.name, own_way, own_way, own_way);
            EXPECT_EQ(&made, &lineup.get(e.name, own_way, own_way, own_way));
        }
    ASSERT_EQ(results.trees.size(), 2u);
    EXPECT_EQ(results.trees[0].kind, "embree_robust");
    EXPECT_EQ(results.trees[1].kind, "embree_default");
    EXPECT_EQ(steps.size(), 2u);
    for (const TreeResult& tree : results.trees) {
        EXPECT_EQ(tree.primitives, 520u);
        EXPECT_GT(tree.bytes, 0u);
        EXPECT_GT(tree.build_seconds, 0.0);
    }
    EXPECT_NE(&lineup.get("embree_16", own_way, own_way, own_way),
              &lineup.get("embree_default", own_way, own_way, own_way));
    EXPECT_EQ(lineup.get("embree_16", own_way, own_way, own_way).bytes(), results.trees[1].bytes);
}

}  // namespace
}  // namespace ctpbench
