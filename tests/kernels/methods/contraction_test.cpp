// Why contraction is off for the whole project: with it the same code, on the same rays, hits triangles that
// a ray runs parallel to and loses more rays at vertices. Woop's test is immune: it writes its fused
// multiply-adds out, and leaves none to the compiler.
#include <gtest/gtest.h>

#include "kernels/methods/contraction.h"

namespace ctpbench_contracted {
void count_contracted(int (&counts)[3]);
}  // namespace ctpbench_contracted

namespace ctpbench {
namespace {

TEST(Contraction, MakesHitsWhereThereAreNone) {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
#endif
    const ContractionCounts off = count_contraction();
    int counts[3];
    ctpbench_contracted::count_contracted(counts);
    const ContractionCounts on = {counts[0], {counts[1], counts[2]}};
    RecordProperty("parallel_hit", std::to_string(off.parallel_hit) + " " + std::to_string(on.parallel_hit));
    RecordProperty("vertex_missed",
                   std::to_string(off.vertex_missed[0]) + " " + std::to_string(on.vertex_missed[0]));
    EXPECT_EQ(off.parallel_hit, 0);
    EXPECT_GT(on.parallel_hit, kContractionRays / 1000);
    EXPECT_GT(on.vertex_missed[0], 2 * off.vertex_missed[0]);
    EXPECT_GT(on.vertex_missed[0], kContractionRays / 1000);

    EXPECT_EQ(off.vertex_missed[1], 0);
    EXPECT_EQ(on.vertex_missed[1], 0);
}

}  // namespace
}  // namespace ctpbench
