// Single-ray traversal of the binary tree, front to back. What a leaf does is the caller's: that is
// where strategies differ.
#pragma once

#include "bvh.h"
#include "methods/bundles.h"
#include "traverse_warp.h"

namespace ctpbench {

// Calls leaf(node) for every leaf that the ray can meet at or before hit.t, which the call may lower.
// entries(node) is the address of a leaf's first entry, to be fetched ahead.
// Both children are tested from their parent's step; the choice among them is arithmetic rather than
// branches, which incoherent rays would mispredict.
template <class Methods, class Entries, class Leaf>
CTP_INLINE void traverse(const BvhNode* nodes, const RayContext<Methods>& ray, Hit& hit,
                         [[maybe_unused]] Entries&& entries, Leaf&& leaf) {
#if defined(__CUDA_ARCH__)
    traverse_in_warp<Methods>(nodes, ray, hit, leaf);
#else
    using BoxTest = typename Methods::Box;
    struct Entry {
        std::uint32_t node;
        float near;
    };
    Entry stack[kMaxTreeDepth];
    std::uint32_t top = 0;

    const BvhNode* node = nodes;
    float root_near;
    if (!BoxTest::test(*node, ray.box, hit.t, root_near)) return;
    while (true) {
        bool any = true;
        while (!node->is_leaf()) {
            const std::uint32_t first = node->first;
            const BvhNode* pair = nodes + first;
            // What comes after either child, while this pair's boxes are tested.
            prefetch(pair[0].is_leaf() ? entries(pair[0]) : nodes + pair[0].first);
            prefetch(pair[1].is_leaf() ? entries(pair[1]) : nodes + pair[1].first);
            float near0, near1;
            const bool hit0 = BoxTest::test(pair[0], ray.box, hit.t, near0);
            const bool hit1 = BoxTest::test(pair[1], ray.box, hit.t, near1);
            any = hit0 | hit1;
            if (!any) break;
            const std::uint32_t next = static_cast<std::uint32_t>(hit1) & (!hit0 | (near1 < near0));
            stack[top] = {first + (next ^ 1u), next ? near0 : near1};
            top += static_cast<std::uint32_t>(hit0 & hit1);
            node = pair + next;
        }
        if (any) leaf(*node);
        do {
            if (top == 0) return;
            --top;
        } while (stack[top].near > hit.t);
        node = nodes + stack[top].node;
    }
#endif
}

}  // namespace ctpbench
