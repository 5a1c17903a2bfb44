#include "base/memory.h"

#include "tests/scene/files.h"

namespace ctpbench {
namespace {

using Memory = SceneFiles;

TEST_F(Memory, LeftIsTheLeastOfTheMachinesAndEachGroups) {
    write("proc/meminfo", "MemTotal:  9000 kB\nMemAvailable:   4000 kB\nSwapFree: 7 kB\n");
    EXPECT_EQ(available_memory_bytes(folder), 4000u * 1024);
    write("proc/self/cgroup", "1:name=systemd:/x\n0::/job/step\n");
    write("sys/fs/cgroup/job/step/memory.max", "max\n");
    write("sys/fs/cgroup/job/step/memory.current", "5\n");
    EXPECT_EQ(available_memory_bytes(folder), 4000u * 1024);
    write("sys/fs/cgroup/job/memory.max", "3000\n");
    write("sys/fs/cgroup/job/memory.current", "1000\n");
    EXPECT_EQ(available_memory_bytes(folder), 2000u);
    write("sys/fs/cgroup/memory.max", "100\n");
    write("sys/fs/cgroup/memory.current", "300\n");  // a limit may be lowered below what is used
    EXPECT_EQ(available_memory_bytes(folder), 0u);
}

TEST_F(Memory, WithoutAWordOfTheSystemThereIsNoLimit) {
    EXPECT_GT(available_memory_bytes(folder), 1ull << 60);
}

TEST_F(Memory, WhatDoesNotFitIsRefusedWithBothNumbers) {
    require_memory(1.0, "a thing", "take a smaller one");
    EXPECT_ERROR(require_memory(1e18, "a thing", "take a smaller one"), ExitCode::usage,
                 "a thing: error: needs about 1000000000000000000 bytes, but only ");
    EXPECT_GT(available_memory_bytes(), 1u << 20);
    EXPECT_LT(available_memory_bytes(), std::uint64_t{1} << 48);
}

}  // namespace
}  // namespace ctpbench
