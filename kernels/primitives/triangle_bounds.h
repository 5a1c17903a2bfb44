// Bounds of a triangle, and of the part of it inside a box.
#pragma once

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

// Bounds of the triangle's parts between two planes across an axis, along the other two: those that follow
// the axis in the cycle x, y, z. In float, to weigh splits by: not for containment. Straight-line code over
// float or a vector of floats, which takes several parts at once. Planes beyond the triangle give garbage.
template <int axis>
class TriangleSlicer {
public:
    explicit TriangleSlicer(const TriangleShape& t) {
        const Vec3 corners[3] = {t.a, t.b, t.c};
        const float x[3] = {t.a[axis], t.b[axis], t.c[axis]};
        // Ranks along the axis: sorting by branches would mispredict every other one.
        const int rank_a = (x[0] > x[1]) + (x[0] > x[2]), rank_b = (x[1] >= x[0]) + (x[1] > x[2]);
        int at[3];
        at[rank_a] = 0, at[rank_b] = 1, at[3 - rank_a - rank_b] = 2;
        const Vec3 &first = corners[at[0]], &middle = corners[at[1]], &last = corners[at[2]];
        first_ = first[axis], middle_ = middle[axis], last_ = last[axis];
        const float per_whole = inverse(last_ - first_), per_first = inverse(middle_ - first_),
                    per_last = inverse(last_ - middle_);
        for (int k = 0; k < 2; ++k) {
            const int other = (axis + 1 + k) % 3;
            Edges& e = edges_[k];
            e.first = first[other], e.middle = middle[other], e.last = last[other];
            e.whole_slope = (e.last - e.first) * per_whole;
            e.first_slope = (e.middle - e.first) * per_first;
            e.last_slope = (e.last - e.middle) * per_last;
        }
    }

    template <class T>
    CTP_INLINE void operator()(const T& from, const T& to, T (&lo)[2], T (&hi)[2]) const {
        const auto from_early = from < middle_, to_early = to < middle_;
        for (int k = 0; k < 2; ++k) {
            const Edges& e = edges_[k];
            const T p = e.first + e.whole_slope * (from - first_);
            const T q = e.last + e.whole_slope * (to - last_);
            const T u = from_early ? e.first + e.first_slope * (from - first_)
                                   : e.middle + e.last_slope * (from - middle_);
            const T v =
                to_early ? e.first + e.first_slope * (to - first_) : e.middle + e.last_slope * (to - middle_);
            // The middle corner, if it is between the planes: from_early and not to_early.
            const T m = from_early ? T(to_early ? v : T{} + e.middle) : u;
            const T pq = p < q ? p : q, uv = u < v ? u : v, PQ = p < q ? q : p, UV = u < v ? v : u;
            const T l = pq < uv ? pq : uv, h = PQ < UV ? UV : PQ;
            lo[k] = m < l ? m : l;
            hi[k] = h < m ? m : h;
        }
    }

private:
    static float inverse(float length) { return 1.0f / max(length, 1e-30f); }

    struct Edges {  // corners in order along the axis, and slopes of the edges between them
        float first, middle, last, whole_slope, first_slope, last_slope;
    };
    float first_, middle_, last_;
    Edges edges_[2];
};

template <int axis>
TriangleSlicer<axis> slicer(const TriangleShape& t) {
    return TriangleSlicer<axis>(t);
}

}  // namespace ctpbench
