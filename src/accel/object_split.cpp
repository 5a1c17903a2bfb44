#include "accel/object_split.h"

#include <array>

#include "accel/parallel.h"

namespace ctpbench {
namespace {

struct Bins {
    Bounds4 box[3][kMaxBins];
    std::uint32_t count[3][kMaxBins];

    void clear(std::uint32_t bins) {
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(box[axis], bins, Bounds4::empty());
            std::fill_n(count[axis], bins, 0);
        }
    }
};

// Sweeps the planes between bins and keeps the best.
void sweep_bins(const Bins& bins, std::uint32_t count, int axis, std::uint32_t n, ObjectSplit& best) {
    SplitSweep sweep(bins.box[axis], count);
    std::uint32_t left = 0;
    for (std::uint32_t b = 1; b < count; ++b) {
        left += bins.count[axis][b - 1];
        sweep.try_next(left, n - left, best);
    }
    if (!sweep.improved()) return;
    best.axis = axis;
    best.first_right_bin = static_cast<int>(sweep.position());
    best.bins = count;
}

void try_bins(std::span<const Reference> refs, const Extent& extent, std::uint32_t count,
              const bool (&tried)[3], ObjectSplit& best) {
    const BinGrids grids(extent.centers, count);
    const Bins bins = reduce_in_chunks<Bins>(
        refs.size(),
        [&](std::size_t begin, std::size_t end, Bins& out) {
            out.clear(count);
            for (const Reference& r : refs.subspan(begin, end - begin)) {
                const Int4 at = grids.bin(r.center2());
                for (int axis = 0; axis < 3; ++axis) {
                    if (!tried[axis]) continue;
                    out.box[axis][at[axis]].extend(r.bounds());
                    ++out.count[axis][at[axis]];
                }
            }
        },
        [&](Bins& into, const Bins& from) {
            for (int axis = 0; axis < 3; ++axis) {
                for (std::uint32_t b = 0; b < count; ++b) {
                    into.box[axis][b].extend(from.box[axis][b]);
                    into.count[axis][b] += from.count[axis][b];
                }
            }
        });
    for (int axis = 0; axis < 3; ++axis) {
        if (tried[axis] && grids.usable(axis))
            sweep_bins(bins, count, axis, static_cast<std::uint32_t>(refs.size()), best);
    }
    if (!best.exists()) return;
    best.set_boxes(bins.box[best.axis], count, static_cast<std::uint32_t>(best.first_right_bin));
}

void try_every_position(std::span<const Reference> refs, const bool (&tried)[3], ObjectSplit& best) {
    const auto n = static_cast<std::uint32_t>(refs.size());
    CenterOrder order;
    sort_by_center(refs, order);
    std::array<Bounds4, kMaxBins> boxes[3];
    for (int axis = 0; axis < 3; ++axis) {
        if (!tried[axis]) continue;
        for (std::uint32_t i = 0; i < n; ++i) boxes[axis][i] = refs[order[axis][i]].bounds();
        SplitSweep sweep(boxes[axis].data(), n);
        for (std::uint32_t i = 1; i < n; ++i) sweep.try_next(i, n - i, best);
        if (sweep.improved()) {
            best.axis = axis;
            best.rank = sweep.position();
        }
        if (n == 2) break;  // the same along all axes
    }
    if (!best.exists()) return;
    best.bins = 0;
    best.set_boxes(boxes[best.axis].data(), n, best.rank);
}

}  // namespace

void sort_by_center(std::span<const Reference> refs, CenterOrder& order) {
    // Each one's place is the number of those that come before it, here along three axes at once: without
    // a branch to mispredict.
    std::array<Float4, kMaxBins> center;
    std::array<Int4, kMaxBins> place;
    const auto n = static_cast<int>(refs.size());
    for (int j = 0; j < n; ++j) {
        const Float4 c = refs[j].center2();
        Int4 before = Int4{} + j;
        for (int i = 0; i < j; ++i) {
            const Int4 swapped = center[i] > c;  // -1 if so
            place[i] -= swapped;
            before += swapped;
        }
        center[j] = c;
        place[j] = before;
    }
    for (int i = 0; i < n; ++i) {
        for (int axis = 0; axis < 3; ++axis) order[axis][place[i][axis]] = static_cast<std::uint8_t>(i);
    }
}

ObjectSplit find_object_split(std::span<const Reference> refs, const Extent& extent,
                              const SbvhSettings& settings) {
    ObjectSplit best;
    bool tried[3];
    for (int axis = 0; axis < 3; ++axis) {
        tried[axis] = (settings.all_axes || axis == extent.centers.longest_axis()) &&
                      extent.centers.hi[axis] > extent.centers.lo[axis];
    }
    if (!(tried[0] || tried[1] || tried[2])) return best;
    if (refs.size() > settings.sweep_below) {
        try_bins(refs, extent, settings.object_bins, tried, best);
    } else {
        try_every_position(refs, tried, best);
    }
    return best;
}

}  // namespace ctpbench
