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

// From one segment's counts to the next one's: whole cache lines, since neighbouring segments are filled by
// different threads.
CTP_INLINE std::uint32_t segment_stride(std::uint32_t keys) { return (keys + 15) / 16 * 16; }

struct PathQueues {
    std::uint32_t* slots = nullptr;   // [key][position]
    std::uint32_t* counts = nullptr;  // [segment][key]; all zero before the stage
    std::uint32_t capacity = 0;       // positions per key
    std::uint32_t stride = 0;         // of counts, from segment to segment

    CTP_INLINE void append(std::uint32_t key, [[maybe_unused]] std::uint32_t position,
                           std::uint32_t slot) const {
#if defined(__CUDA_ARCH__)
        slots[std::size_t{key} * capacity + next_place(counts + key)] = slot;
#else
        const std::uint32_t segment = position / kSegment;
        const std::uint32_t at = counts[std::size_t{segment} * stride + key]++;
        slots[std::size_t{key} * capacity + segment * kSegment + at] = slot;
#endif
    }
    CTP_INLINE const std::uint32_t* segment(std::uint32_t key, std::uint32_t segment) const {
        return slots + std::size_t{key} * capacity + segment * kSegment;
    }
    CTP_INLINE std::uint32_t count(std::uint32_t key, std::uint32_t segment) const {
        return counts[std::size_t{segment} * stride + key];
    }
};

}  // namespace ctpbench
