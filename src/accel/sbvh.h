// Builds a binary tree with spatial splits: Stich, Friedrich, Dietrich, "Spatial Splits in Bounding
// Volume Hierarchies", HPG 2009. The same input and settings give the same tree, bit for bit, whatever
// the number of threads; oneTBB's current arena decides how many there are.
//
// This header declares; sbvh_builder.h defines. Include that one only to build over a source of your own.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "accel/tree.h"
#include "kernels/box.h"
#include "kernels/bvh.h"

namespace ctpbench {

struct SbvhSettings {
    std::uint32_t object_bins = 32;
    std::uint32_t spatial_bins = 32;
    bool all_axes = true;            // try splits along every axis, else along the longest alone
    std::uint32_t sweep_below = 32;  // nodes of at most this many references try every object split, and
                                     // no more spatial splits than references (but eight)
    float node_cost = 1.0f;          // of visiting an inner node, in the unit of primitive_cost
    float primitive_cost = 1.0f;
    std::uint32_t max_leaf = 4;       // references in a leaf, never exceeded
    bool fill_leaves = false;         // stop at max_leaf references, even if a split would cost less
    float alpha = 1e-5f;              // a spatial split is tried if the children of the best object split
                                      // overlap in more than this share of the root's area
    bool unsplitting = true;          // put a straddling reference on one side where that is cheaper
    float reference_budget = 2.0f;    // references at most, as a multiple of the primitives
    bool single_type_leaves = false;  // a leaf holds one type, which its leaf word names

    static SbvhSettings paper();    // as the paper's library built its trees
    static SbvhSettings quality();  // fewest steps of a single ray that we know how to get

    // Throws Error with the field, its value and the allowed range.
    void validate() const;
};

// Primitives to build over, numbered from 0. All members are called from many threads at once.
template <class S>
concept PrimitiveSource = requires(const S& source, std::uint32_t i, const Box& box) {
    { source.size() } -> std::convertible_to<std::size_t>;
    { source.bounds(i) } -> std::same_as<Box>;
    // Contains every point of primitive i inside the box, and lies in the box; empty if there are none.
    { source.clip(i, box) } -> std::same_as<Box>;
    // Calls its argument with primitive i, a shape of which slicer(shape, axis) cuts parts between planes.
    {
        source.with_shape(i, [](const auto&) {})
        } -> std::same_as<void>;
    { source.ref(i) } -> std::same_as<PrimitiveRef>;
};

// Called with the share of the work done, from 0 to 1: from any one thread at a time, never going back,
// several times a second.
using BuildProgress = std::function<void(double fraction)>;

// Primitives whose bounds are empty, NaN, infinite or beyond kMaxCoordinate are left out and counted in
// Tree::skipped. No primitives give an empty tree.
template <PrimitiveSource Source>
Tree build_sbvh(const Source& source, const SbvhSettings& settings, const BuildProgress& progress = {});

// Surface areas of boxes within this distance of the origin do not overflow a float.
inline constexpr float kMaxCoordinate = 1.8e18f;

}  // namespace ctpbench
