// The compact stage: keeps the indices of paths that go on, in order. Two passes over blocks of the index
// buffer, count and scatter, with an exclusive scan of the counts between them (the backend's).
#pragma once

#include <cstring>

#include "reorder.h"
#include "select.h"
#include "wavefront.h"

namespace ctpbench {

inline constexpr Selector kGoesOn{1, 1};  // the fates whose path goes on

struct CompactCountKernel {
    const std::uint8_t* fates;
    std::uint32_t count;
    std::uint32_t* block_counts;

    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, count);
        block_counts[block] = count_selected(fates + range.begin, range.end - range.begin, kGoesOn);
    }
};

struct CompactScatterKernel {
    const std::uint8_t* fates;
    const std::uint32_t* index;
    std::uint32_t count;
    const std::uint32_t* block_offsets;
    std::uint32_t* compacted;

    // By way of a buffer: what is written beyond the last one must not reach the next block's entries.
    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, count);
        std::uint32_t kept[kChunk + kSelectSlack], out = block_offsets[block];
        for (std::uint32_t begin = range.begin; begin < range.end; begin += kChunk) {
            const std::uint32_t end = range.end - begin < kChunk ? range.end : begin + kChunk;
            std::uint32_t n[1] = {0};
            copy_selected<1>(index + begin, fates + begin, end - begin, {kGoesOn}, {kept}, n);
            std::memcpy(compacted + out, kept, n[0] * sizeof(std::uint32_t));
            out += n[0];
        }
    }

private:
    static constexpr std::uint32_t kChunk = 1024;  // fits the first-level cache
};

}  // namespace ctpbench
