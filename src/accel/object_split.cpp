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
    sweep.keep(best);
    best.axis = axis;
    best.first_right_bin = static_cast<int>(sweep.position());
    best.bins = count;
}

void try_bins(std::span<const Reference> refs, const Extent& extent, std::uint32_t count, bool (&tried)[3],
              ObjectSplit& best) {
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
}

void try_every_position(std::span<const Reference> refs, int axis, ObjectSplit& best) {
    std::array<std::uint8_t, kMaxBins> order;
    sort_by_center(refs, axis, order.data());
    const auto n = static_cast<std::uint32_t>(refs.size());
    std::array<Bounds4, kMaxBins> boxes;
    for (std::uint32_t i = 0; i < n; ++i) boxes[i] = refs[order[i]].bounds();
    SplitSweep sweep(boxes.data(), n);
    for (std::uint32_t i = 1; i < n; ++i) sweep.try_next(i, n - i, best);
    if (!sweep.improved()) return;
    sweep.keep(best);
    best.axis = axis;
    best.rank = sweep.position();
    best.bins = 0;
}

}  // namespace

void sort_by_center(std::span<const Reference> refs, int axis, std::uint8_t* order) {
    // Each one's place is the number of those that come before it: no branch to mispredict.
    std::array<Float8, kMaxBins / 8> keys;
    const auto n = static_cast<int>(refs.size());
    for (int i = 0; i < n; ++i) keys[i / 8][i % 8] = refs[i].center2()[axis];
    for (int block = 0; 8 * block < n; ++block) {
        const Int8 self = Int8{0, 1, 2, 3, 4, 5, 6, 7} + 8 * block;
        Int8 place = {};
        for (int i = 0; i < n; ++i) {
            const float key = keys[i / 8][i % 8];
            place -= (keys[block] > key) | ((keys[block] == key) & (self > i));
        }
        for (int k = 0; k < 8 && 8 * block + k < n; ++k)
            order[place[k]] = static_cast<std::uint8_t>(8 * block + k);
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
    if (refs.size() > settings.sweep_below) {
        try_bins(refs, extent, settings.object_bins, tried, best);
        return best;
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (tried[axis]) try_every_position(refs, axis, best);
    }
    return best;
}

}  // namespace ctpbench
