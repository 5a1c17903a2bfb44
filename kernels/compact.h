// The compact stage: keeps the indices of paths that go on, in order. Two passes over blocks of the index
// buffer, count and scatter, with an exclusive scan of the counts between them (the backend's).
#pragma once

#include "wavefront.h"

namespace ctpbench {

inline constexpr std::uint32_t kCompactBlock = 4096;

struct CompactCountKernel {
    HitColumns hits;
    const std::uint32_t* index;
    std::uint32_t count;
    std::uint32_t* block_counts;

    CTP_HD void operator()(std::uint32_t block) const {
        const std::uint32_t begin = block * kCompactBlock;
        const std::uint32_t end = count - begin < kCompactBlock ? count : begin + kCompactBlock;
        std::uint32_t alive = 0;
        for (std::uint32_t i = begin; i < end; ++i) alive += hits.primitive[index[i]] != kNoPrimitive;
        block_counts[block] = alive;
    }
};

struct CompactScatterKernel {
    HitColumns hits;
    const std::uint32_t* index;
    std::uint32_t count;
    const std::uint32_t* block_offsets;
    std::uint32_t* compacted;

    CTP_HD void operator()(std::uint32_t block) const {
        const std::uint32_t begin = block * kCompactBlock;
        const std::uint32_t end = count - begin < kCompactBlock ? count : begin + kCompactBlock;
        std::uint32_t out = block_offsets[block];
        for (std::uint32_t i = begin; i < end; ++i)
            if (hits.primitive[index[i]] != kNoPrimitive) compacted[out++] = index[i];
    }
};

}  // namespace ctpbench
