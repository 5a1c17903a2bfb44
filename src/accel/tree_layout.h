// Puts the parts of a tree together in its final order: pairs of siblings depth first, the child that a ray
// is more likely to enter right after its parent, and leaf entries in the order of the leaves.
#pragma once

#include <cstdint>
#include <memory>

#include "accel/tree.h"

namespace ctpbench {

// What a subtree holds. Nodes below its root come in pairs, one for each inner node.
struct SubtreeSize {
    std::uint32_t inner = 0, entries = 0, depth = 1;
};

// A subtree: its root, and either two more parts or everything below it in the final order. Nodes there
// index `nodes`, and leaves index `entries`.
struct TreePart {
    BvhNode root;
    SubtreeSize size;
    std::unique_ptr<TreePart> left, right;
    const BvhNode* nodes = nullptr;
    const PrimitiveRef* entries = nullptr;
};

// Whether what is below the left one of two siblings comes first.
inline bool left_first(const BvhNode& left, const BvhNode& right) {
    return !(left.box().half_area() < right.box().half_area());
}

// Sets nodes, references and depth.
void assemble(const TreePart& root, Tree& tree);

}  // namespace ctpbench
