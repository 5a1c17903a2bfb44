#include "accel/wide_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>

#include "base/clock.h"

namespace ctpbench {
namespace {

constexpr std::size_t kTypes = Primitives<Watertight>::size;
// Levels of the binary tree below which subtrees are worked off by one task.
constexpr std::uint32_t kTaskDepth = 10;

// What a subtree costs as a forest of at most i + 1 trees, i < 7, and what it holds.
struct Costs {
    std::array<float, kWideChildren - 1> as_trees;
    std::uint32_t count;                       // references
    std::array<std::uint32_t, kTypes> counts;  // of each type
};

// How that is reached. Of a forest of i + 1 trees, how many go to the first child: 0 if i trees are as good.
struct Decision {
    std::array<std::uint8_t, kWideChildren> trees_of_first;
    bool leaf;  // as one tree, the subtree is a leaf
};

class Collapser {
public:
    Collapser(const TreeView& tree, const CollapseCosts& costs)
        : tree_(tree), costs_(costs), decisions_(tree.node_count) {}

    WideTree collapse() {
        WideTree out;
        if (tree_.ref_count == 0) return out;
        weigh(0, 0);
        out.root = child_of(0);
        if (out.root.count == 0) out.stack = emit(0, out);
        return out;
    }

private:
    static float area(const BvhNode& node) { return node.box().half_area(); }

    Costs weigh(std::uint32_t n, std::uint32_t depth) {
        const BvhNode& node = tree_.nodes[n];
        Costs c{};
        Decision& d = decisions_[n];
        if (node.is_leaf()) {
            c.count = node.count();
            for (std::uint32_t i = 0; i < c.count; ++i) ++c.counts[tree_.refs[node.first + i].type];
            c.as_trees.fill(leaf_cost(node, c));
            d = {{}, true};
            return c;
        }
        Costs l, r;
        const auto left = [&] { l = weigh(node.first, depth + 1); };
        const auto right = [&] { r = weigh(node.first + 1, depth + 1); };
        if (depth < kTaskDepth)
            tbb::parallel_invoke(left, right);
        else
            left(), right();
        c.count = l.count + r.count;
        for (std::size_t t = 0; t < kTypes; ++t) c.counts[t] = l.counts[t] + r.counts[t];

        d = {};
        std::array<float, kWideChildren> forest;  // of exactly i + 1 trees
        forest[0] = std::numeric_limits<float>::infinity();
        for (std::uint32_t i = 1; i < kWideChildren; ++i) {
            forest[i] = std::numeric_limits<float>::infinity();
            for (std::uint32_t k = 0; k < i; ++k) {
                const float cost = l.as_trees[k] + r.as_trees[i - 1 - k];
                if (cost < forest[i])
                    forest[i] = cost, d.trees_of_first[i] = static_cast<std::uint8_t>(k + 1);
            }
        }
        const float inner = costs_.node * area(node) + forest[kWideChildren - 1];
        const float leaf =
            c.count <= costs_.max_leaf ? leaf_cost(node, c) : std::numeric_limits<float>::infinity();
        d.leaf = leaf <= inner;
        c.as_trees[0] = std::min(leaf, inner);
        for (std::uint32_t i = 1; i + 1 < kWideChildren; ++i) {
            c.as_trees[i] = std::min(c.as_trees[i - 1], forest[i]);
            if (c.as_trees[i - 1] <= forest[i]) d.trees_of_first[i] = 0;
        }
        return c;
    }
    float leaf_cost(const BvhNode& node, const Costs& c) const {
        std::uint32_t blocks = 0, types = 0;
        for (std::uint32_t n : c.counts) {
            blocks += (n + costs_.block_size - 1) / costs_.block_size;
            types += n > 0;
        }
        if (costs_.single_type_leaves && types > 1) return std::numeric_limits<float>::infinity();
        return area(node) * costs_.block * static_cast<float>(blocks);
    }

    WideTree::Child child_of(std::uint32_t n) const {
        const Box box = tree_.nodes[n].box();
        if (!decisions_[n].leaf) return {box, n, 0};
        const Range range = range_of(n);
        return {box, range.first, range.end - range.first};
    }
    struct Range {
        std::uint32_t first, end;
    };
    // References of a small subtree: they lie together.
    Range range_of(std::uint32_t n) const {
        const BvhNode& node = tree_.nodes[n];
        if (node.is_leaf()) return {node.first, node.first + node.count()};
        const Range l = range_of(node.first), r = range_of(node.first + 1);
        return {std::min(l.first, r.first), std::max(l.end, r.end)};
    }

    void gather(std::uint32_t n, std::uint32_t trees, WideTree::Node& node) const {
        const Decision& d = decisions_[n];
        while (trees > 1 && (tree_.nodes[n].is_leaf() || d.trees_of_first[trees - 1] == 0)) --trees;
        if (trees == 1) {
            node.children[node.child_count++] = child_of(n);
            return;
        }
        const std::uint32_t of_first = d.trees_of_first[trees - 1];
        gather(tree_.nodes[n].first, of_first, node);
        gather(tree_.nodes[n].first + 1, trees - of_first, node);
    }

    // Returns what may be postponed at once below.
    std::uint32_t emit(std::uint32_t n, WideTree& out) const {
        const std::size_t place = out.nodes.size();
        WideTree::Node node{};
        const std::uint32_t of_first = decisions_[n].trees_of_first[kWideChildren - 1];
        gather(tree_.nodes[n].first, of_first, node);
        gather(tree_.nodes[n].first + 1, kWideChildren - of_first, node);
        out.nodes.push_back(node);
        std::uint32_t below = 0;
        for (std::uint32_t i = 0; i < node.child_count; ++i) {
            WideTree::Child& child = node.children[i];
            if (child.count != 0) continue;
            const std::uint32_t from = child.first;
            out.nodes[place].children[i].first = static_cast<std::uint32_t>(out.nodes.size());
            below = std::max(below, emit(from, out));
        }
        return node.child_count - 1 + below;
    }

    TreeView tree_;
    CollapseCosts costs_;
    std::vector<Decision> decisions_;
};

}  // namespace

WideTree collapse(const TreeView& tree, const CollapseCosts& costs) {
    WideTree out;
    const double seconds = seconds_of([&] { out = Collapser(tree, costs).collapse(); });
    out.build_seconds = seconds;
    return out;
}

}  // namespace ctpbench
