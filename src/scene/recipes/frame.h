// An affine frame: where a part's own axes and origin lie in its parent.
#pragma once

#include "kernels/vec.h"
#include "scene/recipes/circle.h"

namespace ctpbench::recipe {

struct Frame {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    Vec3 origin{0, 0, 0};

    Vec3 vector(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
    Vec3 point(Vec3 p) const { return origin + vector(p); }
};

inline Frame operator*(const Frame& outer, const Frame& inner) {
    return {outer.vector(inner.x), outer.vector(inner.y), outer.vector(inner.z), outer.point(inner.origin)};
}

// Moved to `origin`, turned about the vertical (counter-clockwise seen from above) and scaled.
inline Frame at(Vec3 origin, float turns = 0.0f, float scale = 1.0f) {
    const auto [c, s] = circle(turns);
    return {Vec3{c, 0, -s} * scale, Vec3{0, scale, 0}, Vec3{s, 0, c} * scale, origin};
}

// The same, turned about its x axis: positive turns tip y towards z.
inline Frame tipped(Vec3 origin, float turns) {
    const auto [c, s] = circle(turns);
    return {{1, 0, 0}, {0, c, s}, {0, -s, c}, origin};
}

// y along the unit vector `up`; the turn about it is arbitrary but fixed.
inline Frame standing(Vec3 origin, Vec3 up) {
    const Vec3 helper = absolute(up.x) < 0.7f ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    const Vec3 z = normalize(cross(helper, up));
    return {cross(up, z), up, z, origin};
}

}  // namespace ctpbench::recipe
