#include "backends/thread_pools.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

TEST(ThreadPools, HaveAsManyThreadsAsAskedFor) {
    CpuBackend own(2);
    ThreadPools pools(own);
    EXPECT_EQ(&pools.get(0), &own);
    EXPECT_EQ(pools.get(1).threads(), 1);
    EXPECT_EQ(pools.get(3).threads(), 3);
    EXPECT_EQ(&pools.get(3), &pools.get(3));
    EXPECT_NE(&pools.get(2), &own) << "the run's own is not one of them, whatever it has";
    EXPECT_GE(ThreadPools::allowed(), 1);
}

}  // namespace
}  // namespace ctpbench
