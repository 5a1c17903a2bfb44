// Sorting and compacting the index buffer on a GPU: a stable counting sort in three kernels. Tiles count
// their keys, a scan over (key, tile) turns counts into places, and tiles move their entries, ordered by key
// within a tile first so that they reach memory in runs. Every count stays on the device.
//
// A kernel is a block program: phases that each thread runs, with a barrier after each. A host runs the same
// phases thread by thread (backends/host_blocks.h), which is how they are tested without a GPU.
#pragma once

#include <cstdint>

#include "material_words.h"
#include "wavefront.h"

namespace ctpbench {

inline constexpr std::uint32_t kTileThreads = 256;
inline constexpr std::uint32_t kTileItems = 8;  // of a thread, consecutive
inline constexpr std::uint32_t kTile = kTileThreads * kTileItems;
inline constexpr std::uint32_t kTileSteps = 8;  // of a scan over a tile's threads
static_assert(1u << kTileSteps == kTileThreads);

CTP_INLINE std::uint32_t tile_count(std::uint32_t count) { return (count + kTile - 1) / kTile; }

// Counts of up to five keys in one word, 12 bits each: a tile holds 2048 entries. tile_wide.h is for more.
inline constexpr std::uint32_t kPackedKeys = 5;
struct PackedCounts {
    CTP_INLINE static std::uint64_t one(std::uint32_t key) { return std::uint64_t{1} << (12 * key); }
    CTP_INLINE static std::uint32_t of(std::uint64_t packed, std::uint32_t key) {
        return static_cast<std::uint32_t>(packed >> (12 * key)) & 0xfffu;
    }
};

// What a byte beside each entry stands for. `written` keys are moved; the rest is only counted.
template <std::uint32_t key_count>
struct ByShadeKey {
    static constexpr std::uint32_t keys = key_count, written = key_count;
    CTP_INLINE static std::uint32_t key(std::uint8_t byte) { return byte; }
};
struct ByFate {
    static constexpr std::uint32_t keys = 3, written = 1;
    CTP_INLINE static std::uint32_t key(std::uint8_t byte) {
        return byte == static_cast<std::uint8_t>(PathFate::goes_on)   ? 0
               : byte == static_cast<std::uint8_t>(PathFate::dropped) ? 1
                                                                      : 2;
    }
};

// The entries, as both kernels see them.
template <class By>
struct TileInput {
    static_assert(By::keys <= kPackedKeys);
    const std::uint8_t* bytes;
    const std::uint32_t* count;  // how many entries there are
    std::uint32_t* places;       // [key][tile], tiles being those of *count: counts, then where they begin

    CTP_INLINE std::uint32_t tiles() const { return tile_count(*count); }
    // Items past the end have no key.
    CTP_INLINE std::uint32_t key(std::uint32_t item) const {
        return item < *count ? By::key(bytes[item]) : By::keys;
    }
    CTP_INLINE std::uint64_t counts_of(std::uint32_t first) const {
        std::uint64_t counts = 0;
        for (std::uint32_t i = 0; i < kTileItems; ++i)
            if (const std::uint32_t k = key(first + i); k < By::keys) counts += PackedCounts::one(k);
        return counts;
    }
};

template <class By>
struct TileCount {
    TileInput<By> in;

    struct Shared {
        std::uint64_t counts[kTileThreads];
    };
    struct Thread {};
    static constexpr std::uint32_t threads = kTileThreads, phases = kTileSteps + 2;

    CTP_INLINE bool idle(std::uint32_t tile) const { return tile >= in.tiles(); }
    template <std::uint32_t phase>
    CTP_INLINE void run(std::uint32_t tile, std::uint32_t t, Shared& shared, Thread&) const {
        if constexpr (phase == 0) {
            shared.counts[t] = in.counts_of(tile * kTile + t * kTileItems);
        } else if constexpr (phase <= kTileSteps) {
            constexpr std::uint32_t half = kTileThreads >> phase;
            if (t < half) shared.counts[t] += shared.counts[t + half];
        } else if (t < By::keys) {
            in.places[t * in.tiles() + tile] = PackedCounts::of(shared.counts[0], t);
        }
    }
};

template <class By>
struct TileMove {
    TileInput<By> in;
    const std::uint32_t* index;
    std::uint32_t* moved;

