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

// For so many keys a pass over the bytes for each of them is cheaper than a counter for each entry, which
// waits for the entry before it with the same key.
inline constexpr std::uint32_t kFewKeys = 8;

struct SortCountKernel {
    const std::uint8_t* keys;
    std::uint32_t count;
    std::uint32_t blocks;
    std::uint32_t* block_counts;  // [key][block]
    std::uint32_t key_count;

    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, count);
        if (key_count <= kFewKeys) {
            for (std::uint32_t key = 0; key < key_count; ++key)
                block_counts[key * blocks + block] =
                    count_selected(keys + range.begin, range.end - range.begin, selector_of(key));
            return;
        }
        std::uint32_t counts[kMaxShadeKeys] = {};
        for (std::uint32_t i = range.begin; i < range.end; ++i) ++counts[keys[i]];
        for (std::uint32_t key = 0; key < key_count; ++key) block_counts[key * blocks + block] = counts[key];
    }
};

// What both ways of scattering need.
struct SortScatter {
    const std::uint8_t* keys;
    const std::uint32_t* index;
    std::uint32_t count;
    std::uint32_t blocks;
    const std::uint32_t* block_offsets;  // [key][block]
    std::uint32_t* sorted;
};

// By way of a run per key, which fits the first-level cache: stores to a few ends in memory would wait for
// each other's counters.
template <std::uint32_t key_count>
struct SortScatterKernel {
    SortScatter sort;

    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, sort.count);
        std::uint32_t runs[key_count][kChunk + kSelectSlack], out[key_count];
        std::uint32_t* ends[key_count];
        Selector selectors[key_count];
        for (std::uint32_t key = 0; key < key_count; ++key) {
            out[key] = sort.block_offsets[key * sort.blocks + block];
            ends[key] = runs[key], selectors[key] = selector_of(key);
        }
        for (std::uint32_t begin = range.begin; begin < range.end; begin += kChunk) {
            const std::uint32_t end = range.end - begin < kChunk ? range.end : begin + kChunk;
            std::uint32_t n[key_count] = {};
            copy_selected(sort.index + begin, sort.keys + begin, end - begin, selectors, ends, n);
            for (std::uint32_t key = 0; key < key_count; ++key) {
                std::memcpy(sort.sorted + out[key], runs[key], n[key] * sizeof(std::uint32_t));
                out[key] += n[key];
            }
        }
    }

private:
    static constexpr std::uint32_t kChunk = 1024;
};

// Entry by entry: with many keys, neighbours seldom wait for the same counter.
struct SortScatterManyKernel {
    SortScatter sort;
    std::uint32_t key_count;

    CTP_HD void operator()(std::uint32_t block) const {
        const BlockRange range = block_range(block, sort.count);
        std::uint32_t out[kMaxShadeKeys];
        for (std::uint32_t key = 0; key < key_count; ++key)
            out[key] = sort.block_offsets[key * sort.blocks + block];
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            sort.sorted[out[sort.keys[i]]++] = sort.index[i];
    }
};

}  // namespace ctpbench
