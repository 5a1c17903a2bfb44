// The memory of a build, divided among subtrees so that they can be built in parallel without sharing
// anything, and so that a budget that runs out does so in the same place in every run.
//
// References live in two buffers of the budgeted size. A node owns a range of one of them, longer than the
// references in it: the rest is its share of the budget. It writes its children's references into its range
// of the other buffer, and divides what is left of the range between them. The place where the second
// child's range begins belongs to no other node, and names the slot of the pair in the node array.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "accel/huge_array.h"
#include "accel/object_split.h"
#include "accel/partition.h"
#include "accel/reference.h"
#include "accel/tree_layout.h"

namespace ctpbench {

// A node to build: `count` references at `begin` of buffer `buffer`, room for `capacity`.
struct BuildJob {
    std::uint32_t node, begin, count, capacity, depth;
    int buffer;
    Extent extent;
};

// Where a node's children go, and what has been put there.
struct Children {
    Side left, right;
    std::uint32_t right_begin = 0;

    BuildJob left_job(const BuildJob& parent) const {
        return {2 * right_begin,  parent.begin,      left.count, right_begin - parent.begin,
                parent.depth + 1, 1 - parent.buffer, left.extent};
    }
    BuildJob right_job(const BuildJob& parent) const {
        return {2 * right_begin + 1, right_begin,
                right.count,         parent.capacity - (right_begin - parent.begin),
                parent.depth + 1,    1 - parent.buffer,
                right.extent};
    }
};

class BuildMemory {
public:
    // For at most `capacity` references. Pages that are not written to are never committed.
    explicit BuildMemory(std::size_t capacity)
        : capacity_(capacity),
          references_{HugeArray<Reference>(capacity), HugeArray<Reference>(capacity)},
          nodes_(2 * capacity),
          first_child_(capacity),
          entries_(capacity) {}

    Reference* references(int buffer) { return references_[buffer].get(); }
    std::span<const Reference> references(const BuildJob& job) const {
        return {references_[job.buffer].get() + job.begin, job.count};
    }
    BvhNode& node(const BuildJob& job) { return nodes_[job.node]; }
    void set_first_child(const Children& children, SubtreeSize size) {
        first_child_[children.right_begin] = size;
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

    // Keeps the primitives of a leaf, and returns where.
    std::uint32_t store_leaf(const BuildJob& job) {
        std::uint32_t* out = entries_.get() + job.begin;
        for (const Reference& r : references(job)) *out++ = r.primitive();
        return job.begin;
    }

    // The tree in its final order. Nothing is left here.
    OrderedTree release(SubtreeSize size) {
        for (auto& b : references_) b.reset();
        OrderedTree ordered = order_depth_first({{nodes_.get(), 2 * capacity_},
                                                 {first_child_.get(), capacity_},
                                                 {entries_.get(), capacity_},
                                                 size});
        nodes_.reset();
        first_child_.reset();
        entries_.reset();
        return ordered;
    }

private:
    std::size_t capacity_;
    HugeArray<Reference> references_[2];
    HugeArray<BvhNode> nodes_;
    HugeArray<SubtreeSize> first_child_;  // of the pair in each slot
    HugeArray<std::uint32_t> entries_;
};

}  // namespace ctpbench
