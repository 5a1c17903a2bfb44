// Three-component float vector and the scalar helpers that both host and device code use.
// Contraction is off for the whole project: a fused multiply-add appears only where it is written.
#pragma once

#include <cmath>
#include <cstdint>

#include "platform.h"

namespace ctpbench {

struct Vec3 {
    float x, y, z;

    CTP_INLINE float operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    CTP_INLINE float& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    CTP_INLINE bool operator==(const Vec3& o) const { return x == o.x && y == o.y && z == o.z; }
};

CTP_INLINE Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
CTP_INLINE Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
CTP_INLINE Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
CTP_INLINE Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
CTP_INLINE Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
CTP_INLINE Vec3 operator*(float s, Vec3 a) { return a * s; }

CTP_INLINE float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
CTP_INLINE Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
CTP_INLINE float length(Vec3 a) { return std::sqrt(dot(a, a)); }
CTP_INLINE Vec3 normalize(Vec3 a) { return a * (1.0f / length(a)); }

// Each is one min/max instruction. If either argument is NaN, x86's gives the second and a GPU's the other
// one: no result may depend on which.
CTP_INLINE float min(float a, float b) {
#if defined(__CUDA_ARCH__)
    return fminf(a, b);
#else
    return a < b ? a : b;
#endif
}
CTP_INLINE float max(float a, float b) {
#if defined(__CUDA_ARCH__)
    return fmaxf(a, b);
#else
    return a > b ? a : b;
#endif
}
CTP_INLINE Vec3 min(Vec3 a, Vec3 b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
CTP_INLINE Vec3 max(Vec3 a, Vec3 b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }

CTP_INLINE float fma(float a, float b, float c) { return std::fma(a, b, c); }
CTP_INLINE float absolute(float a) { return std::fabs(a); }
// For arithmetic that is written over a number type: a pack (simd/) has them too.
CTP_INLINE float square_root(float a) { return std::sqrt(a); }
CTP_INLINE float select(bool condition, float yes, float no) { return condition ? yes : no; }

}  // namespace ctpbench
