// Bounds of a sphere, and of the part of its ball inside a box.
#pragma once

#include <cmath>
#include <cstddef>

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

// Bounds of the ball's parts between two planes across an axis, as TriangleSlicer has them of a triangle's.
template <int axis>
class SphereSlicer {
public:
    explicit SphereSlicer(const SphereShape& s)
        : along_(s.center[axis]),
          across_{s.center[(axis + 1) % 3], s.center[(axis + 2) % 3]},
          radius2_(s.radius * s.radius) {}

    template <class T>
    CTP_INLINE void operator()(const T& from, const T& to, T (&lo)[2], T (&hi)[2]) const {
        const T a = from - along_,
                b = along_ - to;  // how far the center is from either plane, on its outside
        const T gap = a > b ? a : b, outside = gap > 0.0f ? gap : T{};
        T reach = radius2_ - outside * outside;
        reach = reach > 0.0f ? reach : T{};
        take_roots(reach);
        for (int k = 0; k < 2; ++k) {
            lo[k] = across_[k] - reach;
            hi[k] = across_[k] + reach;
        }
    }

private:
    CTP_INLINE static void take_roots(float& x) { x = std::sqrt(x); }
    template <class T>
    CTP_INLINE static void take_roots(T& x) {
        for (std::size_t i = 0; i < sizeof(T) / sizeof(float); ++i) x[i] = std::sqrt(x[i]);
    }

    float along_, across_[2], radius2_;
};

template <int axis>
SphereSlicer<axis> slicer(const SphereShape& s) {
    return SphereSlicer<axis>(s);
}

}  // namespace ctpbench
