// Queues instead of a sort: intersect appends each path to the queue of the material type it hit, and shading
// works through the queues with a loop per type, keeping the paths that go on. No path is sorted or
// compacted. The queues' segments are taken one by one, all types of one before the next, while what the
// paths of a segment share is in a cache.
#pragma once

#include "typed_materials.h"

namespace ctpbench {

struct ShadeQueues {
    static constexpr const char* name = "queues";
    static constexpr PathOrder order = PathOrder::queued;
    using Layout = TypedMaterialArrays;
    using View = TypedMaterialArrays::View;

    template <class Offset>
    struct Kernel {
        View materials;
        ShadeBuffers io;
        PathQueues queues;
        std::uint32_t *survivors, *survivor_counts, *dropped_counts;

        CTP_HD void operator()(std::uint32_t segment) const {
            std::uint32_t* kept = survivors + segment * kSegment;
            std::uint32_t n = 0, dropped = 0;
            for_each_type(Materials{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                const std::uint32_t* slots = queues.segment(material_type<T>, segment);
                const std::uint32_t count = queues.counts[segment].of[material_type<T>];
                for (std::uint32_t i = 0; i < count; ++i) {
                    const PathFate fate = materials.template of<T>().template shade<Offset>(io, slots[i]);
                    kept[n] = slots[i];
                    n += goes_on(static_cast<std::uint8_t>(fate));
                    dropped += fate == PathFate::dropped;
                }
            });
            const std::uint32_t* missed = queues.segment(kMissKey, segment);
            for (std::uint32_t i = 0; i < queues.counts[segment].of[kMissKey]; ++i) shade_miss(io, missed[i]);
            survivor_counts[segment] = n;
            dropped_counts[segment] = dropped;
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
