// Spatial splits (Stich et al. 2009, section 4.1): a plane cuts the node's box, and a reference that
// straddles it goes to both sides, clipped. Candidates are the planes between equal bins; every reference
// is chopped into the bins that it overlaps.
#pragma once

#include <array>
#include <span>

#include "accel/parallel.h"
#include "accel/plane_tally.h"
#include "accel/reference.h"
#include "accel/sbvh.h"
#include "accel/slices.h"
#include "accel/split_sweep.h"

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
// The cheapest of the candidates, if it costs less than `best`.
template <int axis, PrimitiveSource Source>
void try_candidates(const Source& source, std::span<const Reference> refs, const BinGrid& grid,
                    const Candidates& candidates, SpatialSplit& best) {
    const auto slices = reduce_in_chunks<Slices<axis>>(
        refs.size(),
        [&](std::size_t begin, std::size_t end, Slices<axis>& out) {
            out.clear(grid, candidates);
            for (const Reference& r : refs.subspan(begin, end - begin)) {
                const int first = grid.bin(r.lo[axis]), last = grid.end_bin(r.hi[axis], first);
                out.add(r, first, last, [&](const auto& use) {
                    source.with_shape(r.primitive(), [&](const auto& shape) { use(slicer<axis>(shape)); });
                });
            }
        },
        [](Slices<axis>& into, const Slices<axis>& from) { into.join(from); });
    std::array<Bounds4, kMaxBins> boxes;
    for (std::uint32_t s = 0; s < slices.count(); ++s) boxes[s] = slices.box(s);
    SplitSweep sweep(boxes.data(), slices.count());
    for (std::uint32_t i = 0; i < candidates.count; ++i)
        sweep.try_next(candidates.plane[i].left, candidates.plane[i].right, best);
    if (!sweep.improved()) return;
    best.set_boxes(boxes.data(), slices.count(), sweep.position());
    best.axis = axis;
    best.first_right_bin = candidates.plane[sweep.position() - 1].bin;
    best.bins = static_cast<std::uint32_t>(grid.last) + 1;
}
}  // namespace detail

// Best by the surface area heuristic whose two sides together hold at most `capacity` references, if it
// costs less than `below`.
template <PrimitiveSource Source>
SpatialSplit find_spatial_split(const Source& source, std::span<const Reference> refs, const Bounds4& node,
                                std::size_t capacity, double below, const SbvhSettings& settings) {
    std::uint32_t count = settings.spatial_bins;
    // Planes in excess of the references hardly pay.
    if (refs.size() <= settings.sweep_below) {
        count = std::min(count, std::max(8u, static_cast<std::uint32_t>(refs.size())));
    }
    const BinGrids grids(node, count);
    const auto tally = reduce_in_chunks<PlaneTally>(
        refs.size(),
        [&](std::size_t begin, std::size_t end, PlaneTally& out) {
            out.clear(count);
            for (const Reference& r : refs.subspan(begin, end - begin)) {
                const Int4 first = grids.bin(r.lo);
                out.add(r, first, grids.end_bin(r.hi, first));
            }
        },
        [&](PlaneTally& into, const PlaneTally& from) { into.join(from, count); });
    SpatialSplit best;
    best.cost = below;
    const auto try_axis = [&]<int axis>() {
        if (!grids.usable(axis) || !(settings.all_axes || axis == node.longest_axis())) return;
        const BinGrid grid(node.lo[axis], node.hi[axis], count);
        const auto candidates = tally.template candidates<axis>(
            node, grid, static_cast<std::uint32_t>(refs.size()), capacity, best.cost);
        if (candidates.count > 0) detail::try_candidates<axis>(source, refs, grid, candidates, best);
    };
    try_axis.template operator()<0>();
    try_axis.template operator()<1>();
    try_axis.template operator()<2>();
    return best;
}

}  // namespace ctpbench
