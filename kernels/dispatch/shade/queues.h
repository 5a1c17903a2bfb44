// Queues instead of a sort: intersect appends each path to the queue of the material type it hit, and shading
// works through the queues with a loop per type, keeping the paths that go on. No path is sorted or
// compacted. The queues' segments are taken one by one, all types of one before the next, while what the
// paths of a segment share is in a cache.
#pragma once

#include "typed_materials.h"

namespace ctpbench {

// Of the paths of one segment, those that go on and how many samples were dropped.
struct SegmentOutcome {
    std::uint32_t* kept;
    std::uint32_t kept_count, dropped_count;
};

// All paths of one type in a segment. Apart, so that lists of types share it; a segment is worth a call.
template <class T, class Offset>
CTP_HD __attribute__((noinline)) void shade_segment(const TypedMaterials<T>& materials,
                                                    const ShadeBuffers& shared, const std::uint32_t* slots,
                                                    std::uint32_t count, SegmentOutcome& outcome) {
    const ShadeBuffers io = shared;  // on this thread's stack: no store aliases it
    std::uint32_t n = outcome.kept_count, dropped = outcome.dropped_count;
    std::uint32_t* kept = outcome.kept;
    for (std::uint32_t i = 0; i < count; ++i) {
        const PathFate fate = materials.template shade<Offset>(io, slots[i]);
        kept[n] = slots[i];
        n += goes_on(static_cast<std::uint8_t>(fate));
        dropped += fate == PathFate::dropped;
    }
    outcome.kept_count = n, outcome.dropped_count = dropped;
}

template <class Types>
struct ShadeQueues {
    static constexpr const char* name = "queues";
    static constexpr PathOrder order = PathOrder::queued;
    using Layout = TypedMaterialArrays<Types>;
    using View = typename Layout::View;

    template <class Offset>
    struct Kernel {
        View materials;
        ShadeBuffers io;
        PathQueues queues;
        std::uint32_t *survivors, *survivor_counts, *dropped_counts;

        CTP_HD void operator()(std::uint32_t segment) const {
            SegmentOutcome outcome{survivors + segment * kSegment, 0, 0};
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                shade_segment<T, Offset>(materials.template of<T>(), io,
                                         queues.segment(index_of<T, Types>, segment),
                                         queues.count(index_of<T, Types>, segment), outcome);
            });
            const std::uint32_t miss = io.words.miss_key(), misses = queues.count(miss, segment);
            const std::uint32_t* missed = queues.segment(miss, segment);
            for (std::uint32_t i = 0; i < misses; ++i) shade_miss(io, missed[i]);
            survivor_counts[segment] = outcome.kept_count;
            dropped_counts[segment] = outcome.dropped_count;
        }
    };

    template <class Offset, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        for_each(
            work.segments,
            Kernel<Offset>{view, io, work.queues, work.survivors, work.survivor_counts, work.dropped_counts},
            1);
    }
};

}  // namespace ctpbench