    struct Shared {
        std::uint64_t sums[2][kTileThreads];
        std::uint32_t entries[kTile];
        std::uint32_t begin[By::keys + 1];  // of each key's run in `entries`
        std::uint32_t place[By::keys];      // of the run in the output
    };
    struct Thread {
        std::uint64_t own;
    };
    static constexpr std::uint32_t threads = kTileThreads, phases = kTileSteps + 4;

    CTP_INLINE bool idle(std::uint32_t tile) const { return tile >= in.tiles(); }
    template <std::uint32_t phase>
    CTP_INLINE void run(std::uint32_t tile, std::uint32_t t, Shared& s, Thread& mine) const {
        const std::uint32_t first = tile * kTile + t * kTileItems;
        if constexpr (phase == 0) {
            mine.own = in.counts_of(first);
            s.sums[0][t] = mine.own;
        } else if constexpr (phase <= kTileSteps) {  // Hillis & Steele 1986, back and forth
            constexpr std::uint32_t from = (phase + 1) % 2, reach = 1u << (phase - 1);
            s.sums[1 - from][t] = s.sums[from][t] + (t >= reach ? s.sums[from][t - reach] : 0);
        } else if constexpr (phase == kTileSteps + 1) {
            if (t <= By::keys) {
                const std::uint64_t all = s.sums[kTileSteps % 2][kTileThreads - 1];
                std::uint32_t begin = 0;
                for (std::uint32_t k = 0; k < t; ++k) begin += PackedCounts::of(all, k);
                s.begin[t] = begin;
                if (t < By::keys) s.place[t] = in.places[t * in.tiles() + tile];
            }
        } else if constexpr (phase == kTileSteps + 2) {
            std::uint64_t before = s.sums[kTileSteps % 2][t] - mine.own;
            for (std::uint32_t i = 0; i < kTileItems; ++i) {
                const std::uint32_t k = in.key(first + i);
                if (k < By::written) s.entries[s.begin[k] + PackedCounts::of(before, k)] = index[first + i];
                if (k < By::keys) before += PackedCounts::one(k);
            }
        } else {
            for (std::uint32_t p = t; p < s.begin[By::written]; p += kTileThreads) {
                std::uint32_t k = 0;
                while (p >= s.begin[k + 1]) ++k;
                moved[s.place[k] + p - s.begin[k]] = s.entries[p];
            }
        }
    }
};

// One block: turns the counts into places, in place, and says where each key's run begins.
struct TileScan {
    const std::uint32_t* count;  // of all entries
    std::uint32_t* places;       // [key][tile]
    std::uint32_t keys;          // at most kMaxShadeKeys
    std::uint32_t* offsets;      // [keys + 1]; the last is the number of entries

    static constexpr std::uint32_t threads = 1024, steps = 10, phases = steps + 3;
    static_assert(kMaxShadeKeys < threads);
    struct Shared {
        std::uint32_t sums[2][threads];
    };
    struct Thread {
        std::uint32_t own;
    };

    CTP_INLINE bool idle(std::uint32_t) const { return false; }
    template <std::uint32_t phase>
    CTP_INLINE void run(std::uint32_t, std::uint32_t t, Shared& s, Thread& mine) const {
        const std::uint32_t tiles = tile_count(*count), n = keys * tiles, share = (n + threads - 1) / threads;
        const std::uint32_t begin = t * share < n ? t * share : n,
                            end = n - begin < share ? n : begin + share;
        if constexpr (phase == 0) {
            mine.own = 0;
            for (std::uint32_t i = begin; i < end; ++i) mine.own += places[i];
            s.sums[0][t] = mine.own;
        } else if constexpr (phase <= steps) {
            constexpr std::uint32_t from = (phase + 1) % 2, reach = 1u << (phase - 1);
            s.sums[1 - from][t] = s.sums[from][t] + (t >= reach ? s.sums[from][t - reach] : 0);
        } else if constexpr (phase == steps + 1) {
            std::uint32_t place = s.sums[steps % 2][t] - mine.own;
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t counted = places[i];
                places[i] = place;
                place += counted;
            }
        } else if (t <= keys) {
            offsets[t] = t < keys && tiles > 0 ? places[t * tiles] : *count;
        }
    }
};

}  // namespace ctpbench
