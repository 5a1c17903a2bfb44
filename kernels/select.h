// Counting and copying the entries of a list that a byte beside each selects: the inner loops of sorting and
// compacting. AVX-512 compresses sixteen entries at a time where the compiler may use it; the other body
// writes every entry and moves the cursor past those selected, so that nothing is mispredicted.
#pragma once

#include <cstdint>

#include "platform.h"

#if defined(__AVX512BW__) && defined(__AVX512VL__) && !defined(__CUDACC__)
#define CTP_COMPRESS 1
#include <immintrin.h>
#endif

namespace ctpbench {

// Selects the bytes that equal `value` in the bits of `mask`.
struct Selector {
    std::uint8_t mask, value;

    CTP_INLINE std::uint32_t selects(std::uint8_t byte) const { return (byte & mask) == value; }
};

CTP_INLINE std::uint32_t count_selected(const std::uint8_t* bytes, std::uint32_t n, Selector selector) {
    std::uint32_t count = 0, i = 0;
#if defined(CTP_COMPRESS)
    const __m512i mask = _mm512_set1_epi8(static_cast<char>(selector.mask));
    const __m512i value = _mm512_set1_epi8(static_cast<char>(selector.value));
    for (; i + 64 <= n; i += 64) {
        const __m512i v = _mm512_and_si512(_mm512_loadu_si512(bytes + i), mask);
        count += static_cast<std::uint32_t>(__builtin_popcountll(_mm512_cmpeq_epi8_mask(v, value)));
    }
#endif
    for (; i < n; ++i) count += selector.selects(bytes[i]);
    return count;
}

// How many entries past the last one copied may be overwritten.
inline constexpr std::uint32_t kSelectSlack = 16;

// Copies the entries of each selector to the end of its run: out[s] + counts[s], which goes up. A run needs
// room for n more entries and the slack.
template <std::uint32_t Selectors>
CTP_INLINE void copy_selected(const std::uint32_t* entries, const std::uint8_t* bytes, std::uint32_t n,
                              const Selector (&selectors)[Selectors], std::uint32_t* const (&out)[Selectors],
                              std::uint32_t (&counts)[Selectors]) {
    std::uint32_t i = 0;
#if defined(CTP_COMPRESS)
    for (; i + 16 <= n; i += 16) {
        const __m512i v = _mm512_loadu_si512(entries + i);
        const __m128i b = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + i));
        for (std::uint32_t s = 0; s < Selectors; ++s) {
            const __m128i masked = _mm_and_si128(b, _mm_set1_epi8(static_cast<char>(selectors[s].mask)));
            const __mmask16 chosen =
                _mm_cmpeq_epi8_mask(masked, _mm_set1_epi8(static_cast<char>(selectors[s].value)));
            _mm512_storeu_si512(out[s] + counts[s], _mm512_maskz_compress_epi32(chosen, v));
            counts[s] += static_cast<std::uint32_t>(__builtin_popcount(chosen));
        }
    }
#endif
    for (; i < n; ++i)
        for (std::uint32_t s = 0; s < Selectors; ++s) {
            out[s][counts[s]] = entries[i];
            counts[s] += selectors[s].selects(bytes[i]);
        }
}

}  // namespace ctpbench
