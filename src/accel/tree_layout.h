// Brings a tree into its final order: pairs of siblings depth first, the child that a ray is more likely
// to enter right after its parent, and leaf entries in the order of the leaves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "accel/tree.h"

namespace ctpbench {

// What a subtree holds.
struct SubtreeSize {
    std::uint32_t inner, entries;
};

// A tree as it was built: nodes wherever the builder put them, in pairs, the root at 0.
struct RawTree {
    std::span<const BvhNode> nodes;
    std::span<const SubtreeSize> first_child;     // size of the subtree of node 2 i, where a pair is there
    std::span<const std::uint32_t> leaf_entries;  // primitive numbers, which the leaves index
    SubtreeSize size;
};

struct OrderedTree {
    NodeArray nodes;
    std::vector<std::uint32_t> entries;  // primitive numbers in leaf order
    std::uint32_t depth;
};

OrderedTree order_depth_first(const RawTree& raw);

}  // namespace ctpbench
