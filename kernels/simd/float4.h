// Four floats, for blocks of primitives. Each operation is the scalar one on every lane, rounded alike, so
// that arithmetic written over a number type gives the same bits in either.
#pragma once

#include "../vec.h"
#include "isa.h"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace ctpbench {

template <class Isa>
struct Mask4 {
    bool lane[4];

    CTP_INLINE friend Mask4 operator&(Mask4 a, Mask4 b) {
        return {
            {a.lane[0] && b.lane[0], a.lane[1] && b.lane[1], a.lane[2] && b.lane[2], a.lane[3] && b.lane[3]}};
    }
    CTP_INLINE friend Mask4 operator!(Mask4 a) { return {{!a.lane[0], !a.lane[1], !a.lane[2], !a.lane[3]}}; }
    // Bit i is lane i.
    CTP_INLINE std::uint32_t bits() const {
        return static_cast<std::uint32_t>(lane[0]) | static_cast<std::uint32_t>(lane[1]) << 1 |
               static_cast<std::uint32_t>(lane[2]) << 2 | static_cast<std::uint32_t>(lane[3]) << 3;
    }
};

template <class Isa>
struct Float4 {
    using Mask = Mask4<Isa>;
    float lane[4];

    Float4() = default;
    CTP_INLINE explicit Float4(float all) : lane{all, all, all, all} {}
    CTP_INLINE static Float4 load(const float* p) {
        return each([&](int i) { return p[i]; });
    }
    CTP_INLINE void store(float* p) const {
        for (int i = 0; i < 4; ++i) p[i] = lane[i];
    }

    CTP_INLINE friend Float4 operator+(Float4 a, Float4 b) {
        return each([&](int i) { return a.lane[i] + b.lane[i]; });
    }
    CTP_INLINE friend Float4 operator-(Float4 a, Float4 b) {
        return each([&](int i) { return a.lane[i] - b.lane[i]; });
    }
    CTP_INLINE friend Float4 operator*(Float4 a, Float4 b) {
        return each([&](int i) { return a.lane[i] * b.lane[i]; });
    }
    CTP_INLINE friend Float4 operator/(Float4 a, Float4 b) {
        return each([&](int i) { return a.lane[i] / b.lane[i]; });
    }
    CTP_INLINE friend Float4 operator-(Float4 a) {
        return each([&](int i) { return -a.lane[i]; });
    }
    CTP_INLINE friend Mask operator<(Float4 a, Float4 b) {
        return {{a.lane[0] < b.lane[0], a.lane[1] < b.lane[1], a.lane[2] < b.lane[2], a.lane[3] < b.lane[3]}};
    }
    CTP_INLINE friend Mask operator<=(Float4 a, Float4 b) {
        return {
            {a.lane[0] <= b.lane[0], a.lane[1] <= b.lane[1], a.lane[2] <= b.lane[2], a.lane[3] <= b.lane[3]}};
    }
    CTP_INLINE friend Mask operator==(Float4 a, Float4 b) {
        return {
            {a.lane[0] == b.lane[0], a.lane[1] == b.lane[1], a.lane[2] == b.lane[2], a.lane[3] == b.lane[3]}};
    }
    CTP_INLINE friend Float4 min(Float4 a, Float4 b) {
        return each([&](int i) { return ctpbench::min(a.lane[i], b.lane[i]); });
    }
    CTP_INLINE friend Float4 max(Float4 a, Float4 b) {
        return each([&](int i) { return ctpbench::max(a.lane[i], b.lane[i]); });
    }
    CTP_INLINE friend Float4 fma(Float4 a, Float4 b, Float4 c) {
        return each([&](int i) { return ctpbench::fma(a.lane[i], b.lane[i], c.lane[i]); });
    }
    CTP_INLINE friend Float4 absolute(Float4 a) {
        return each([&](int i) { return ctpbench::absolute(a.lane[i]); });
    }
    CTP_INLINE friend Float4 square_root(Float4 a) {
        return each([&](int i) { return ctpbench::square_root(a.lane[i]); });
    }
    CTP_INLINE friend Float4 select(Mask m, Float4 yes, Float4 no) {
        return each([&](int i) { return m.lane[i] ? yes.lane[i] : no.lane[i]; });
    }
    // The least lane, in all lanes. No lane is NaN.
    CTP_INLINE friend Float4 least(Float4 a) {
        return Float4(
            ctpbench::min(ctpbench::min(a.lane[0], a.lane[1]), ctpbench::min(a.lane[2], a.lane[3])));
    }
    CTP_INLINE float first() const { return lane[0]; }

private:
    template <class F>
    CTP_INLINE static Float4 each(F&& f) {
        Float4 r;
        for (int i = 0; i < 4; ++i) r.lane[i] = f(i);
        return r;
    }
};

