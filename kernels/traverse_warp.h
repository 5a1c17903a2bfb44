// The traversal of traverse.h as a GPU wants it, where 32 rays walk in step. Differences, each for a reason:
// - A node is fetched with two 16-byte loads, and what the stack holds is all that descending needs, so that
//   every step waits for memory once.
// - A lane that has found a leaf puts it aside and walks on, until enough lanes have found one (Aila & Laine,
//   "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009): few lanes in step waste the others.
// The stack is the one array that is indexed at run time: it lies in local memory, and nothing else may.
#pragma once

#include "bvh.h"
#include "methods/bundles.h"
#include "ray.h"

#if defined(__CUDACC__)

namespace ctpbench {

// How many lanes of a warp must have stopped, with a leaf or at their end, before leaves are tested.
#if !defined(CTPBENCH_LEAF_VOTE)
#define CTPBENCH_LEAF_VOTE 20
#endif
inline constexpr int kLeafVote = CTPBENCH_LEAF_VOTE;

__device__ __forceinline__ BvhNode load_node(const BvhNode* node) {
    const uint4* words = reinterpret_cast<const uint4*>(node);
    const uint4 a = __ldg(words), b = __ldg(words + 1);
    BvhNode n;
    n.bounds[0] = __uint_as_float(a.x), n.bounds[1] = __uint_as_float(a.y);
    n.bounds[2] = __uint_as_float(a.z), n.bounds[3] = __uint_as_float(a.w);
    n.bounds[4] = __uint_as_float(b.x), n.bounds[5] = __uint_as_float(b.y);
    n.first = b.z, n.leaf = b.w;
    return n;
}

// Calls leaf(node) as traverse() does; of the node only `first` and `leaf` are set.
template <class Methods, class Leaf>
__device__ __forceinline__ void traverse_in_warp(const BvhNode* nodes, const RayContext<Methods>& ray,
                                                 Hit& hit, Leaf&& leaf) {
    using BoxTest = typename Methods::Box;
    struct Entry {
        std::uint32_t first, leaf;
        float near;
    };
    Entry stack[kMaxTreeDepth];
    std::uint32_t top = 0;
    // The node to go on with: `first`, and 0 for an inner node. kNone: this ray is done with inner nodes.
    constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t first, word;
    std::uint32_t held_first = 0, held = 0;  // the leaf put aside; 0: there is none

    const auto pop = [&] {
        while (top != 0) {
            --top;
            if (stack[top].near <= hit.t) {
                first = stack[top].first, word = stack[top].leaf;
                return;
            }
        }
        word = none;
    };

    {
        const BvhNode root = load_node(nodes);
        float near;
        if (!BoxTest::test(root, ray.box, hit.t, near)) return;
        first = root.first, word = root.leaf;
    }
    while (true) {
        while (true) {
            if (word == 0) {
                const BvhNode a = load_node(nodes + first), b = load_node(nodes + first + 1);
                float near_a, near_b;
                const bool hit_a = BoxTest::test(a, ray.box, hit.t, near_a);
                const bool hit_b = BoxTest::test(b, ray.box, hit.t, near_b);
                const bool next_b = hit_b && (!hit_a || near_b < near_a);
                if (hit_a && hit_b)
                    stack[top++] = {next_b ? a.first : b.first, next_b ? a.leaf : b.leaf,
                                    next_b ? near_a : near_b};
                if (hit_a || hit_b)
                    first = next_b ? b.first : a.first, word = next_b ? b.leaf : a.leaf;
                else
                    pop();
            }
            if (word != 0 && word != none && held == 0) {
                held_first = first, held = word;
                pop();
            }
            // A lane goes on while it can and enough others do. Which lanes are still here affects speed
            // alone.
            if (word != 0 || __popc(__activemask()) <= 32 - kLeafVote) break;
        }
        if (held != 0) {
            BvhNode n;
            n.first = held_first, n.leaf = held;
            held = 0;
            leaf(n);
        } else if (word == none) {
            return;
        }
    }
}

}  // namespace ctpbench

#endif
