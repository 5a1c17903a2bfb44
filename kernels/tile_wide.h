// As tile.h, for more keys than fit one word: a counter for each key and thread of a tile.
#pragma once

#include "tile.h"

namespace ctpbench {

struct WideTileInput {
    const std::uint8_t* keys_of;  // by entry, each below `keys`
    const std::uint32_t* count;   // how many entries there are
    std::uint32_t* places;        // [key][tile], tiles being those of *count: counts, then where they begin
    std::uint32_t keys;           // at most kMaxShadeKeys

    CTP_INLINE std::uint32_t tiles() const { return tile_count(*count); }
    // Where the thread's entries end; they begin at `first`.
    CTP_INLINE std::uint32_t end(std::uint32_t first) const {
        return first < *count ? (*count - first < kTileItems ? *count : first + kTileItems) : first;
    }
};

struct WideTileCount {
    WideTileInput in;

    struct Shared {
        std::uint32_t counts[kMaxShadeKeys];
    };
    struct Thread {};
    static constexpr std::uint32_t threads = kTileThreads, phases = 3;
    static_assert(kMaxShadeKeys <= threads);

    CTP_INLINE bool idle(std::uint32_t tile) const { return tile >= in.tiles(); }
    template <std::uint32_t phase>
    CTP_INLINE void run(std::uint32_t tile, std::uint32_t t, Shared& s, Thread&) const {
        if constexpr (phase == 0) {
            if (t < in.keys) s.counts[t] = 0;
        } else if constexpr (phase == 1) {
            const std::uint32_t first = tile * kTile + t * kTileItems;
            for (std::uint32_t i = first; i < in.end(first); ++i) count(s.counts[in.keys_of[i]]);
        } else if (t < in.keys) {
            in.places[t * in.tiles() + tile] = s.counts[t];
        }
    }

private:
    CTP_INLINE static void count(std::uint32_t& counter) {
#if defined(__CUDA_ARCH__)
        atomicAdd(&counter, 1u);
#else
        ++counter;
#endif
    }
};

struct WideTileMove {
    WideTileInput in;
    const std::uint32_t* index;
    std::uint32_t* moved;

    // A key's counters are scanned in parts, by a thread each.
    static constexpr std::uint32_t parts = 4, part_threads = kTileThreads / parts;
    struct Shared {
        std::uint16_t counts[kMaxShadeKeys][kTileThreads];  // of each thread's entries; then where they go
        std::uint16_t sums[kMaxShadeKeys][parts];
        std::uint16_t begin[kMaxShadeKeys + 1];  // of each key's run in `entries`
        std::uint32_t place[kMaxShadeKeys];      // of the run in the output
        std::uint32_t entries[kTile];
        std::uint8_t keys_of[kTile];
    };
    struct Thread {};
    static constexpr std::uint32_t threads = kTileThreads, phases = 5;

    CTP_INLINE bool idle(std::uint32_t tile) const { return tile >= in.tiles(); }
    template <std::uint32_t phase>
    CTP_INLINE void run(std::uint32_t tile, std::uint32_t t, Shared& s, Thread&) const {
        const std::uint32_t first = tile * kTile + t * kTileItems;
        if constexpr (phase == 0) {
            for (std::uint32_t k = 0; k < in.keys; ++k) s.counts[k][t] = 0;
            for (std::uint32_t i = first; i < in.end(first); ++i) ++s.counts[in.keys_of[i]][t];
        } else if constexpr (phase == 1) {  // within each part: how many entries are before a thread's
            for (std::uint32_t job = t; job < in.keys * parts; job += threads) {
                std::uint16_t* counts = s.counts[job / parts] + job % parts * part_threads;
                std::uint16_t sum = 0;
                for (std::uint32_t i = 0; i < part_threads; ++i) {
                    const std::uint16_t counted = counts[i];
                    counts[i] = sum;
                    sum = static_cast<std::uint16_t>(sum + counted);
                }
                s.sums[job / parts][job % parts] = sum;
            }
        } else if constexpr (phase == 2) {
            if (t <= in.keys) {
                std::uint32_t begin = 0;
                for (std::uint32_t k = 0; k < t; ++k)
                    for (std::uint32_t p = 0; p < parts; ++p) begin += s.sums[k][p];
                s.begin[t] = static_cast<std::uint16_t>(begin);
                if (t < in.keys) s.place[t] = in.places[t * in.tiles() + tile];
            }
        } else if constexpr (phase == 3) {
            for (std::uint32_t i = first; i < in.end(first); ++i) {
                const std::uint32_t k = in.keys_of[i];
                std::uint32_t at = s.begin[k] + s.counts[k][t]++;
                for (std::uint32_t p = 0; p < t / part_threads; ++p) at += s.sums[k][p];
                s.entries[at] = index[i];
                s.keys_of[at] = static_cast<std::uint8_t>(k);
            }
        } else {
            for (std::uint32_t p = t; p < s.begin[in.keys]; p += threads) {
                const std::uint32_t k = s.keys_of[p];
                moved[s.place[k] + p - s.begin[k]] = s.entries[p];
            }
        }
    }
};

}  // namespace ctpbench
