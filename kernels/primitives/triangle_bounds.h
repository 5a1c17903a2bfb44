// Bounds of a triangle, and of the part of it inside a box.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "../box.h"
#include "outward.h"
#include "shapes.h"

namespace ctpbench {

// Empty if a coordinate is NaN or infinite; min and max alone could let a NaN pass unnoticed.
inline Box bounds(const TriangleShape& t) {
    for (const Vec3& v : {t.a, t.b, t.c}) {
        if (!(v.x * 0.0f + v.y * 0.0f + v.z * 0.0f == 0.0f)) return Box::empty();
    }
    Box box{t.a, t.a};
    box.extend(t.b);
    box.extend(t.c);
    return box;
}

namespace detail {
// A convex polygon: a triangle cut by the sides of a box, two axes of three, has at most seven corners.
struct Polygon {
    DoublePoint corner[7];
    int size = 0;

    void push(const DoublePoint& p) { corner[size++] = p; }
};

// Where the line from p to q meets x[axis] = plane. Exact along the axis.
inline DoublePoint crossing(const DoublePoint& p, const DoublePoint& q, int axis, double plane) {
    const double s = (plane - p.at[axis]) / (q.at[axis] - p.at[axis]);
    DoublePoint r;
    for (int i = 0; i < 4; ++i) r.at[i] = p.at[i] + s * (q.at[i] - p.at[i]);
    r.at[axis] = plane;
    return r;
}

inline bool between(double plane, double p, double q) {
    return (p < plane && plane < q) || (q < plane && plane < p);
}

// Visits the corners of the polygon's part with lo <= x[axis] <= hi, in order around it.
template <class Visit>
void for_each_corner_within(const Polygon& polygon, int axis, double lo, double hi, const Visit& visit) {
    for (int i = 0; i < polygon.size; ++i) {
        const DoublePoint& p = polygon.corner[i];
        const DoublePoint& q = polygon.corner[i + 1 < polygon.size ? i + 1 : 0];
        const double from = p.at[axis], to = q.at[axis];
        if (from >= lo && from <= hi) visit(p);
        const double first = from < to ? lo : hi, second = from < to ? hi : lo;
        if (between(first, from, to)) visit(crossing(p, q, axis, first));
        if (between(second, from, to)) visit(crossing(p, q, axis, second));
    }
}
}  // namespace detail

// Contains every point of the triangle inside the box, and lies in the box. Cut in double, since cutting
// in float loses hits; the box is widened by the rounding error first, so that a triangle which only
// touches it is not lost either.
inline Box clip(const TriangleShape& t, const Box& box) {
    const Box whole = bounds(t);
    const Vec3 reach = max(-whole.lo, whole.hi);
    const double slack = max(max(reach.x, reach.y), reach.z) * 0x1p-49;
    detail::Polygon polygons[2], *polygon = polygons, *next = polygons + 1;
    for (const Vec3& v : {t.a, t.b, t.c}) polygon->push(DoublePoint::of(v));
    // The axis to cut along last needs the corners' bounds, but no polygon.
    int last = -1;
    const auto cut = [&](const auto& visit) {
        detail::for_each_corner_within(*polygon, last, box.lo[last] - slack, box.hi[last] + slack, visit);
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (whole.lo[axis] >= box.lo[axis] && whole.hi[axis] <= box.hi[axis]) continue;
        if (last >= 0) {
            next->size = 0;
            cut([&](const DoublePoint& p) { next->push(p); });
            std::swap(polygon, next);
        }
        last = axis;
    }
    if (last < 0) return whole;
    DoubleBox bounds;
    cut([&](const DoublePoint& p) { bounds.extend(p); });
    return bounds.rounded_outward(slack, intersection(box, whole));
}

// Bounds of the triangle's parts between each two successive planes across the axis, from the segments
// in which the planes cut it. In float, to weigh splits by: not for containment.
inline void chop(TriangleShape t, int axis, std::span<const float> planes, Box* pieces) {
    if (t.b[axis] < t.a[axis]) std::swap(t.a, t.b);
    if (t.c[axis] < t.b[axis]) std::swap(t.b, t.c);
    if (t.b[axis] < t.a[axis]) std::swap(t.a, t.b);
    const float a = t.a[axis], b = t.b[axis], c = t.c[axis];
    if (a == c) {
        std::fill_n(pieces, planes.size() - 1, bounds(t));
        return;
    }
    const Vec3 ac = (t.c - t.a) * (1.0f / (c - a));
    const Vec3 ab = (t.b - t.a) * (1.0f / (b - a));
    const Vec3 bc = (t.c - t.b) * (1.0f / (c - b));
    const auto cross_section = [&](float plane) -> Box {
        if (plane <= a) return {t.a, t.a};
        if (plane >= c) return {t.c, t.c};
        const Vec3 p = t.a + ac * (plane - a);
        const Vec3 q = plane < b ? t.a + ab * (plane - a) : t.b + bc * (plane - b);
        return {min(p, q), max(p, q)};
    };
    Box from = cross_section(planes[0]);
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
        const Box to = cross_section(planes[i + 1]);
        Box piece = from;
        piece.extend(to);
        if (b >= planes[i] && b <= planes[i + 1]) piece.extend(t.b);
        pieces[i] = piece;
        from = to;
    }
}

}  // namespace ctpbench
