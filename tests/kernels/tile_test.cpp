// The block programs by which a GPU sorts and compacts, run on the host: stable, complete, with the right
// offsets.
#include "kernels/tile_wide.h"

#include <gtest/gtest.h>

#include "backends/host_blocks.h"
#include "support.h"

namespace ctpbench {
namespace {

constexpr std::uint32_t kCounts[] = {0, 1, 7, 8, 9, 2047, 2048, 2049, 4096, 50000};

struct Reordered {
    std::vector<std::uint32_t> moved, offsets;
};

template <class By>
Reordered reorder(const std::vector<std::uint8_t>& bytes, const std::vector<std::uint32_t>& index) {
    const auto n = static_cast<std::uint32_t>(bytes.size());
    std::vector<std::uint32_t> places(By::keys * (tile_count(n) + 1));
    Reordered out{std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(By::keys + 1)};
    const TileInput<By> in{bytes.data(), &n, places.data()};
    const std::uint32_t blocks = tile_count(n) + 3;  // more than there is work for
    run_blocks_on_host(blocks, TileCount<By>{in});
    run_blocks_on_host(1, TileScan{&n, places.data(), By::keys, out.offsets.data()});
    run_blocks_on_host(blocks, TileMove<By>{in, index.data(), out.moved.data()});
    return out;
}

template <class By>
void expect_right(int kinds) {
    for (const std::uint32_t count : kCounts) {
        std::vector<std::uint8_t> bytes(count);
        std::vector<std::uint32_t> index(count), expected, begins;
        test::Random random(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            index[i] = count - i;
            bytes[i] = static_cast<std::uint8_t>(random.uniform(0, static_cast<float>(kinds)));
        }
        std::uint32_t total = 0;
        for (std::uint32_t key = 0; key < By::keys; ++key) {
            begins.push_back(total);
            for (std::uint32_t i = 0; i < count; ++i) {
                if (By::key(bytes[i]) != key) continue;
                ++total;
                if (key < By::written) expected.push_back(index[i]);
            }
        }
        begins.push_back(count);
        Reordered out = reorder<By>(bytes, index);
        EXPECT_EQ(out.offsets, begins) << count;
        out.moved.resize(expected.size());
        EXPECT_EQ(out.moved, expected) << count;
    }
}

TEST(Tiles, SortStablyByKey) {
    expect_right<ByShadeKey<2>>(2);
    expect_right<ByShadeKey<5>>(5);
}

TEST(Tiles, CompactInOrder) { expect_right<ByFate>(3); }

// One key alone fills the 12 bits that a tile's count has.
TEST(Tiles, OfOneKeyKeepTheirOrder) {
    for (std::uint32_t key = 0; key < 5; ++key) {
        std::vector<std::uint32_t> index(5000);
        for (std::uint32_t i = 0; i < 5000; ++i) index[i] = 3 * i;
        const Reordered out =
            reorder<ByShadeKey<5>>(std::vector<std::uint8_t>(5000, static_cast<std::uint8_t>(key)), index);
        EXPECT_EQ(out.moved, index);
        EXPECT_EQ(out.offsets[key], 0u);
        EXPECT_EQ(out.offsets[key + 1], 5000u);
    }
}

Reordered reorder_wide(const std::vector<std::uint8_t>& bytes, const std::vector<std::uint32_t>& index,
                       std::uint32_t keys) {
    const auto n = static_cast<std::uint32_t>(bytes.size());
    std::vector<std::uint32_t> places(keys * (tile_count(n) + 1));
    Reordered out{std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(keys + 1)};
    const WideTileInput in{bytes.data(), &n, places.data(), keys};
    const std::uint32_t blocks = tile_count(n) + 3;
    run_blocks_on_host(blocks, WideTileCount{in});
    run_blocks_on_host(1, TileScan{&n, places.data(), keys, out.offsets.data()});
    run_blocks_on_host(blocks, WideTileMove{in, index.data(), out.moved.data()});
    return out;
}

TEST(WideTiles, SortStablyByKey) {
    for (const std::uint32_t keys : {6u, 17u, kMaxShadeKeys})
        for (const std::uint32_t count : kCounts) {
            std::vector<std::uint8_t> bytes(count);
            std::vector<std::uint32_t> index(count), expected, begins;
            test::Random random(count + keys);
            for (std::uint32_t i = 0; i < count; ++i) {
                index[i] = 7 * i;
                // Some keys are rare, one is common.
                const float u = random.uniform(0, 1);
                bytes[i] = static_cast<std::uint8_t>(u * u * static_cast<float>(keys));
            }
            for (std::uint32_t key = 0; key < keys; ++key) {
                begins.push_back(static_cast<std::uint32_t>(expected.size()));
                for (std::uint32_t i = 0; i < count; ++i)
                    if (bytes[i] == key) expected.push_back(index[i]);
            }
            begins.push_back(count);
            const Reordered out = reorder_wide(bytes, index, keys);
            EXPECT_EQ(out.offsets, begins) << count << " entries, " << keys << " keys";
            EXPECT_EQ(out.moved, expected) << count << " entries, " << keys << " keys";
        }
}

TEST(WideTiles, OfOneKeyKeepTheirOrder) {
    std::vector<std::uint32_t> index(5000);
    for (std::uint32_t i = 0; i < 5000; ++i) index[i] = 3 * i;
    for (const std::uint32_t key : {0u, 40u, kMaxShadeKeys - 1})
        EXPECT_EQ(reorder_wide(std::vector<std::uint8_t>(5000, static_cast<std::uint8_t>(key)), index,
                               kMaxShadeKeys)
                      .moved,
                  index);
}

}  // namespace
}  // namespace ctpbench
