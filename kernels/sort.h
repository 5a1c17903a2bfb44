// The sort stage: a counting sort (Knuth, TAOCP vol. 3, Sec. 5.2) of the index buffer by shade key. Blocks
// count their keys, an exclusive scan over (key, block) turns counts into places, blocks scatter: parallel
// throughout, stable, and the same for any number of threads.
#pragma once

#include <cstring>

#include "material_words.h"
#include "reorder.h"
#include "select.h"

namespace ctpbench {

CTP_INLINE Selector selector_of(std::uint32_t key) { return {0xff, static_cast<std::uint8_t>(key)}; }

struct SortCountKernel {
    const std::uint8_t* keys;
    std::uint32_t count;
    std::uint32_t blocks;
    std::uint32_t* block_counts;  // [key][block]

    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, count);
        for (std::uint32_t key = 0; key < kShadeKeys; ++key)
            block_counts[key * blocks + block] =
                count_selected(keys + range.begin, range.end - range.begin, selector_of(key));
    }
};

struct SortScatterKernel {
    const std::uint8_t* keys;
    const std::uint32_t* index;
    std::uint32_t count;
    std::uint32_t blocks;
    const std::uint32_t* block_offsets;  // [key][block]
    std::uint32_t* sorted;

    // By way of a run per key, which fits the first-level cache: stores to a few ends in memory would wait
    // for each other's counters.
    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, count);
        std::uint32_t runs[kShadeKeys][kChunk + kSelectSlack], out[kShadeKeys];
        std::uint32_t* ends[kShadeKeys];
        Selector selectors[kShadeKeys];
        for (std::uint32_t key = 0; key < kShadeKeys; ++key) {
            out[key] = block_offsets[key * blocks + block];
            ends[key] = runs[key], selectors[key] = selector_of(key);
        }
        for (std::uint32_t begin = range.begin; begin < range.end; begin += kChunk) {
            const std::uint32_t end = range.end - begin < kChunk ? range.end : begin + kChunk;
            std::uint32_t n[kShadeKeys] = {};
            copy_selected(index + begin, keys + begin, end - begin, selectors, ends, n);
            for (std::uint32_t key = 0; key < kShadeKeys; ++key) {
                std::memcpy(sorted + out[key], runs[key], n[key] * sizeof(std::uint32_t));
                out[key] += n[key];
            }
        }
    }

private:
    static constexpr std::uint32_t kChunk = 1024;
};

}  // namespace ctpbench
