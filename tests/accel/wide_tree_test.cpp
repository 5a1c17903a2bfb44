#include "accel/wide_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "accel/scene_primitives.h"
#include "backends/cpu.h"
#include "soups.h"

namespace ctpbench::test {
namespace {

TreeView view_of(const Tree& tree) {
    return {tree.nodes.data(), tree.refs.data(), tree.nodes.size(), tree.refs.size()};
}

Scene scene_of(std::size_t triangles, std::size_t spheres) {
    Scene scene = needles(triangles, {0, 0, 0}, 1.0f, 5);
    Random random(9);
    for (std::size_t i = 0; i < spheres; ++i)
        scene.spheres.push_back({random.point(-1, 1), random.uniform(0.01f, 0.1f)});
    return scene;
}

struct Walk {
    std::vector<int> entries;  // how many leaves hold each
    std::uint32_t most_postponed = 0;
    std::size_t nodes = 0;
    float cost = 0;  // with the default costs, over the root's area
};

std::uint32_t blocks_of(const Tree& tree, const WideTree::Child& leaf, std::uint32_t* types = nullptr) {
    std::uint32_t counts[2] = {};
    for (std::uint32_t i = 0; i < leaf.count; ++i) ++counts[tree.refs[leaf.first + i].type];
    if (types != nullptr) *types = (counts[0] > 0) + (counts[1] > 0);
    return (counts[0] + 3) / 4 + (counts[1] + 3) / 4;
}

void walk(const Tree& tree, const WideTree& wide, const WideTree::Child& child, std::uint32_t postponed,
          Walk& out) {
    if (child.count != 0) {
        out.most_postponed = std::max(out.most_postponed, postponed);
        for (std::uint32_t i = 0; i < child.count; ++i) ++out.entries[child.first + i];
        out.cost += 1.5f * static_cast<float>(blocks_of(tree, child)) * child.box.half_area();
        return;
    }
    ++out.nodes;
    out.cost += child.box.half_area();
    const WideTree::Node& node = wide.nodes.at(child.first);
    ASSERT_GE(node.child_count, 2u);
    ASSERT_LE(node.child_count, kWideChildren);
    for (std::uint32_t i = 0; i < node.child_count; ++i) {
        EXPECT_TRUE(child.box.contains(node.children[i].box));
        walk(tree, wide, node.children[i], postponed + node.child_count - 1, out);
    }
}

TEST(WideTree, HoldsEveryEntryOnceAndBoundsTheStack) {
    CpuBackend backend(2);
    for (const std::size_t spheres : {0, 500})
        for (const bool single_type : {false, true}) {
            const Scene scene = scene_of(2000, spheres);
            SbvhSettings settings;
            settings.single_type_leaves = single_type;
            const Tree tree = build_sbvh(ScenePrimitives(scene), settings);
            CollapseCosts costs;
            costs.single_type_leaves = single_type;
            const WideTree wide = backend.execute([&] { return collapse(view_of(tree), costs); });
            Walk seen;
            seen.entries.resize(tree.refs.size());
            walk(tree, wide, wide.root, 0, seen);
            EXPECT_EQ(std::count(seen.entries.begin(), seen.entries.end(), 1),
                      static_cast<std::ptrdiff_t>(tree.refs.size()));
            EXPECT_EQ(seen.nodes, wide.nodes.size());
            EXPECT_EQ(seen.most_postponed, wide.stack);
            for (const WideTree::Node& node : wide.nodes)
                for (std::uint32_t i = 0; i < node.child_count; ++i) {
                    std::uint32_t types = 0;
                    if (node.children[i].count == 0) continue;
                    blocks_of(tree, node.children[i], &types);
                    EXPECT_LE(types, single_type ? 1u : 2u);
                    EXPECT_LE(node.children[i].count, costs.max_leaf);
                }
        }
}

// Against the greedy collapse, which opens the child of the largest area until there are eight.
float greedy_cost(const Tree& tree, std::uint32_t n) {
    const auto area = [&](std::uint32_t i) { return tree.nodes[i].box().half_area(); };
    if (tree.nodes[n].is_leaf()) {
        const WideTree::Child leaf{{}, tree.nodes[n].first, tree.nodes[n].count()};
        return 1.5f * static_cast<float>(blocks_of(tree, leaf)) * area(n);
    }
    std::vector<std::uint32_t> children = {tree.nodes[n].first, tree.nodes[n].first + 1};
    while (children.size() < kWideChildren) {
        auto largest = children.end();
        for (auto c = children.begin(); c != children.end(); ++c)
            if (!tree.nodes[*c].is_leaf() && (largest == children.end() || area(*c) > area(*largest)))
                largest = c;
        if (largest == children.end()) break;
        const std::uint32_t pair = tree.nodes[*largest].first;
        *largest = pair;
        children.push_back(pair + 1);
    }
    float cost = area(n);
    for (const std::uint32_t c : children) cost += greedy_cost(tree, c);
    return cost;
}

TEST(WideTree, CostsLessThanAGreedyCollapse) {
    const Scene scene = scene_of(3000, 0);
    const Tree tree = build_sbvh(ScenePrimitives(scene), SbvhSettings{});
    const WideTree wide = collapse(view_of(tree));
    Walk seen;
    seen.entries.resize(tree.refs.size());
    walk(tree, wide, wide.root, 0, seen);
    EXPECT_LT(seen.cost, 0.98f * greedy_cost(tree, 0));
}

TEST(WideTree, IsTheSameWithAnyNumberOfThreads) {
    const Scene scene = scene_of(20000, 1000);
    const Tree tree = build_sbvh(ScenePrimitives(scene), SbvhSettings{});
    CpuBackend one(1), two(2);
    const WideTree a = one.execute([&] { return collapse(view_of(tree)); });
    const WideTree b = two.execute([&] { return collapse(view_of(tree)); });
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
        ASSERT_EQ(a.nodes[n].child_count, b.nodes[n].child_count);
        for (std::uint32_t i = 0; i < a.nodes[n].child_count; ++i) {
            EXPECT_EQ(a.nodes[n].children[i].first, b.nodes[n].children[i].first);
            EXPECT_EQ(a.nodes[n].children[i].count, b.nodes[n].children[i].count);
        }
    }
    EXPECT_EQ(a.stack, b.stack);
}

TEST(WideTree, OfNothingOrOfOneLeafHasNoNodes) {
    EXPECT_TRUE(collapse(TreeView{}).nodes.empty());
    const Scene scene = scene_of(1, 0);
    const Tree tree = build_sbvh(ScenePrimitives(scene), SbvhSettings{});
    const WideTree wide = collapse(view_of(tree));
    EXPECT_TRUE(wide.nodes.empty());
    EXPECT_EQ(wide.root.count, 1u);
}

}  // namespace
}  // namespace ctpbench::test
