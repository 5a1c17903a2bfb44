#include "wavefront/interleaved/arena.h"

#include <algorithm>
#include <numeric>

namespace ctpbench {

void set_order(const WideTree::Node& from, WideNode& to) {
    std::fill(std::begin(to.order), std::end(to.order), 0u);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
        std::array<float, kWide> distance{};
        for (std::uint32_t i = 0; i < from.child_count; ++i) {
            const Box& box = from.children[i].box;
            for (int a = 0; a < 3; ++a)
                distance[i] += octant >> a & 1u ? -(box.lo[a] + box.hi[a]) : box.lo[a] + box.hi[a];
        }
        std::array<std::uint32_t, kWide> order;
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.begin() + from.child_count,
                         [&](std::uint32_t l, std::uint32_t r) { return distance[l] > distance[r]; });
        for (std::uint32_t i = 0; i < kWide; ++i) to.order[i] |= order[i] << 3 * octant;
    }
}

}  // namespace ctpbench
