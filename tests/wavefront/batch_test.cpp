#include "wavefront/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ctpbench {
namespace {

TEST(Batch, TakesRunsAtEvenDistances) {
    constexpr std::uint32_t n = 100000;
    RayStorage rays;
    rays.resize(n);
    std::vector<std::uint32_t> slots(n);
    std::iota(slots.begin(), slots.end(), 0u);
    for (std::uint32_t i = 0; i < n; ++i)
        rays.view().store(i, {{static_cast<float>(i), 0, 0}, {0, 0, 1}, 1.0f});
    for (std::uint32_t limit : {0u, 1u, 1024u, 5000u, 99999u, 200000u}) {
        Batch batch = record_batch(3, rays.view(), slots, limit);
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

}  // namespace
}  // namespace ctpbench
