// The ways to distribute a node's references to its two children.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "accel/object_split.h"
#include "accel/reference.h"
#include "accel/sides.h"
#include "accel/spatial_split.h"

namespace ctpbench {

inline void partition_by_center(std::span<const Reference> refs, const Extent& extent,
                                const ObjectSplit& split, ReferencePool* pool, Side& left, Side& right) {
    if (split.bins == 0) {
        CenterOrder order;
        sort_by_center(refs, order);
        for (std::uint32_t i = 0; i < refs.size(); ++i)
            (i < split.rank ? left : right).put(refs[order[split.axis][i]]);
        return;
    }
    const BinGrid grid = split.grid(extent);
    partition(
        refs,
        [&](std::span<const Reference> part, auto& l, auto& r) {
            for (const Reference& ref : part) {
                (grid.bin(ref.center2()[split.axis]) < split.first_right_bin ? l : r).put(ref);
            }
        },
        pool, left, right);
}

// Half of the references to each side, by center along the longest axis, whatever the cost. The same
// primitive's parts may have equal centers, so ties fall as nth_element leaves them, which is the same in
// every run.
inline void partition_at_median(std::span<const Reference> refs, const Extent& extent, ReferencePool* pool,
                                Side& left, Side& right) {
    if (pool != nullptr) {
        left.out = pool->take(refs.size());
        right.out = left.out + refs.size() / 2;
    }
    const int axis = extent.centers.longest_axis();
    std::vector<Reference> sorted(refs.begin(), refs.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end(), [axis](const Reference& a, const Reference& b) {
        const float ca = a.center2()[axis], cb = b.center2()[axis];
        return ca != cb ? ca < cb : a.primitive() < b.primitive();
    });
    for (auto r = sorted.begin(); r != sorted.end(); ++r) (r < middle ? left : right).put(*r);
}

// References of the first one's type to the left.
inline void partition_by_type(std::span<const Reference> refs, ReferencePool* pool, Side& left, Side& right) {
    partition(
        refs,
        [type = refs.front().type()](std::span<const Reference> part, auto& l, auto& r) {
            for (const Reference& ref : part) (ref.type() == type ? l : r).put(ref);
        },
        pool, left, right);
}

// Decides for a reference across the plane: both sides, or one of them whole (Stich et al. 2009, section
// 4.4). Tracks the children as they would be if every reference still to come were split.
struct Unsplitter {
    Bounds4 left, right;
    std::uint32_t left_count, right_count;

    enum class Choice { split, left, right };
    Choice choose(const Bounds4& whole, const Bounds4& left_part, const Bounds4& right_part) {
        const Bounds4 l = left.united(left_part), r = right.united(right_part);
        const Bounds4 all_left = left.united(whole), all_right = right.united(whole);
        const double both = cost(l, left_count) + cost(r, right_count);
        const double only_left = cost(all_left, left_count) + cost(right, right_count - 1);
        const double only_right = cost(left, left_count - 1) + cost(all_right, right_count);
        if (only_left < both && only_left <= only_right && right_count > 1) {
            left = all_left;
            --right_count;
            return Choice::left;
        }
        if (only_right < both && left_count > 1) {
            right = all_right;
            --left_count;
            return Choice::right;
        }
        return Choice::split;
    }

private:
    static double cost(const Bounds4& b, std::uint32_t n) { return double{b.half_area()} * n; }
};

// Cuts the references at the plane. A side may come out empty; then the split was none.
template <PrimitiveSource Source>
void partition_by_plane(const Source& source, std::span<const Reference> refs, const Bounds4& node,
                        const SpatialSplit& split, bool unsplitting, ReferencePool* pool, Side& left,
                        Side& right) {
    const BinGrid grid = split.grid(node);
    const int axis = split.axis;
    const float plane = grid.plane(split.first_right_bin);
    partition(
        refs,
        [&](std::span<const Reference> part, auto& l, auto& r) {
            Unsplitter unsplitter{split.left_box, split.right_box, split.left, split.right};
            for (const Reference& ref : part) {
                const int first = grid.bin(ref.lo[axis]);
                if (first >= split.first_right_bin) {
                    r.put(ref);
                    continue;
                }
                if (grid.end_bin(ref.hi[axis], first) < split.first_right_bin) {
                    l.put(ref);
                    continue;
                }
                const Bounds4 in_left = clip_reference(source, ref, axis, ref.lo[axis], plane);
                const Bounds4 in_right = clip_reference(source, ref, axis, plane, ref.hi[axis]);
                if (in_right.is_empty()) {
                    l.put(ref);
                } else if (in_left.is_empty()) {
                    r.put(ref);
                } else {
                    const auto choice = unsplitting ? unsplitter.choose(ref.bounds(), in_left, in_right)
                                                    : Unsplitter::Choice::split;
                    if (choice == Unsplitter::Choice::left) {
                        l.put(ref);
                    } else if (choice == Unsplitter::Choice::right) {
                        r.put(ref);
                    } else {
                        l.put(ref.with(in_left));
                        r.put(ref.with(in_right));
                    }
                }
            }
        },
        pool, left, right);
}

}  // namespace ctpbench
