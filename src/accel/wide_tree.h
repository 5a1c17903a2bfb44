// The binary tree collapsed to nodes of eight children, by dynamic programming over the surface area
// heuristic: Wald, Benthin & Boulos 2008 for the collapse; Ylitie, Karras & Laine, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, Sec. 3.1, for the program. Subtrees of few
// entries become leaves, whose entries are tested in blocks of one type.
#pragma once

#include <array>
#include <vector>

#include "kernels/box.h"
#include "kernels/dispatch/layout.h"

namespace ctpbench {

inline constexpr std::uint32_t kWideChildren = 8;

struct WideTree {
    // An inner child is a node; a leaf holds `count` references from `first` on.
    struct Child {
        Box box;
        std::uint32_t first;
        std::uint32_t count;  // 0: an inner node, number `first`
    };
    struct Node {
        std::array<Child, kWideChildren> children;
        std::uint32_t child_count;
    };
    std::vector<Node> nodes;  // depth first, the root being node 0; none if the root is a leaf
    Child root{};             // of a tree that is not empty
    std::uint32_t stack = 0;  // entries that a traversal may have postponed at once, the bottom not counted
    double build_seconds = 0;
};

// What a step costs, in the unit of testing a block.
struct CollapseCosts {
    float node = 1.0f;
    float block = 1.5f;
    std::uint32_t block_size = 4;
    std::uint32_t max_leaf = 8;       // references of a leaf, unless the binary tree's are larger
    bool single_type_leaves = false;  // as the binary tree's
};

// Uses oneTBB's current arena. The result does not depend on the number of threads.
WideTree collapse(const TreeView& tree, const CollapseCosts& costs = {});

}  // namespace ctpbench
