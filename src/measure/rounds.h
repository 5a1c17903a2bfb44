// The order in which a round visits its contenders.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ctpbench {

// Every contender once. Each second round runs backwards (ABBA), so that a steady drift of the machine's
// speed favours nobody, and each pair of rounds starts with another contender, so that nobody always
// follows the same neighbour's caches.
inline std::vector<std::size_t> round_order(std::size_t contenders, std::size_t round) {
    std::vector<std::size_t> order(contenders);
    for (std::size_t i = 0; i < contenders; ++i) order[i] = (i + round / 2) % contenders;
    if (round % 2 == 1) std::reverse(order.begin(), order.end());
    return order;
}

}  // namespace ctpbench
