// Queues of paths, one per shade key, that the intersect stage appends to. A queue lies in segments: paths at
// positions [s kSegment, (s + 1) kSegment) of the active list go to segment s of their queue. So a segment
// is appended to by one thread, in order, without atomics, and its order never varies.
//
// On a GPU the whole list is one segment, appended to in any order. What a path gathers does not depend on
// it.
#pragma once

#include "append.h"
#include "material_words.h"

namespace ctpbench {

inline constexpr std::uint32_t kSegment = 1024;

// Each on a cache line of its own: neighbouring segments are filled by different threads.
struct alignas(64) SegmentCounts {
    std::uint32_t of[kShadeKeys];
};

struct PathQueues {
    std::uint32_t* slots = nullptr;   // [key][position]
    SegmentCounts* counts = nullptr;  // [segment]; all zero before the stage
    std::uint32_t capacity = 0;       // positions per key

    CTP_INLINE void append(std::uint32_t key, [[maybe_unused]] std::uint32_t position,
                           std::uint32_t slot) const {
#if defined(__CUDA_ARCH__)
        slots[std::size_t{key} * capacity + next_place(&counts->of[key])] = slot;
#else
        const std::uint32_t segment = position / kSegment;
        const std::uint32_t at = counts[segment].of[key]++;
        slots[std::size_t{key} * capacity + segment * kSegment + at] = slot;
#endif
    }
    CTP_INLINE const std::uint32_t* segment(std::uint32_t key, std::uint32_t segment) const {
        return slots + std::size_t{key} * capacity + segment * kSegment;
    }
};

}  // namespace ctpbench
