#include "accel/tree_layout.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace ctpbench {
namespace {

// Where what is below a part goes.
struct Place {
    std::uint32_t pair, entry;
};

BvhNode moved(BvhNode node, const Place& by) {
    node.first += node.is_leaf() ? by.entry : by.pair;
    return node;
}

void copy(const TreePart& part, std::uint32_t to, const Place& below, Tree& tree) {
    if (part.left == nullptr) {
        tree.nodes[to] = moved(part.root, below);
        std::transform(part.nodes, part.nodes + 2 * std::size_t{part.size.inner},
                       tree.nodes.begin() + below.pair,
                       [&](const BvhNode& node) { return moved(node, below); });
        std::copy_n(part.entries, part.size.entries, tree.refs.begin() + below.entry);
        return;
    }
    tree.nodes[to] = part.root;
    tree.nodes[to].first = below.pair;
    const bool in_order = left_first(part.left->root, part.right->root);
    const SubtreeSize& first = in_order ? part.left->size : part.right->size;
    const Place near{below.pair + 2, below.entry};
    const Place far{near.pair + 2 * first.inner, near.entry + first.entries};
    tbb::parallel_invoke([&] { copy(*part.left, below.pair, in_order ? near : far, tree); },
                         [&] { copy(*part.right, below.pair + 1, in_order ? far : near, tree); });
}

}  // namespace

void assemble(const TreePart& root, Tree& tree) {
    tree.nodes.resize(root.size.inner == 0 ? 1 : 2 + 2 * std::size_t{root.size.inner});
    tree.refs.resize(root.size.entries);
    if (tree.nodes.size() > 1) tree.nodes[1] = BvhNode{};
    tree.depth = root.size.depth;
    copy(root, 0, {2, 0}, tree);
}

}  // namespace ctpbench
