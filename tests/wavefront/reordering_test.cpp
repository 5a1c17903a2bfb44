// Sorting and compacting the index buffer: stable, complete, and the same for any number of threads.
#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"
#include "wavefront/columns.h"
#include "wavefront/compaction.h"
#include "wavefront/sorting.h"

namespace ctpbench {
namespace {

constexpr std::uint32_t kCounts[] = {0, 1, 15, 16, 17, 1023, 1025, 8191, 8192, 8193, 50000};

struct Paths {
    explicit Paths(std::uint32_t count, int kinds) : index(count), bytes(count) {
        test::Random random(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            index[i] = count - i;
            bytes[i] = static_cast<std::uint8_t>(random.uniform(0, static_cast<float>(kinds)));
        }
    }
    std::vector<std::uint32_t> index;
    std::vector<std::uint8_t> bytes;
};

TEST(Compaction, KeepsInOrderWhatGoesOn) {
    for (const int threads : {1, 2})
        for (const std::uint32_t count : kCounts) {
            const Paths paths(count, 3);  // all three fates
            std::vector<std::uint32_t> expected, compacted(count);
            for (std::uint32_t i = 0; i < count; ++i)
                if (paths.bytes[i] == static_cast<std::uint8_t>(PathFate::goes_on))
                    expected.push_back(paths.index[i]);
            CpuBackend backend(threads);
            Compaction compaction;
            compacted.resize(
                compaction.run(backend, paths.bytes.data(), paths.index.data(), count, compacted.data()));
            EXPECT_EQ(compacted, expected) << count;
        }
}

// By way of runs, by counters, and with as many keys as there may be.
class ShadeKeys : public testing::TestWithParam<std::uint32_t> {};

TEST_P(ShadeKeys, IsAStableSortByKey) {
    const std::uint32_t keys = GetParam();
    for (const int threads : {1, 2})
        for (const std::uint32_t count : kCounts) {
            const Paths paths(count, static_cast<int>(keys));
            std::vector<std::uint32_t> expected, sorted(count), begins;
            for (std::uint32_t key = 0; key < keys; ++key) {
                begins.push_back(static_cast<std::uint32_t>(expected.size()));
                for (std::uint32_t i = 0; i < count; ++i)
                    if (paths.bytes[i] == key) expected.push_back(paths.index[i]);
            }
            begins.push_back(count);
            CpuBackend backend(threads);
            Sorting sorting;
            std::vector<std::uint32_t> offsets(keys + 1);
            sorting.run(backend, paths.bytes.data(), keys, paths.index.data(), count, sorted.data(),
                        offsets.data());
            EXPECT_EQ(sorted, expected) << count;
            EXPECT_EQ(offsets, begins) << count;
        }
}
INSTANTIATE_TEST_SUITE_P(Few, ShadeKeys, testing::Values(2, 3, 4, 5, 8));
INSTANTIATE_TEST_SUITE_P(Many, ShadeKeys, testing::Values(9, 17, kMaxShadeKeys));

// One key alone, so that one run takes all and the others stay empty.
TEST(Sorting, OfOneKeyChangesNothing) {
    for (std::uint32_t key = 0; key < 5; ++key) {
        Paths paths(20000, 1);
        std::fill(paths.bytes.begin(), paths.bytes.end(), static_cast<std::uint8_t>(key));
        std::vector<std::uint32_t> sorted(paths.index.size());
        CpuBackend backend(2);
        Sorting sorting;
        std::uint32_t offsets[6];
        sorting.run(backend, paths.bytes.data(), 5, paths.index.data(), 20000, sorted.data(), offsets);
        EXPECT_EQ(sorted, paths.index);
        EXPECT_EQ(offsets[key], 0u);
        EXPECT_EQ(offsets[key + 1], 20000u);
    }
}

}  // namespace
}  // namespace ctpbench
