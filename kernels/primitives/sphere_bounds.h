// Bounds of a sphere, and of the part of its ball inside a box.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "../box.h"
#include "outward.h"
#include "shapes.h"

namespace ctpbench {

// Empty for a negative or NaN radius.
inline Box bounds(const SphereShape& s) {
    if (!(s.radius >= 0.0f)) return Box::empty();
    Box box;
    for (int a = 0; a < 3; ++a) {
        box.lo[a] = step_below(static_cast<float>(double{s.center[a]} - double{s.radius}));
        box.hi[a] = step_above(static_cast<float>(double{s.center[a]} + double{s.radius}));
    }
    return box;
}

// Contains every point of the ball inside the box, and lies in the box. Along each axis the ball reaches
// as far as at the point of the box that is nearest to its center across the other two.
inline Box clip(const SphereShape& s, const Box& box) {
    const double r = s.radius;
    double gap[3];  // from the center to the box, along each axis
    double largest = r;
    for (int a = 0; a < 3; ++a) {
        const double c = s.center[a];
        const double below = box.lo[a] - c, above = c - box.hi[a];
        gap[a] = below > 0 ? below : above > 0 ? above : 0.0;
        largest = std::fabs(c) > largest ? std::fabs(c) : largest;
    }
    const double slack = largest * 0x1p-49;
    DoubleBox cut;
    for (int a = 0; a < 3; ++a) {
        const double u = gap[(a + 1) % 3], v = gap[(a + 2) % 3];
        // Of the radius and the slack together, since near the rim the square root magnifies errors.
        const double reach2 = (r + slack) * (r + slack) - (u * u + v * v);
        if (!(reach2 >= 0)) return Box::empty();
        const double reach = std::sqrt(reach2);
        cut.lo.at[a] = s.center[a] - reach;
        cut.hi.at[a] = s.center[a] + reach;
    }
    return cut.rounded_outward(slack, intersection(box, bounds(s)));
}

// Bounds of the ball's parts between each two successive planes across the axis. In float, to weigh splits
// by: not for containment.
inline void chop(const SphereShape& s, int axis, std::span<const float> planes, Box* pieces) {
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
        const float nearest = max(planes[i], min(planes[i + 1], s.center[axis])) - s.center[axis];
        const float reach = std::sqrt(max(0.0f, s.radius * s.radius - nearest * nearest));
        pieces[i] = {s.center - Vec3{reach, reach, reach}, s.center + Vec3{reach, reach, reach}};
        pieces[i].lo[axis] = planes[i];
        pieces[i].hi[axis] = planes[i + 1];
    }
}

}  // namespace ctpbench
