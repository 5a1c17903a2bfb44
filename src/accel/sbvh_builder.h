// The builder that sbvh.h declares: from the root down, each node takes the best of an object split, a
// spatial split and staying a leaf; then its children are built, in parallel where they are large.
#pragma once

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "accel/build_memory.h"
#include "accel/build_progress.h"
#include "accel/object_split.h"
#include "accel/parallel.h"
#include "accel/partition.h"
#include "accel/reference.h"
#include "accel/sbvh.h"
#include "accel/spatial_split.h"
#include "accel/tree_layout.h"
#include "base/error.h"

namespace ctpbench {

template <PrimitiveSource Source>
class SbvhBuilder {
public:
    SbvhBuilder(const Source& source, const SbvhSettings& settings, const BuildProgress& progress)
        : source_(source), settings_(settings), callback_(progress) {
        settings.validate();
    }

    Tree build() {
        const auto start = std::chrono::steady_clock::now();
        Tree tree;
        const std::size_t primitives = source_.size();
        const auto capacity =
            static_cast<std::size_t>(static_cast<double>(primitives) * settings_.reference_budget);
        if (capacity >= std::size_t{1} << 31) {
            throw Error(ExitCode::usage,
                        "cannot build a tree of " + std::to_string(primitives) +
                            " primitives: with the reference budget there would be over 2^31 "
                            "leaf entries; lower reference_budget or use a smaller scene");
        }
        ProgressReporter progress(callback_, std::max<std::size_t>(capacity, 1));
        progress_ = &progress;
        if (primitives > 0) {
            BuildMemory memory(capacity);
            memory_ = &memory;
            const BuildJob root = gather(memory, static_cast<std::uint32_t>(capacity));
            tree.skipped = primitives - root.count;
            if (root.count > 0) {
                const std::unique_ptr<TreePart> parts = build_part(root);
                memory.release_references();
                assemble(*parts, tree);
                tree.sah = sah_cost(tree);
            }
        }
        tree.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        progress.finish();
        return tree;
    }

private:
    // Spatial splits of fewer references are never the cheapest.
    static constexpr std::uint32_t kFewestToCut = 3;
    // Subtrees of at most this many references are built by one task.
    static constexpr std::uint32_t kTask = 4096;

    // All primitives, as the references of the root.
    BuildJob gather(BuildMemory& memory, std::uint32_t capacity) {
        BuildJob root{0, 0, capacity, 1, 0, {}};
        const std::size_t n = source_.size();
        std::vector<Side> chunks(chunk_count(n));
        for_each_chunk(n, [&](std::size_t c, std::size_t begin, std::size_t end) {
            Side side{memory.references(0) + begin, 0, {}};
            for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                const Box box = source_.bounds(i);
                if (usable(box)) side.put(Reference::make(box, i, source_.ref(i).type));
            }
            chunks[c] = side;
        });
        for (const Side& chunk : chunks) {
            // Moved only if an earlier chunk left some out.
            Reference* to = memory.references(0) + root.count;
            if (to != chunk.out) std::copy_n(chunk.out, chunk.count, to);
            root.count += chunk.count;
            root.extent.extend(chunk.extent);
        }
        root_area_ = root.extent.box.half_area();
        return root;
    }

    // False for NaN too.
    static bool usable(const Box& b) {
        for (int a = 0; a < 3; ++a) {
            if (!(b.lo[a] <= b.hi[a] && b.lo[a] >= -kMaxCoordinate && b.hi[a] <= kMaxCoordinate))
                return false;
        }
        return true;
    }

    static SubtreeSize joined(const SubtreeSize& a, const SubtreeSize& b) {
        return {1 + a.inner + b.inner, a.entries + b.entries, 1 + std::max(a.depth, b.depth)};
    }

    std::unique_ptr<TreePart> build_part(const BuildJob& job) {
        auto part = std::make_unique<TreePart>();
        Children children;
        if (job.count <= kTask || !split(job, children)) {
            Subtree& below = memory_->subtree();
            part->size = build(job, part->root, below);
            memory_->pack(below, *part);
            progress_->add(job.capacity);
            return part;
        }
        part->root.set_box(job.extent.box.box());
        part->root.leaf = 0;
        tbb::parallel_invoke([&] { part->left = build_part(children.left_job(job)); },
                             [&] { part->right = build_part(children.right_job(job)); });
        part->size = joined(part->left->size, part->right->size);
        return part;
    }

