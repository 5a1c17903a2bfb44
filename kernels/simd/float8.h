// Eight floats, for the children of a node: their boxes are tested together, and those that are met go onto
// the ray's stack. How lanes are pressed together is where instruction sets differ.
#pragma once

#include <bit>
#include <cstdint>

#include "../interleaved/node.h"
#include "float4.h"

namespace ctpbench {

template <class Isa>
struct Float8 {
    float lane[8];

    Float8() = default;
    CTP_INLINE explicit Float8(float all) {
        for (float& l : lane) l = all;
    }
    CTP_INLINE static Float8 load(const float* p) {
        return each([&](int i) { return p[i]; });
    }
    CTP_INLINE friend Float8 min(Float8 a, Float8 b) {
        return each([&](int i) { return ctpbench::min(a.lane[i], b.lane[i]); });
    }
    CTP_INLINE friend Float8 max(Float8 a, Float8 b) {
        return each([&](int i) { return ctpbench::max(a.lane[i], b.lane[i]); });
    }
    CTP_INLINE friend Float8 fma(Float8 a, Float8 b, Float8 c) {
        return each([&](int i) { return ctpbench::fma(a.lane[i], b.lane[i], c.lane[i]); });
    }

private:
    template <class F>
    CTP_INLINE static Float8 each(F&& f) {
        Float8 r;
        for (int i = 0; i < 8; ++i) r.lane[i] = f(i);
        return r;
    }
};

// Writes the children whose near is not beyond their far, with their nears, in the order of the octant that
// `shift` stands for (3 bits each). Returns how many they are. There must be room for eight.
template <class Isa>
CTP_INLINE std::uint32_t push_children(const WideNode& node, Float8<Isa> near, Float8<Isa> far,
                                       std::uint32_t shift, std::uint32_t* words, float* nears) {
    std::uint32_t n = 0;
    for (std::uint32_t i = 0; i < kWide; ++i) {
        const std::uint32_t child = node.order[i] >> shift & 7u;
        words[n] = node.children[child];
        nears[n] = near.lane[child];
        n += near.lane[child] <= far.lane[child];
    }
    return n;
}

// Removes what lies beyond t from a stack of `count` entries, and returns how many stay. Both arrays are
// readable to the next multiple of eight.
template <class Isa>
CTP_INLINE std::uint32_t keep_near(std::uint32_t* words, float* nears, std::uint32_t count, float t) {
    std::uint32_t n = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool stays = nears[i] <= t;
        words[n] = words[i];
        nears[n] = nears[i];
        n += stays;
    }
    return n;
}

#if defined(__AVX2__)

template <class Isa>
requires(!std::is_same_v<Isa, ScalarIsa>) struct Float8<Isa> {
    __m256 v;

    Float8() = default;
    CTP_INLINE Float8(__m256 lanes) : v(lanes) {}
    CTP_INLINE explicit Float8(float all) : v(_mm256_set1_ps(all)) {}
    CTP_INLINE static Float8 load(const float* p) { return _mm256_load_ps(p); }
    CTP_INLINE friend Float8 min(Float8 a, Float8 b) { return _mm256_min_ps(a.v, b.v); }
    CTP_INLINE friend Float8 max(Float8 a, Float8 b) { return _mm256_max_ps(a.v, b.v); }
    CTP_INLINE friend Float8 fma(Float8 a, Float8 b, Float8 c) { return _mm256_fmadd_ps(a.v, b.v, c.v); }
};

// Which lanes come first, one byte each, for every mask of lanes to keep.
struct CompressTable {
    alignas(64) std::uint8_t lanes[256][8];
    constexpr CompressTable() : lanes{} {
        for (int mask = 0; mask < 256; ++mask)
            for (int i = 0, n = 0; i < 8; ++i)
                if (mask >> i & 1) lanes[mask][n++] = static_cast<std::uint8_t>(i);
    }
};

template <class Isa>
struct Compress8 {
    static constexpr CompressTable kTable{};

    // Stores the lanes of the mask next to each other; what comes after them up to eight is arbitrary.
    CTP_INLINE static void store(std::uint32_t mask, __m256i words, __m256 nears, std::uint32_t* to_words,
                                 float* to_nears) {
#if defined(__AVX512VL__)
        if constexpr (std::is_same_v<Isa, Avx512>) {
            const auto m = static_cast<__mmask8>(mask);
            // Straight to memory the same is many times slower on some processors.
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(to_words), _mm256_maskz_compress_epi32(m, words));
            _mm256_storeu_ps(to_nears, _mm256_maskz_compress_ps(m, nears));
            return;
        }
#endif
        const __m256i lanes =
            _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kTable.lanes[mask])));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to_words), _mm256_permutevar8x32_epi32(words, lanes));
        _mm256_storeu_ps(to_nears, _mm256_permutevar8x32_ps(nears, lanes));
    }
};

template <class Isa>
requires(!std::is_same_v<Isa, ScalarIsa>) CTP_INLINE std::uint32_t lanes_at_most(__m256 a, __m256 b) {
#if defined(__AVX512VL__)
    if constexpr (std::is_same_v<Isa, Avx512>) return _mm256_cmp_ps_mask(a, b, _CMP_LE_OQ);
#endif
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)));
}

template <class Isa>
requires(!std::is_same_v<Isa, ScalarIsa>) CTP_INLINE std::uint32_t
    push_children(const WideNode& node, Float8<Isa> near, Float8<Isa> far, std::uint32_t shift,
                  std::uint32_t* words, float* nears) {
    const auto* order_words = reinterpret_cast<const __m256i*>(node.order);
    const auto* children = reinterpret_cast<const __m256i*>(node.children);
    const __m256i order =
        _mm256_srl_epi32(_mm256_load_si256(order_words), _mm_cvtsi32_si128(static_cast<int>(shift)));
    const __m256 n = _mm256_permutevar8x32_ps(near.v, order);
    const std::uint32_t mask = lanes_at_most<Isa>(n, _mm256_permutevar8x32_ps(far.v, order));
    Compress8<Isa>::store(mask, _mm256_permutevar8x32_epi32(_mm256_load_si256(children), order), n, words,
                          nears);
    return static_cast<std::uint32_t>(std::popcount(mask));
}

template <class Isa>
requires(!std::is_same_v<Isa, ScalarIsa>) CTP_INLINE std::uint32_t
    keep_near(std::uint32_t* words, float* nears, std::uint32_t count, float t) {
    const __m256 limit = _mm256_set1_ps(t);
    std::uint32_t n = 0;
    for (std::uint32_t i = 0; i < count; i += 8) {
        const __m256 near = _mm256_loadu_ps(nears + i);
        const __m256i word = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(words + i));
        const std::uint32_t left = count - i;
        const std::uint32_t mask = lanes_at_most<Isa>(near, limit) & (left < 8 ? (1u << left) - 1 : 0xffu);
        Compress8<Isa>::store(mask, word, near, words + n, nears + n);
        n += static_cast<std::uint32_t>(std::popcount(mask));
    }
    return n;
}

#endif

}  // namespace ctpbench
