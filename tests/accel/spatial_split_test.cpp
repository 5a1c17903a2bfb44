// The search for a spatial split against a slow one that cuts every reference at every plane.
#include "accel/spatial_split.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "accel/scene_primitives.h"
#include "tests/accel/soups.h"

namespace ctpbench::test {
namespace {

struct Node {
    std::vector<Reference> refs;
    Bounds4 box = Bounds4::empty();
};

Node node_of(const ScenePrimitives& source, std::uint32_t first, std::uint32_t count) {
    Node node;
    for (std::uint32_t i = first; i < first + count; ++i) {
        node.refs.push_back(Reference::make(source.bounds(i), i, source.ref(i).type));
        node.box.extend(node.refs.back().bounds());
    }
    return node;
}

double slow_best(const ScenePrimitives& source, const Node& node, const SbvhSettings& settings) {
    double best = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const BinGrid grid(node.box.lo[axis], node.box.hi[axis], settings.spatial_bins);
        for (int b = 1; b <= grid.last; ++b) {
            Bounds4 left = Bounds4::empty(), right = Bounds4::empty();
            std::uint32_t lefts = 0, rights = 0;
            for (const Reference& r : node.refs) {
                const int first = grid.bin(r.lo[axis]), last = grid.end_bin(r.hi[axis], first);
                lefts += first < b;
                rights += last >= b;
                if (last < b) {
                    left.extend(r.bounds());
                } else if (first >= b) {
                    right.extend(r.bounds());
                } else {
                    left.extend(clip_reference(source, r, axis, r.lo[axis], grid.plane(b)));
                    right.extend(clip_reference(source, r, axis, grid.plane(b), r.hi[axis]));
                }
            }
            if (lefts == 0 || rights == 0) continue;
            if (lefts == node.refs.size() && rights == node.refs.size()) continue;
            best = std::min(best, double{left.half_area()} * lefts + double{right.half_area()} * rights);
        }
    }
    return best;
}

TEST(SpatialSplit, FindsTheCheapestPlane) {
    Scene scene = needles(2000, {0, 0, 0}, 1, 7);
    add_spheres(scene, 200, {0, 0, 0}, 1, 0.1f, 8);
    const ScenePrimitives source(scene);
    SbvhSettings settings;
    settings.sweep_below = 0;
    for (std::uint32_t first = 0; first + 50 <= source.size(); first += 50) {
        const Node node = node_of(source, first, 50);
        const double expected = slow_best(source, node, settings);
        const auto find = [&](double below) {
            return find_spatial_split(source, node.refs, node.box, 1000, below, settings);
        };
        const SpatialSplit any = find(std::numeric_limits<double>::infinity());
        ASSERT_TRUE(any.exists());
        EXPECT_NEAR(any.cost, expected, 1e-4 * expected) << first;
        // A bound takes away planes that cost more, and no others.
        const SpatialSplit bounded = find(any.cost * 1.0001);
        ASSERT_TRUE(bounded.exists()) << first;
        EXPECT_NEAR(bounded.cost, any.cost, 1e-5 * any.cost);
        EXPECT_EQ(bounded.axis, any.axis);
        EXPECT_EQ(bounded.first_right_bin, any.first_right_bin);
        EXPECT_FALSE(find(any.cost * 0.9999).exists()) << first;
    }
}

TEST(SpatialSplit, KeepsToTheRoomThereIs) {
    const Scene scene = needles(800, {0, 0, 0}, 1, 9);
    const ScenePrimitives source(scene);
    const Node node = node_of(source, 0, 800);
    for (const std::size_t room : {800, 810, 850, 900}) {
        const SpatialSplit split = find_spatial_split(source, node.refs, node.box, room,
                                                      std::numeric_limits<double>::infinity(), {});
        EXPECT_LE(split.left + split.right, room);  // none if there is no split
    }
}

}  // namespace
}  // namespace ctpbench::test