    SubtreeSize build(const BuildJob& job, BvhNode& node, Subtree& below) {
        node.set_box(job.extent.box.box());
        Children children;
        if (!split(job, children)) {
            const std::span<const Reference> refs = memory_->references(job);
            node.first = static_cast<std::uint32_t>(below.entries.size());
            node.leaf = BvhNode::leaf_word(settings_.single_type_leaves ? refs[0].type() : 0, job.count);
            for (const Reference& r : refs) below.entries.push_back(source_.ref(r.primitive()));
            return {0, job.count, 1};
        }
        const auto pair = static_cast<std::uint32_t>(below.nodes.size());
        node.first = pair;
        node.leaf = 0;
        const BuildJob left_job = children.left_job(job), right_job = children.right_job(job);
        BvhNode left, right;
        left.set_box(left_job.extent.box.box());
        right.set_box(right_job.extent.box.box());
        below.nodes.resize(pair + 2);
        SubtreeSize l, r;
        if (left_first(left, right)) {
            l = build(left_job, left, below);
            r = build(right_job, right, below);
        } else {
            r = build(right_job, right, below);
            l = build(left_job, left, below);
        }
        below.nodes[pair] = left;
        below.nodes[pair + 1] = right;
        return joined(l, r);
    }

    static bool one_type(std::span<const Reference> refs) {
        for (const Reference& r : refs) {
            if (r.type() != refs.front().type()) return false;
        }
        return true;
    }

    // False if the node is to be a leaf.
    bool split(const BuildJob& job, Children& children) {
        const std::span<const Reference> refs = memory_->references(job);
        if (job.count == 1) return false;
        const bool mixed = settings_.single_type_leaves && !one_type(refs);
        const bool may_be_leaf = job.count <= settings_.max_leaf && !mixed;
        // Halving down to single references takes this many levels more.
        const auto levels = static_cast<std::uint32_t>(std::bit_width(job.count - 1));
        if (may_be_leaf && settings_.fill_leaves) return false;
        if (job.depth + levels >= kMaxTreeDepth) {
            if (may_be_leaf) return false;
            split_at_median(job, refs, children);
            return true;
        }
        const double area = job.extent.box.half_area();
        const double leaf_cost = settings_.primitive_cost * area * job.count;
        const auto cost = [&](const SplitSides& s) {
            return settings_.node_cost * area + settings_.primitive_cost * s.cost;
        };

        const ObjectSplit object = find_object_split(refs, job.extent, settings_);
        const bool may_cut = job.count >= kFewestToCut && job.capacity > job.count;
        if (may_cut && (!object.exists() || half_area_of_overlap(object.left_box, object.right_box) >
                                                settings_.alpha * root_area_)) {
            const SpatialSplit spatial =
                find_spatial_split(source_, refs, job.extent.box, job.capacity, object.cost, settings_);
            if (spatial.exists() && !(may_be_leaf && leaf_cost <= cost(spatial))) {
                children = memory_->divide(job, spatial);
                partition_by_plane(source_, refs, job.extent.box, spatial, settings_.unsplitting,
                                   children.left, children.right);
                if (children.left.count > 0 && children.right.count > 0) return true;
            }
        }
        if (may_be_leaf && (!object.exists() || leaf_cost <= cost(object))) return false;
        if (object.exists()) {
            children = memory_->divide(job, object);
            partition_by_center(refs, job.extent, object, children.left, children.right);
        } else if (mixed) {
            split_by_type(job, refs, children);
        } else {
            split_at_median(job, refs, children);
        }
        return true;
    }

    void split_at_median(const BuildJob& job, std::span<const Reference> refs, Children& children) {
        children = memory_->divide(job, {.left = job.count / 2, .right = job.count - job.count / 2});
        partition_at_median(refs, job.extent, children.left, children.right);
    }

    void split_by_type(const BuildJob& job, std::span<const Reference> refs, Children& children) {
        std::uint32_t first = 0;
        for (const Reference& r : refs) first += r.type() == refs.front().type();
        children = memory_->divide(job, {.left = first, .right = job.count - first});
        partition_by_type(refs, children.left, children.right);
    }

    const Source& source_;
    const SbvhSettings settings_;
    const BuildProgress& callback_;
    ProgressReporter* progress_ = nullptr;
    BuildMemory* memory_ = nullptr;
    float root_area_ = 0;
};

template <PrimitiveSource Source>
Tree build_sbvh(const Source& source, const SbvhSettings& settings, const BuildProgress& progress) {
    return SbvhBuilder<Source>(source, settings, progress).build();
}

}  // namespace ctpbench