#if defined(__AVX2__)

// AVX-512's masks would cost more than they save at this width.
template <class Isa>
requires(!std::is_same_v<Isa, ScalarIsa>) struct Mask4<Isa> {
    __m128 lanes;

    CTP_INLINE friend Mask4 operator&(Mask4 a, Mask4 b) { return {_mm_and_ps(a.lanes, b.lanes)}; }
    CTP_INLINE friend Mask4 operator!(Mask4 a) {
        return {_mm_xor_ps(a.lanes, _mm_castsi128_ps(_mm_set1_epi32(-1)))};
    }
    CTP_INLINE std::uint32_t bits() const { return static_cast<std::uint32_t>(_mm_movemask_ps(lanes)); }
};

template <class Isa>
requires(!std::is_same_v<Isa, ScalarIsa>) struct Float4<Isa> {
    using Mask = Mask4<Isa>;
    __m128 v;

    Float4() = default;
    CTP_INLINE Float4(__m128 lanes) : v(lanes) {}
    CTP_INLINE explicit Float4(float all) : v(_mm_set1_ps(all)) {}
    CTP_INLINE static Float4 load(const float* p) { return _mm_loadu_ps(p); }
    CTP_INLINE void store(float* p) const { _mm_storeu_ps(p, v); }

    CTP_INLINE friend Float4 operator+(Float4 a, Float4 b) { return _mm_add_ps(a.v, b.v); }
    CTP_INLINE friend Float4 operator-(Float4 a, Float4 b) { return _mm_sub_ps(a.v, b.v); }
    CTP_INLINE friend Float4 operator*(Float4 a, Float4 b) { return _mm_mul_ps(a.v, b.v); }
    CTP_INLINE friend Float4 operator/(Float4 a, Float4 b) { return _mm_div_ps(a.v, b.v); }
    CTP_INLINE friend Float4 operator-(Float4 a) { return _mm_xor_ps(a.v, _mm_set1_ps(-0.0f)); }
    CTP_INLINE friend Mask operator<(Float4 a, Float4 b) { return {_mm_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
    CTP_INLINE friend Mask operator<=(Float4 a, Float4 b) { return {_mm_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
    CTP_INLINE friend Mask operator==(Float4 a, Float4 b) { return {_mm_cmp_ps(a.v, b.v, _CMP_EQ_OQ)}; }
    CTP_INLINE friend Float4 min(Float4 a, Float4 b) { return _mm_min_ps(a.v, b.v); }
    CTP_INLINE friend Float4 max(Float4 a, Float4 b) { return _mm_max_ps(a.v, b.v); }
    CTP_INLINE friend Float4 fma(Float4 a, Float4 b, Float4 c) { return _mm_fmadd_ps(a.v, b.v, c.v); }
    CTP_INLINE friend Float4 absolute(Float4 a) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), a.v); }
    CTP_INLINE friend Float4 square_root(Float4 a) { return _mm_sqrt_ps(a.v); }
    CTP_INLINE friend Float4 select(Mask m, Float4 yes, Float4 no) {
        return _mm_blendv_ps(no.v, yes.v, m.lanes);
    }
    CTP_INLINE friend Float4 least(Float4 a) {
        const __m128 pairs = _mm_min_ps(a.v, _mm_permute_ps(a.v, 0b10110001));
        return _mm_min_ps(pairs, _mm_permute_ps(pairs, 0b01001110));
    }
    CTP_INLINE float first() const { return _mm_cvtss_f32(v); }
};

#endif

}  // namespace ctpbench
