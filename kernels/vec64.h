// Three-component float64 vector, for tests that promote what they read. Scenes and nodes stay in float32.
#pragma once

#include "vec.h"

namespace ctpbench {

struct Vec3d {
    double x, y, z;
};

CTP_INLINE Vec3d promote(Vec3 v) { return {double{v.x}, double{v.y}, double{v.z}}; }
CTP_INLINE Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
CTP_INLINE Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
CTP_INLINE Vec3d operator*(double s, Vec3d a) { return {a.x * s, a.y * s, a.z * s}; }
CTP_INLINE double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
CTP_INLINE Vec3d cross(Vec3d a, Vec3d b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace ctpbench
