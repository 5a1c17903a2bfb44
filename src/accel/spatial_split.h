// Spatial splits (Stich et al. 2009, section 4.1): a plane cuts the node's box, and a reference that
// straddles it goes to both sides, clipped. Candidates are the planes between equal bins; every reference
// is chopped into the bins that it overlaps.
#pragma once

#include <array>
#include <span>

#include "accel/object_split.h"
#include "accel/parallel.h"
#include "accel/reference.h"
#include "accel/sbvh.h"

namespace ctpbench {

// The reference's part between two planes; empty() if there is none.
template <PrimitiveSource Source>
Bounds4 clip_reference(const Source& source, const Reference& r, int axis, float from, float to) {
    Box cell = r.bounds().box();
    cell.lo[axis] = max(cell.lo[axis], from);
    cell.hi[axis] = min(cell.hi[axis], to);
    if (cell.lo[axis] > cell.hi[axis]) return Bounds4::empty();
    const Box part = source.clip(r.primitive(), cell);
    if (part.is_empty()) return Bounds4::empty();
    return Reference::make(part, 0, 0).bounds();
}

struct SpatialSplit : SplitSides {
    int axis = 0;
    int first_right_bin = 0;
    std::uint32_t bins = 0;

    BinGrid grid(const Bounds4& node) const { return {node.lo[axis], node.hi[axis], bins}; }
};

namespace detail {
struct SpatialBin {
    Bounds4 box = Bounds4::empty();
    std::uint32_t entries = 0, exits = 0;  // references that begin and end here
};
using SpatialBins = std::array<SpatialBin, kMaxBins>;

template <PrimitiveSource Source>
void chop(const Source& source, const Reference& r, int axis, const BinGrid& grid, SpatialBins& bins) {
    const int first = grid.bin(r.lo[axis]);
    const int last = grid.end_bin(r.hi[axis], first);
    ++bins[first].entries;
    ++bins[last].exits;
    if (first == last) {
        bins[first].box.extend(r.bounds());
        return;
    }
    std::array<float, kMaxBins + 1> planes;
    std::array<Box, kMaxBins> pieces;
    const int count = last - first + 1;
    for (int k = 1; k < count; ++k) planes[k] = grid.plane(first + k);
    planes[0] = r.lo[axis];
    planes[count] = r.hi[axis];
    source.chop(r.primitive(), axis, std::span<const float>(planes.data(), count + 1), pieces.data());
    for (int k = 0; k < count; ++k) {
        const Bounds4 piece = Reference::make(pieces[k], 0, 0).bounds();
        const Bounds4 inside{upper(piece.lo, r.lo), lower(piece.hi, r.hi)};
        if (!inside.is_empty()) bins[first + k].box.extend(inside);
    }
}

inline void sweep_spatial_bins(const SpatialBins& bins, std::uint32_t count, int axis, std::uint32_t n,
                               std::uint32_t capacity, SpatialSplit& best) {
    std::array<Bounds4, kMaxBins> right;
    Bounds4 box = Bounds4::empty();
    for (std::uint32_t b = count; b-- > 1;) {
        box.extend(bins[b].box);
        right[b] = box;
    }
    Bounds4 left = Bounds4::empty();
    std::uint32_t left_count = 0, right_count = n;
    for (std::uint32_t b = 1; b < count; ++b) {
        left.extend(bins[b - 1].box);
        left_count += bins[b - 1].entries;
        right_count -= bins[b - 1].exits;
        if (left_count == 0 || right_count == 0) continue;
        if (left_count == n && right_count == n) continue;  // tells nothing apart
        if (std::size_t{left_count} + right_count > capacity) continue;
        const auto sides = SplitSides::of(left, left_count, right[b], right_count);
        if (!sides.better_than(best)) continue;
        static_cast<SplitSides&>(best) = sides;
        best.axis = axis;
        best.first_right_bin = static_cast<int>(b);
        best.bins = count;
    }
}
}  // namespace detail

// Best by the surface area heuristic whose two sides together hold at most `capacity` references.
template <PrimitiveSource Source>
SpatialSplit find_spatial_split(const Source& source, std::span<const Reference> refs, const Bounds4& node,
                                std::size_t capacity, const SbvhSettings& settings) {
    using detail::SpatialBins;
    SpatialSplit best;
    std::uint32_t count = settings.spatial_bins;
    // Planes in excess of the references hardly pay.
    if (refs.size() <= settings.sweep_below) {
        count = std::min(count, std::max(8u, static_cast<std::uint32_t>(refs.size())));
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!settings.all_axes && axis != node.longest_axis()) continue;
        const BinGrid grid(node.lo[axis], node.hi[axis], count);
        if (!grid.usable()) continue;
        const SpatialBins bins = reduce_in_chunks<SpatialBins>(
            refs.size(),
            [&](std::size_t begin, std::size_t end, SpatialBins& out) {
                for (std::size_t i = begin; i < end; ++i) detail::chop(source, refs[i], axis, grid, out);
            },
            [&](SpatialBins& into, const SpatialBins& from) {
                for (std::uint32_t b = 0; b < count; ++b) {
                    into[b].box.extend(from[b].box);
                    into[b].entries += from[b].entries;
                    into[b].exits += from[b].exits;
                }
            });
        detail::sweep_spatial_bins(bins, count, axis, static_cast<std::uint32_t>(refs.size()),
                                   static_cast<std::uint32_t>(capacity), best);
    }
    return best;
}

}  // namespace ctpbench
