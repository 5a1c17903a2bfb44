// The memory of a build, divided among subtrees so that they can be built in parallel without sharing
// anything, and so that a budget that runs out does so in the same place in every run.
//
// A node's capacity is the number of references that its subtree may have: its own, and a share of what the
// budget has to spare. Large nodes are split level by level; the references of a level lie packed in one of
// two buffers, in no particular order of nodes. A small node's subtree is built by one task, in memory of
// the thread's own that stays in its cache: there a node has a range of one of two buffers as long as its
// capacity, and its children have parts of the same range of the other buffer.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "accel/huge_array.h"
#include "accel/reference.h"
#include "accel/sides.h"
#include "accel/split_sweep.h"
#include "accel/tree_layout.h"
#include "kernels/bvh.h"

namespace ctpbench {

// A node to build. `begin` and `buffer` are meaningful in a task.
struct BuildJob {
    const Reference* refs;
    std::uint32_t count, capacity, depth, begin;
    int buffer;
    Extent extent;

    std::span<const Reference> references() const { return {refs, count}; }
};

// A node's children, and how its capacity is divided.
struct Children {
    Side left, right;
    std::uint32_t left_capacity = 0;

    BuildJob left_job(const BuildJob& parent) const {
        return {left.out,     left.count,        left_capacity, parent.depth + 1,
                parent.begin, 1 - parent.buffer, left.extent};
    }
    BuildJob right_job(const BuildJob& parent) const {
        return {right.out,
                right.count,
                parent.capacity - left_capacity,
                parent.depth + 1,
                parent.begin + left_capacity,
                1 - parent.buffer,
                right.extent};
    }
};

// Divides a node's capacity for at most as many references as `sides` says. What is to spare goes where it
// is likely to be used: to many references, and to large ones. A single one is never split.
inline std::uint32_t capacity_of_left(const BuildJob& job, const SplitSides& sides) {
    const auto weight = [](std::uint32_t count, float area) {
        return count > 1 ? count * std::sqrt(double{area}) : 0.0;
    };
    const double left = weight(sides.left, sides.left_box.half_area());
    const double right = weight(sides.right, sides.right_box.half_area());
    const double share = left + right > 0 ? left / (left + right) : 0.5;
    const std::uint32_t spare = job.capacity - sides.left - sides.right;
    return sides.left + std::min(spare, static_cast<std::uint32_t>(share * spare));
}

// Where a task works, and what it has built below the root of its subtree, in the final order.
class TaskMemory {
public:
    std::vector<BvhNode> nodes;
    std::vector<PrimitiveRef> entries;

    // Empties it, and moves a node's references here.
    BuildJob begin(const BuildJob& from) {
        nodes.clear();
        entries.clear();
        for (auto& b : references_) {
            if (b.size() < from.capacity) b = HugeArray<Reference>(2 * std::size_t{from.capacity});
        }
        BuildJob job = from;
        std::copy_n(from.refs, from.count, references_[0].get());
        job.refs = references_[0].get();
        job.begin = 0;
        job.buffer = 0;
        return job;
    }
    Children divide(const BuildJob& job, const SplitSides& sides) {
        Children children;
        children.left_capacity = capacity_of_left(job, sides);
        children.left.out = references_[1 - job.buffer].get() + job.begin;
        children.right.out = children.left.out + children.left_capacity;
        return children;
    }
    ReferencePool* pool() { return nullptr; }

private:
    HugeArray<Reference> references_[2] = {HugeArray<Reference>(0), HugeArray<Reference>(0)};
};

// Where the children of a level's nodes go.
class LevelMemory {
public:
    explicit LevelMemory(Reference* to) : pool_(to) {}

    Children divide(const BuildJob& job, const SplitSides& sides) {
        Children children;
        children.left_capacity = capacity_of_left(job, sides);
        return children;
    }
    ReferencePool* pool() { return &pool_; }

private:
    ReferencePool pool_;
};

class BuildMemory {
public:
    // For at most `capacity` references. Pages that are not written to are never committed.
    explicit BuildMemory(std::size_t capacity)
        : references_{HugeArray<Reference>(capacity), HugeArray<Reference>(capacity)},
          nodes_(2 * capacity),
          entries_(capacity) {}

    Reference* references(int buffer) { return references_[buffer].get(); }
    // Of this thread.
    TaskMemory& task() { return tasks_.local(); }

    // Keeps what a task has built: wherever there is room, since the final order does not depend on it.
    void pack(const TaskMemory& from, TreePart& part) {
        BvhNode* nodes = nodes_.get() + nodes_used_.fetch_add(from.nodes.size());
        PrimitiveRef* entries = entries_.get() + entries_used_.fetch_add(from.entries.size());
        std::copy(from.nodes.begin(), from.nodes.end(), nodes);
        std::copy(from.entries.begin(), from.entries.end(), entries);
        part.nodes = nodes;
        part.entries = entries;
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
    tbb::enumerable_thread_specific<TaskMemory> tasks_;
};

}  // namespace ctpbench
