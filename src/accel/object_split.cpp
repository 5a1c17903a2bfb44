#include "accel/object_split.h"

#include <array>

#include "accel/parallel.h"

namespace ctpbench {
namespace {

struct Bin {
    Bounds4 box = Bounds4::empty();
    std::uint32_t count = 0;
};

// Sweeps the planes between bins and keeps the best.
void sweep_bins(const Bin* bins, std::uint32_t count, int axis, ObjectSplit& best) {
    std::array<Bin, kMaxBins> right;
    Bin sum;
    for (std::uint32_t b = count; b-- > 1;) {
        sum.box.extend(bins[b].box);
        sum.count += bins[b].count;
        right[b] = sum;
    }
    Bin left;
    for (std::uint32_t b = 1; b < count; ++b) {
        left.box.extend(bins[b - 1].box);
        left.count += bins[b - 1].count;
        if (left.count == 0 || right[b].count == 0) continue;
        const auto sides = SplitSides::of(left.box, left.count, right[b].box, right[b].count);
        if (!sides.better_than(best)) continue;
        static_cast<SplitSides&>(best) = sides;
        best.axis = axis;
        best.first_right_bin = static_cast<int>(b);
        best.bins = count;
    }
}

void try_bins(std::span<const Reference> refs, const Extent& extent, int axis, std::uint32_t count,
              ObjectSplit& best) {
    const BinGrid grid(extent.centers.lo[axis], extent.centers.hi[axis], count);
    if (!grid.usable()) return;
    using Bins = std::array<Bin, kMaxBins>;
    const Bins bins = reduce_in_chunks<Bins>(
        refs.size(),
        [&](std::size_t begin, std::size_t end, Bins& out) {
            for (std::size_t i = begin; i < end; ++i) {
                Bin& bin = out[grid.bin(refs[i].center2()[axis])];
                bin.box.extend(refs[i].bounds());
                ++bin.count;
            }
        },
        [&](Bins& into, const Bins& from) {
            for (std::uint32_t b = 0; b < count; ++b) {
                into[b].box.extend(from[b].box);
                into[b].count += from[b].count;
            }
        });
    sweep_bins(bins.data(), count, axis, best);
}

void try_every_position(std::span<const Reference> refs, int axis, ObjectSplit& best) {
    std::array<std::uint8_t, kMaxBins> order;
    sort_by_center(refs, axis, order.data());
    const auto n = static_cast<std::uint32_t>(refs.size());
    std::array<Bounds4, kMaxBins> right;
    Bounds4 box = Bounds4::empty();
    for (std::uint32_t i = n; i-- > 1;) {
        box.extend(refs[order[i]].bounds());
        right[i] = box;
    }
    Bounds4 left = Bounds4::empty();
    for (std::uint32_t i = 1; i < n; ++i) {
        left.extend(refs[order[i - 1]].bounds());
        const auto sides = SplitSides::of(left, i, right[i], n - i);
        if (!sides.better_than(best)) continue;
        static_cast<SplitSides&>(best) = sides;
        best.axis = axis;
        best.rank = i;
        best.bins = 0;
    }
}

}  // namespace

void sort_by_center(std::span<const Reference> refs, int axis, std::uint8_t* order) {
    std::array<float, kMaxBins> key;
    for (std::size_t i = 0; i < refs.size(); ++i) {
        const float k = refs[i].center2()[axis];
        std::size_t at = i;
        for (; at > 0 && key[at - 1] > k; --at) {
            key[at] = key[at - 1];
            order[at] = order[at - 1];
        }
        key[at] = k;
        order[at] = static_cast<std::uint8_t>(i);
    }
}

ObjectSplit find_object_split(std::span<const Reference> refs, const Extent& extent,
                              const SbvhSettings& settings) {
    ObjectSplit best;
    const bool exact = refs.size() <= settings.sweep_below;
    for (int axis = 0; axis < 3; ++axis) {
        if (!settings.all_axes && axis != extent.centers.longest_axis()) continue;
        if (!(extent.centers.hi[axis] > extent.centers.lo[axis])) continue;
        if (exact) {
            try_every_position(refs, axis, best);
        } else {
            try_bins(refs, extent, axis, settings.object_bins, best);
        }
    }
    return best;
}

}  // namespace ctpbench
