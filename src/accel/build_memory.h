// The memory of a build, divided among subtrees so that they can be built in parallel without sharing
// anything, and so that a budget that runs out does so in the same place in every run.
//
// References live in two buffers of the budgeted size. A node owns a range of one of them, longer than the
// references in it: the rest is its share of the budget. It writes its children's references into its range
// of the other buffer, and divides what is left of the range between them.
//
// A subtree that one task builds grows in memory of the thread's own, and is then packed behind those that
// are done: wherever that is, since the final order does not depend on it.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/huge_array.h"
#include "accel/partition.h"
#include "accel/reference.h"
#include "accel/split_sweep.h"
#include "accel/tree_layout.h"
#include "kernels/bvh.h"

namespace ctpbench {

// A node to build: `count` references at `begin` of buffer `buffer`, room for `capacity`.
struct BuildJob {
    std::uint32_t begin, count, capacity, depth;
    int buffer;
    Extent extent;
};

// Where a node's children go, and what has been put there.
struct Children {
    Side left, right;
    std::uint32_t right_begin = 0;

    BuildJob left_job(const BuildJob& parent) const {
        return {parent.begin,     left.count,        right_begin - parent.begin,
                parent.depth + 1, 1 - parent.buffer, left.extent};
    }
    BuildJob right_job(const BuildJob& parent) const {
        return {right_begin,      right.count,       parent.capacity - (right_begin - parent.begin),
                parent.depth + 1, 1 - parent.buffer, right.extent};
    }
};

// What is below the root of a subtree that one task builds, in the order in which it is added.
struct Subtree {
    std::vector<BvhNode> nodes;
    std::vector<PrimitiveRef> entries;
};

class BuildMemory {
public:
    // For at most `capacity` references. Pages that are not written to are never committed.
    explicit BuildMemory(std::size_t capacity)
        : references_{HugeArray<Reference>(capacity), HugeArray<Reference>(capacity)},
          nodes_(2 * capacity),
          entries_(capacity) {}

    Reference* references(int buffer) { return references_[buffer].get(); }
    std::span<const Reference> references(const BuildJob& job) const {
        return {references_[job.buffer].get() + job.begin, job.count};
    }
    // Of this thread, empty.
    Subtree& subtree() {
        Subtree& own = subtrees_.local();
        own.nodes.clear();
        own.entries.clear();
        return own;
    }
    void pack(const Subtree& from, TreePart& part) {
        BvhNode* nodes = nodes_.get() + nodes_used_.fetch_add(from.nodes.size());
        PrimitiveRef* entries = entries_.get() + entries_used_.fetch_add(from.entries.size());
        std::copy(from.nodes.begin(), from.nodes.end(), nodes);
        std::copy(from.entries.begin(), from.entries.end(), entries);
        part.nodes = nodes;
        part.entries = entries;
    }

    // Divides the node's range for at most as many references as `sides` says. What is to spare goes where
    // it is likely to be used: to many references, and to large ones. A single one is never split.
    Children divide(const BuildJob& job, const SplitSides& sides) {
        const auto weight = [](std::uint32_t count, float area) {
            return count > 1 ? count * std::sqrt(double{area}) : 0.0;
        };
        const double left = weight(sides.left, sides.left_box.half_area());
        const double right = weight(sides.right, sides.right_box.half_area());
        const double share = left + right > 0 ? left / (left + right) : 0.5;
        const std::uint32_t spare = job.capacity - sides.left - sides.right;
        Children children;
        children.right_begin =
            job.begin + sides.left + std::min(spare, static_cast<std::uint32_t>(share * spare));
        children.left.out = references(1 - job.buffer) + job.begin;
        children.right.out = references(1 - job.buffer) + children.right_begin;
        return children;
    }

    // Once the tree is built, to make room for the final one.
    void release_references() {
        for (auto& b : references_) b.reset();
    }

private:
    HugeArray<Reference> references_[2];
    // A tree of as many leaves as there is room for references has one inner node less, each with a pair.
    HugeArray<BvhNode> nodes_;
    HugeArray<PrimitiveRef> entries_;
    std::atomic<std::size_t> nodes_used_{0}, entries_used_{0};
    tbb::enumerable_thread_specific<Subtree> subtrees_;
};

}  // namespace ctpbench
