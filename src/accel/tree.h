// The result of a build: nodes, and leaf entries in leaf order. A strategy lays out its primitives from
// this in one pass. Depth-first order is not promised; siblings are adjacent and 64-byte aligned pairs
// except for the root, which is node 0 (node 1 is unused padding).
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

#include "accel/tree_array.h"
#include "kernels/bvh.h"

namespace ctpbench {

struct Tree {
    TreeArray<BvhNode> nodes;
    TreeArray<PrimitiveRef> refs;  // leaf entries; a spatially split primitive appears more than once
    std::uint32_t depth = 0;       // nodes on the longest path; at most kMaxTreeDepth
    float sah = 0.0f;              // surface area heuristic cost with unit costs, see sah_cost()
    double build_seconds = 0.0;
    std::size_t skipped = 0;  // primitives left out: empty, NaN, infinite or absurdly large bounds

    // Nodes in use, without the padding.
    std::size_t node_count() const { return nodes.size() < 2 ? nodes.size() : nodes.size() - 1; }
    bool empty() const { return refs.empty(); }
};

// Expected node steps plus primitive tests of a random ray that meets the root: every inner node and
// every leaf entry weighs 1.
float sah_cost(const Tree& tree);

// XXH3 of nodes and references, for the record of a run.
std::uint64_t hash(const Tree& tree);

}  // namespace ctpbench
