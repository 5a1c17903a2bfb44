// As many floats as a register holds, one for each ray of a packet. The operations are those of Float4, and
// like those the scalar ones on every lane.
#pragma once

#include "float4.h"

namespace ctpbench {

// Where an instruction set has no wide registers there are no packets: a width of 0.
template <class Isa>
struct Lanes {
    static constexpr std::uint32_t width = 0;
};

#if defined(__AVX2__)

template <>
struct Lanes<Avx2> {
    static constexpr std::uint32_t width = 8;
    struct Mask {
        __m256 lanes;
        CTP_INLINE friend Mask operator&(Mask a, Mask b) { return {_mm256_and_ps(a.lanes, b.lanes)}; }
        CTP_INLINE friend Mask operator!(Mask a) {
            return {_mm256_xor_ps(a.lanes, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))};
        }
        CTP_INLINE std::uint32_t bits() const {
            return static_cast<std::uint32_t>(_mm256_movemask_ps(lanes));
        }
    };
    __m256 v;

    Lanes() = default;
    CTP_INLINE Lanes(__m256 lanes) : v(lanes) {}
    CTP_INLINE explicit Lanes(float all) : v(_mm256_set1_ps(all)) {}
    CTP_INLINE static Lanes load(const float* p) { return _mm256_loadu_ps(p); }
    CTP_INLINE void store(float* p) const { _mm256_storeu_ps(p, v); }

    CTP_INLINE friend Lanes operator+(Lanes a, Lanes b) { return _mm256_add_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator-(Lanes a, Lanes b) { return _mm256_sub_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator*(Lanes a, Lanes b) { return _mm256_mul_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator/(Lanes a, Lanes b) { return _mm256_div_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator-(Lanes a) { return _mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f)); }
    CTP_INLINE friend Mask operator<(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
    CTP_INLINE friend Mask operator<=(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
    CTP_INLINE friend Mask operator==(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_EQ_OQ)}; }
    CTP_INLINE friend Lanes min(Lanes a, Lanes b) { return _mm256_min_ps(a.v, b.v); }
    CTP_INLINE friend Lanes max(Lanes a, Lanes b) { return _mm256_max_ps(a.v, b.v); }
    CTP_INLINE friend Lanes fma(Lanes a, Lanes b, Lanes c) { return _mm256_fmadd_ps(a.v, b.v, c.v); }
    CTP_INLINE friend Lanes absolute(Lanes a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v); }
    CTP_INLINE friend Lanes square_root(Lanes a) { return _mm256_sqrt_ps(a.v); }
    CTP_INLINE friend Lanes select(Mask m, Lanes yes, Lanes no) {
        return _mm256_blendv_ps(no.v, yes.v, m.lanes);
    }
};

#endif
#if defined(__AVX512F__) && defined(__AVX512DQ__)

template <>
struct Lanes<Avx512> {
    static constexpr std::uint32_t width = 16;
    struct Mask {
        __mmask16 lanes;
        CTP_INLINE friend Mask operator&(Mask a, Mask b) {
            return {static_cast<__mmask16>(a.lanes & b.lanes)};
        }
        CTP_INLINE friend Mask operator!(Mask a) { return {static_cast<__mmask16>(~a.lanes)}; }
        CTP_INLINE std::uint32_t bits() const { return lanes; }
    };
    __m512 v;

    Lanes() = default;
    CTP_INLINE Lanes(__m512 lanes) : v(lanes) {}
    CTP_INLINE explicit Lanes(float all) : v(_mm512_set1_ps(all)) {}
    CTP_INLINE static Lanes load(const float* p) { return _mm512_loadu_ps(p); }
    CTP_INLINE void store(float* p) const { _mm512_storeu_ps(p, v); }

    CTP_INLINE friend Lanes operator+(Lanes a, Lanes b) { return _mm512_add_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator-(Lanes a, Lanes b) { return _mm512_sub_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator*(Lanes a, Lanes b) { return _mm512_mul_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator/(Lanes a, Lanes b) { return _mm512_div_ps(a.v, b.v); }
    CTP_INLINE friend Lanes operator-(Lanes a) { return _mm512_xor_ps(a.v, _mm512_set1_ps(-0.0f)); }
    CTP_INLINE friend Mask operator<(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)}; }
    CTP_INLINE friend Mask operator<=(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)}; }
    CTP_INLINE friend Mask operator==(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_EQ_OQ)}; }
    CTP_INLINE friend Lanes min(Lanes a, Lanes b) { return _mm512_min_ps(a.v, b.v); }
    CTP_INLINE friend Lanes max(Lanes a, Lanes b) { return _mm512_max_ps(a.v, b.v); }
    CTP_INLINE friend Lanes fma(Lanes a, Lanes b, Lanes c) { return _mm512_fmadd_ps(a.v, b.v, c.v); }
    CTP_INLINE friend Lanes absolute(Lanes a) { return _mm512_andnot_ps(_mm512_set1_ps(-0.0f), a.v); }
    CTP_INLINE friend Lanes square_root(Lanes a) { return _mm512_sqrt_ps(a.v); }
    CTP_INLINE friend Lanes select(Mask m, Lanes yes, Lanes no) {
        return _mm512_mask_blend_ps(m.lanes, no.v, yes.v);
    }
};

#endif

}  // namespace ctpbench
