#include "accel/tree.h"

#include <gtest/gtest.h>

namespace ctpbench::test {
namespace {

// A unit cube with a leaf of two entries in its lower half and one of one entry in its upper quarter.
Tree small_tree() {
    Tree tree;
    tree.nodes.resize(4, BvhNode{});
    tree.nodes[0].set_box({{0, 0, 0}, {1, 1, 1}});
    tree.nodes[0].first = 2;
    tree.nodes[2].set_box({{0, 0, 0}, {1, 1, 0.5f}});
    tree.nodes[2].leaf = BvhNode::leaf_word(0, 2);
    tree.nodes[3].set_box({{0, 0, 0.75f}, {1, 1, 1}});
    tree.nodes[3].first = 2;
    tree.nodes[3].leaf = BvhNode::leaf_word(0, 1);
    tree.refs = {{0, 0}, {0, 1}, {0, 2}};
    return tree;
}

TEST(Tree, SurfaceAreaCostByHand) {
    // Halves of surface areas: 3, 2 and 1.5.
    EXPECT_FLOAT_EQ(sah_cost(small_tree()), 1 + 2 * 2 / 3.0f + 1.5f / 3);
    EXPECT_EQ(sah_cost(Tree{}), 0.0f);
}

TEST(Tree, CountsNodesWithoutPadding) {
    EXPECT_EQ(small_tree().node_count(), 3u);
    EXPECT_EQ(Tree{}.node_count(), 0u);
}

TEST(Tree, HashSeesNodesAndReferences) {
    const Tree tree = small_tree();
    Tree other = tree;
    EXPECT_EQ(hash(tree), hash(other));
    other.refs[2].index = 7;
    EXPECT_NE(hash(tree), hash(other));
    other = tree;
    other.nodes[3].bounds[0] = 0.5f;
    EXPECT_NE(hash(tree), hash(other));
}

}  // namespace
}  // namespace ctpbench::test
