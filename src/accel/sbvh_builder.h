// The builder that sbvh.h declares: large nodes are split level by level, each in parallel; what is below
// small ones is built by one task each, depth first.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "accel/build_memory.h"
#include "accel/build_progress.h"
#include "accel/node_splitter.h"
#include "accel/parallel.h"
#include "accel/reference.h"
#include "accel/sbvh.h"
#include "accel/sides.h"
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
                const NodeSplitter<Source> splitter(source_, settings_, root.extent.box.half_area());
                splitter_ = &splitter;
                const std::unique_ptr<TreePart> parts = build_parts(root);
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
    // Subtrees of at most this many references are built by one task.
    static constexpr std::uint32_t kTask = 4096;

    // All primitives, as the references of the root.
    BuildJob gather(BuildMemory& memory, std::uint32_t capacity) {
        BuildJob root{memory.references(0), 0, capacity, 1, 0, 0, {}};
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

    // The top of the tree, down to the subtrees that are built by one task.
    std::unique_ptr<TreePart> build_parts(const BuildJob& root) {
        struct Open {
            BuildJob job;
            TreePart* part;
            Children children;
        };
        auto all = std::make_unique<TreePart>();
        std::vector<Open> level{{root, all.get(), {}}};
        for (int from = 0; !level.empty(); from = 1 - from) {
            LevelMemory memory(memory_->references(1 - from));
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, level.size(), 1),
                [&](const auto& range) {
                    for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        Open& open = level[i];
                        if (open.job.count <= kTask || !splitter_->split(open.job, memory, open.children)) {
                            build_task(open.job, *open.part);
                            continue;
                        }
                        open.part->root.set_box(open.job.extent.box.box());
                        open.part->root.leaf = 0;
                        open.part->left = std::make_unique<TreePart>();
                        open.part->right = std::make_unique<TreePart>();
                    }
                },
                tbb::simple_partitioner());
            std::vector<Open> next;
            for (const Open& open : level) {
                if (open.part->left == nullptr) continue;
                next.push_back({open.children.left_job(open.job), open.part->left.get(), {}});
                next.push_back({open.children.right_job(open.job), open.part->right.get(), {}});
            }
            level = std::move(next);
        }
        measure(*all);
        return all;
    }

    // Sets the sizes of the parts that have parts.
    static void measure(TreePart& part) {
        if (part.left == nullptr) return;
        measure(*part.left);
        measure(*part.right);
        part.size = joined(part.left->size, part.right->size);
    }

    void build_task(const BuildJob& job, TreePart& part) {
        TaskMemory& memory = memory_->task();
        part.size = build(memory.begin(job), part.root, memory);
        memory_->pack(memory, part);
        progress_->add(job.capacity);
    }

    SubtreeSize build(const BuildJob& job, BvhNode& node, TaskMemory& below) {
        node.set_box(job.extent.box.box());
        Children children;
        if (!splitter_->split(job, below, children)) {
            const std::span<const Reference> refs = job.references();
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

    const Source& source_;
    const SbvhSettings settings_;
    const BuildProgress& callback_;
    ProgressReporter* progress_ = nullptr;
    BuildMemory* memory_ = nullptr;
    const NodeSplitter<Source>* splitter_ = nullptr;
};

template <PrimitiveSource Source>
Tree build_sbvh(const Source& source, const SbvhSettings& settings, const BuildProgress& progress) {
    return SbvhBuilder<Source>(source, settings, progress).build();
}

}  // namespace ctpbench
