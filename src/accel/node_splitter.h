// What becomes of a node: the best of an object split, a spatial split and staying a leaf.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "accel/build_memory.h"
#include "accel/object_split.h"
#include "accel/partition.h"
#include "accel/reference.h"
#include "accel/sbvh.h"
#include "accel/spatial_split.h"

namespace ctpbench {

template <PrimitiveSource Source>
class NodeSplitter {
public:
    NodeSplitter(const Source& source, const SbvhSettings& settings, float root_area)
        : source_(source), settings_(settings), root_area_(root_area) {}

    // False if the node is to be a leaf.
    template <class Memory>
    bool split(const BuildJob& job, Memory& memory, Children& children) const {
        const std::span<const Reference> refs = job.references();
        if (job.count == 1) return false;
        const bool mixed = settings_.single_type_leaves && !one_type(refs);
        const bool may_be_leaf = job.count <= settings_.max_leaf && !mixed;
        // Halving down to single references takes this many levels more.
        const auto levels = static_cast<std::uint32_t>(std::bit_width(job.count - 1));
        if (may_be_leaf && settings_.fill_leaves) return false;
        if (job.depth + levels >= kMaxTreeDepth) {
            if (may_be_leaf) return false;
            split_at_median(job, refs, memory, children);
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
                children = memory.divide(job, spatial);
                partition_by_plane(source_, refs, job.extent.box, spatial, settings_.unsplitting,
                                   memory.pool(), children.left, children.right);
                if (children.left.count > 0 && children.right.count > 0) return true;
            }
        }
        if (may_be_leaf && (!object.exists() || leaf_cost <= cost(object))) return false;
        if (object.exists()) {
            children = memory.divide(job, object);
            partition_by_center(refs, job.extent, object, memory.pool(), children.left, children.right);
        } else if (mixed) {
            split_by_type(job, refs, memory, children);
        } else {
            split_at_median(job, refs, memory, children);
        }
        return true;
    }

private:
    // Spatial splits of fewer references are never the cheapest.
    static constexpr std::uint32_t kFewestToCut = 3;

    static bool one_type(std::span<const Reference> refs) {
        for (const Reference& r : refs) {
            if (r.type() != refs.front().type()) return false;
        }
        return true;
    }

    template <class Memory>
    void split_at_median(const BuildJob& job, std::span<const Reference> refs, Memory& memory,
                         Children& children) const {
        children = memory.divide(job, {.left = job.count / 2, .right = job.count - job.count / 2});
        partition_at_median(refs, job.extent, memory.pool(), children.left, children.right);
    }

    template <class Memory>
    void split_by_type(const BuildJob& job, std::span<const Reference> refs, Memory& memory,
                       Children& children) const {
        std::uint32_t first = 0;
        for (const Reference& r : refs) first += r.type() == refs.front().type();
        children = memory.divide(job, {.left = first, .right = job.count - first});
        partition_by_type(refs, memory.pool(), children.left, children.right);
    }

    const Source& source_;
    const SbvhSettings& settings_;
    const float root_area_;
};

}  // namespace ctpbench
