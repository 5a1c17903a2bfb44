#include "oracle/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ctpbench {
namespace {

template <class Real>
struct Vector {
    Real x, y, z;
    Vector(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
    explicit Vector(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
    explicit Vector(const std::array<double, 3>& v) : x(v[0]), y(v[1]), z(v[2]) {}
    Vector operator-(const Vector& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vector operator*(Real s) const { return {x * s, y * s, z * s}; }
    Vector cross(const Vector& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
    Real dot(const Vector& o) const { return x * o.x + y * o.y + z * o.z; }
    double squared() const { return static_cast<double>(dot(*this)); }
    double length() const { return std::sqrt(squared()); }
    double largest() const {
        return std::max({std::fabs(static_cast<double>(x)), std::fabs(static_cast<double>(y)),
                         std::fabs(static_cast<double>(z))});
    }
};

constexpr double kUlp = 0x1p-24;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Six times the signed volumes that the ray's direction spans with each edge.
template <class Real>
struct Volumes {
    Real u, v, w;
};
template <class Real>
Volumes<Real> volumes(const TriangleShape& s, const ExactRay& ray) {
    const Vector<Real> o(ray.origin), d(ray.direction);
    const Vector<Real> a = Vector<Real>(s.a) - o, b = Vector<Real>(s.b) - o, c = Vector<Real>(s.c) - o;
    return {d.dot(c.cross(b)), d.dot(a.cross(c)), d.dot(b.cross(a))};
}

// In float64 where its sign is certain, else in quadruple precision.
Volumes<double> certain_volumes(const TriangleShape& s, const ExactRay& ray) {
    const Volumes<double> v = volumes<double>(s, ray);
    const double least = 1e-9 * (std::fabs(v.u) + std::fabs(v.v) + std::fabs(v.w));
    if (std::fabs(v.u) >= least && std::fabs(v.v) >= least && std::fabs(v.w) >= least) return v;
    const Volumes<__float128> q = volumes<__float128>(s, ray);
    return {static_cast<double>(q.u), static_cast<double>(q.v), static_cast<double>(q.w)};
}

// Distance of the line through the origin along d from the segment between a and b.
double segment_distance(const Vector<double>& d, const Vector<double>& a, const Vector<double>& b) {
    const double dd = d.squared();
    const auto across = [&](const Vector<double>& p) { return p - d * (p.dot(d) / dd); };
    const Vector<double> from = across(a), edge = across(b) - from;
    const double ee = edge.squared();
    const double s = ee > 0.0 ? std::clamp(-from.dot(edge) / ee, 0.0, 1.0) : 0.0;
    return (from - edge * -s).length();
}

// The parts of a sphere's hit that cancel: the radius less the distance of the ray's line from the center,
// half the chord squared.
template <class Real>
struct Chord {
    double margin, half_squared;
};
template <class Real>
Chord<Real> chord(const SphereShape& s, const ExactRay& ray) {
    using V = Vector<Real>;
    const V f = V(ray.origin) - V(s.center), d(ray.direction);
    const Real r = s.radius;
    const V perpendicular = f - d * (f.dot(d) / d.dot(d));
    const Real from_axis = perpendicular.dot(perpendicular);
    const double distance = std::sqrt(static_cast<double>(from_axis));
    const auto half_squared = static_cast<double>(r * r - from_axis);
    return {half_squared / (static_cast<double>(r) + distance), half_squared};
}

}  // namespace

double ExactHit::t_nearest(float candidate) const {
    return std::fabs(candidate - other_t) < std::fabs(candidate - t) ? other_t : t;
}

double ExactHit::t_error(float candidate) const {
    return std::fabs(candidate - t_nearest(candidate)) / t_unit;
}

ExactHit exact_hit(const TriangleShape& s, const ExactRay& ray) {
    using V = Vector<double>;
    const V o(ray.origin), d(ray.direction);
    const V a = V(s.a) - o, b = V(s.b) - o, c = V(s.c) - o;
    const V ab = b - a, bc = c - b, ca = a - c;
    const V normal = ab.cross(c - a);
    const double slope = normal.dot(d);  // |n| |d| cos
    const double longest_squared = std::max({ab.squared(), bc.squared(), ca.squared()});

    ExactHit hit;
    hit.unit = kUlp * std::max({a.largest(), b.largest(), c.largest()});
    hit.t = slope != 0.0 ? normal.dot(a) / slope : kNaN;
    hit.t_unit = slope != 0.0 ? hit.unit * longest_squared / std::fabs(slope) : kNaN;
    hit.other_t = kNaN;
    if (!(normal.squared() > 0.0)) {
        hit.margin = -kInfinity;
        return hit;
    }
    const Volumes<double> v = certain_volumes(s, ray);
    const double sign = v.u + v.v + v.w < 0.0 ? -1.0 : 1.0;
    const auto distance = [&](double volume, const V& edge) {
        const double spanned = d.cross(edge).length();
        return spanned > 0.0 ? sign * volume / spanned : 0.0;
    };
    const double u = distance(v.u, bc), w = distance(v.w, ab), vv = distance(v.v, ca);
    hit.margin = std::min({u, vv, w});
    // Near a corner the lines through the edges are nearer than the edges.
    if (hit.margin < 0.0)
        hit.margin = -std::min({u < 0.0 ? segment_distance(d, b, c) : kInfinity,
                                vv < 0.0 ? segment_distance(d, c, a) : kInfinity,
                                w < 0.0 ? segment_distance(d, a, b) : kInfinity});
    return hit;
}

ExactHit exact_hit(const SphereShape& s, const ExactRay& ray) {
    using V = Vector<double>;
    const V f = V(ray.origin) - V(s.center), d(ray.direction);
    const double dd = d.squared(), speed = std::sqrt(dd);

    ExactHit hit;
    hit.unit = kUlp * (f.largest() + s.radius);
    auto [margin, half_squared] = chord<double>(s, ray);
    if (std::fabs(margin) < 1e-2 * hit.unit) {
        const auto exact = chord<__float128>(s, ray);
        margin = exact.margin, half_squared = exact.half_squared;
    }
    hit.margin = margin;
    const double half_chord = std::sqrt(std::max(0.0, half_squared));
    // Near the outline a shift by one unit moves the hit by the square root of it.
    const double cosine = std::max(half_chord / s.radius, std::sqrt(hit.unit / s.radius));
    hit.t_unit = hit.unit / (speed * cosine);
    const double middle = -f.dot(d) / dd, half = half_chord / speed;
    const double near = middle - half, doubt = ExactHit::kTolerance * hit.t_unit;
    hit.t = near > doubt ? near : middle + half;
    hit.other_t = std::fabs(near) <= doubt ? near : kNaN;
    return hit;
}

}  // namespace ctpbench
