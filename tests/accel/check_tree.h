// Checks what a tree promises to a traversal, over any source of primitives.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "accel/sbvh.h"
#include "accel/scene_primitives.h"
#include "accel/tree.h"

namespace ctpbench::test {

using Point = std::array<double, 3>;

// With a tolerance far below a float's rounding: the samples are computed in double.
inline bool holds(const Box& box, const Point& p) {
    for (int a = 0; a < 3; ++a) {
        const double slack = 1e-13 * (1e-30 + std::fabs(p[a]) + std::fabs(box.lo[a]) + std::fabs(box.hi[a]));
        if (!(p[a] >= box.lo[a] - slack && p[a] <= box.hi[a] + slack)) return false;
    }
    return true;
}

// Points of a triangle: corners, edges, inside.
inline std::vector<Point> samples(const TriangleShape& t, int steps) {
    std::vector<Point> points;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const double u = double(i) / steps, v = double(j) / steps, w = double(steps - i - j) / steps;
            Point p;
            for (int a = 0; a < 3; ++a) p[a] = w * t.a[a] + u * t.b[a] + v * t.c[a];
            points.push_back(p);
        }
    }
    return points;
}

inline std::vector<Point> samples(const SphereShape& s, int steps) {
    std::vector<Point> points;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j < 2 * steps; ++j) {
            const double theta = M_PI * i / steps, phi = M_PI * j / steps;
            points.push_back({s.center.x + s.radius * std::sin(theta) * std::cos(phi),
                              s.center.y + s.radius * std::sin(theta) * std::sin(phi),
                              s.center.z + s.radius * std::cos(theta)});
        }
    }
    return points;
}

struct Leaf {
    Box box;
    std::vector<PrimitiveRef> refs;
};

// Walks the tree, checks its shape, and returns its leaves.
inline std::vector<Leaf> check_structure(const Tree& tree, const SbvhSettings& settings) {
    std::vector<Leaf> leaves;
    std::vector<bool> node_seen(tree.nodes.size(), false), entry_seen(tree.refs.size(), false);
    std::uint32_t deepest = 0;
    const std::function<void(std::uint32_t, std::uint32_t)> visit = [&](std::uint32_t at,
                                                                        std::uint32_t depth) {
        ASSERT_LT(at, tree.nodes.size());
        ASSERT_FALSE(node_seen[at]) << "node " << at << " has two parents";
        node_seen[at] = true;
        deepest = std::max(deepest, depth);
        const BvhNode& node = tree.nodes[at];
        if (node.is_leaf()) {
            EXPECT_LE(node.count(), settings.max_leaf);
            ASSERT_LE(std::size_t{node.first} + node.count(), tree.refs.size());
            Leaf leaf{node.box(), {}};
            for (std::uint32_t i = node.first; i < node.first + node.count(); ++i) {
                EXPECT_FALSE(entry_seen[i]) << "entry " << i << " is in two leaves";
                entry_seen[i] = true;
                leaf.refs.push_back(tree.refs[i]);
                EXPECT_EQ(node.type(), settings.single_type_leaves ? tree.refs[i].type : 0u);
            }
            leaves.push_back(leaf);
            return;
        }
        EXPECT_EQ(node.first % 2, 0u);
        for (std::uint32_t child : {node.first, node.first + 1}) {
            ASSERT_LT(child, tree.nodes.size());
            EXPECT_TRUE(node.box().contains(tree.nodes[child].box())) << "child " << child << " of " << at;
            visit(child, depth + 1);
        }
    };
    visit(0, 1);
    EXPECT_EQ(tree.depth, deepest);
    EXPECT_LE(tree.depth, kMaxTreeDepth);
    for (std::size_t i = 0; i < node_seen.size(); ++i) EXPECT_EQ(node_seen[i], i != 1) << "node " << i;
    EXPECT_EQ(std::count(entry_seen.begin(), entry_seen.end(), false), 0);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(tree.nodes.data()) % 64, 0u);
    return leaves;
}

// Every point of every primitive is in a leaf that names it, and no leaf is larger than what it names.
inline void check_coverage(const Scene& scene, const std::vector<Leaf>& leaves, std::size_t expected,
                           int steps) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Box>> found;
    for (const Leaf& leaf : leaves) {
        Box all = Box::empty();
        for (const PrimitiveRef& r : leaf.refs) {
            found[{r.type, r.index}].push_back(leaf.box);
            all.extend(r.type == 0 ? bounds(scene.mesh.triangle(r.index)) : bounds(scene.spheres[r.index]));
        }
        EXPECT_TRUE(all.contains(leaf.box));
    }
    EXPECT_EQ(found.size(), expected);
    std::size_t lost = 0;
    for (const auto& [primitive, boxes] : found) {
        const auto points = primitive.first == 0 ? samples(scene.mesh.triangle(primitive.second), steps)
                                                 : samples(scene.spheres[primitive.second], steps);
        for (const Point& p : points) {
            lost += std::none_of(boxes.begin(), boxes.end(), [&](const Box& b) { return holds(b, p); });
        }
    }
    EXPECT_EQ(lost, 0u) << "points of primitives outside all leaves that name them";
}

inline Tree build_and_check(const Scene& scene, const SbvhSettings& settings, int steps = 12,
                            PrimitiveSet which = PrimitiveSet::all) {
    const ScenePrimitives source(scene, which);
    const Tree tree = build_sbvh(source, settings);
    EXPECT_LE(tree.refs.size(), static_cast<std::size_t>(source.size() * double{settings.reference_budget}));
    if (tree.skipped == source.size()) {
        EXPECT_TRUE(tree.empty());
        return tree;
    }
    check_coverage(scene, check_structure(tree, settings), source.size() - tree.skipped, steps);
    return tree;
}

}  // namespace ctpbench::test
