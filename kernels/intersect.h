// The intersect stage: one functor per pass over the active rays. A strategy supplies the traversal.
#pragma once

#include "methods/bundles.h"
#include "path_queues.h"
#include "wavefront.h"

namespace ctpbench {

// What the stage leaves for the next one beside the hits: a key per position for those who sort, or paths
// in queues. Of the two at most one is asked for; both tests are the same for every ray.
struct HitKeys {
    MaterialWords words{};
    std::uint8_t* keys = nullptr;  // by position
    PathQueues queues{};

    CTP_INLINE void record(std::uint32_t position, std::uint32_t slot, const Hit& hit) const {
        if (keys != nullptr)
            keys[position] = static_cast<std::uint8_t>(words.key_of(hit));
        else if (queues.slots != nullptr)
            queues.append(words.key_of(hit), position, slot);
    }
};

// What every pass reads and writes: `index[i]` is the slot of the i-th active ray.
struct IntersectBuffers {
    RayColumns rays;
    HitColumns hits;
    const std::uint32_t* index;
    std::uint32_t count;
    float extent;  // largest absolute coordinate of the scene's bounds
    HitKeys keys{};
    const std::uint32_t* segment_counts = nullptr;  // null: the index is dense; else entries of each segment
    std::uint32_t segments = 0;
    // By slot, the primitive that the ray leaves out; null: no ray leaves out any. Of use to methods that
    // exclude.
    const std::uint32_t* excluded = nullptr;
};

// Where there is nothing to hit.
struct MissKernel {
    IntersectBuffers io;

    CTP_INLINE void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Hit miss = no_hit(io.rays.load(slot));
        io.hits.store(slot, miss);
        io.keys.record(i, slot, miss);
    }
};

template <class Methods>
CTP_INLINE std::uint32_t excluded_by([[maybe_unused]] const IntersectBuffers& io,
                                     [[maybe_unused]] std::uint32_t slot) {
    if constexpr (Methods::excludes)
        if (io.excluded != nullptr) return io.excluded[slot];
    return kNoPrimitive;
}

// Traversal: trivially copyable, with closest_hit(const RayContext<Methods>&, Hit&) const. The call is not
// forced inline: GCC's code for the loop around it is up to 7 % slower.
template <class Methods, class Traversal>
struct IntersectKernel {
    static constexpr bool float64 = Methods::float64;

    Traversal traversal;
    IntersectBuffers io;

    CTP_HD void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Ray ray = io.rays.load(slot);
        const RayContext<Methods> context(ray, io.extent, excluded_by<Methods>(io, slot));
        Hit hit = no_hit(ray);
        traversal.closest_hit(context, hit);
        io.hits.store(slot, hit);
        io.keys.record(i, slot, hit);
    }
};

// A pass after the first: the closest t so far bounds the search if it is carried over; else the search
// starts afresh, and the nearer hit is kept. Which of the two is the same for all rays.
template <class Methods, class Traversal>
struct LaterPassKernel {
    static constexpr bool float64 = Methods::float64;

    Traversal traversal;
    IntersectBuffers io;
    bool carry_t;

    CTP_HD void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Ray ray = io.rays.load(slot);
        const RayContext<Methods> context(ray, io.extent, excluded_by<Methods>(io, slot));
        Hit hit = carry_t ? io.hits.load(slot) : no_hit(ray);
        traversal.closest_hit(context, hit);
        if (!carry_t) {
            const Hit before = io.hits.load(slot);
            if (before.primitive != kNoPrimitive && !before.accepts(hit.t, hit.primitive)) hit = before;
        }
        io.hits.store(slot, hit);
        io.keys.record(i, slot, hit);
    }
};

}  // namespace ctpbench
