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
    Vector operator-(const Vector& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vector cross(const Vector& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
    Real dot(const Vector& o) const { return x * o.x + y * o.y + z * o.z; }
    double length() const { return std::sqrt(static_cast<double>(dot(*this))); }
    double largest() const {
        return std::max({std::fabs(static_cast<double>(x)), std::fabs(static_cast<double>(y)),
                         std::fabs(static_cast<double>(z))});
    }
};

constexpr double kUlp = 0x1p-24;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Six times the signed volumes that the ray's direction spans with each edge.
template <class Real>
struct Volumes {
    Real u, v, w;
};
template <class Real>
Volumes<Real> volumes(const TriangleShape& s, const Ray& ray) {
    const Vector<Real> o(ray.origin), d(ray.direction);
    const Vector<Real> a = Vector<Real>(s.a) - o, b = Vector<Real>(s.b) - o, c = Vector<Real>(s.c) - o;
    return {d.dot(c.cross(b)), d.dot(a.cross(c)), d.dot(b.cross(a))};
}

// In float64 where its sign is certain, else in quadruple precision.
Volumes<double> certain_volumes(const TriangleShape& s, const Ray& ray) {
    const Volumes<double> v = volumes<double>(s, ray);
    const double least = 1e-9 * (std::fabs(v.u) + std::fabs(v.v) + std::fabs(v.w));
    if (std::fabs(v.u) >= least && std::fabs(v.v) >= least && std::fabs(v.w) >= least) return v;
    const Volumes<__float128> q = volumes<__float128>(s, ray);
    return {static_cast<double>(q.u), static_cast<double>(q.v), static_cast<double>(q.w)};
}

}  // namespace

double ExactHit::t_error(float candidate) const { return std::fabs(candidate - t) / t_unit; }

double edge_distance(Vec3 a, Vec3 b, const Ray& ray) {
    using V = Vector<__float128>;
    const V o(ray.origin), d(ray.direction);
    const V from = V(a) - o, to = V(b) - o;
    const double spanned = d.cross(to - from).length();
    const auto volume = static_cast<double>(d.dot(from.cross(to)));
    return spanned > 0.0 ? volume / spanned : 0.0;
}

ExactHit exact_hit(const TriangleShape& s, const Ray& ray) {
    using V = Vector<double>;
    const V o(ray.origin), d(ray.direction);
    const V a = V(s.a) - o, b = V(s.b) - o, c = V(s.c) - o;
    const V ab = b - a, bc = c - b, ca = a - c;
    const V normal = ab.cross(c - a);
    const double area = normal.length();
    const double longest = std::max({ab.length(), bc.length(), ca.length()});
    const double slope = normal.dot(d);  // |n| |d| cos

    ExactHit hit;
    hit.unit = kUlp * std::max({a.largest(), b.largest(), c.largest()});
    hit.t = slope != 0.0 ? normal.dot(a) / slope : kNaN;
    hit.t_unit = slope != 0.0 ? hit.unit * longest * longest / std::fabs(slope) : kNaN;
    const Volumes<double> v = certain_volumes(s, ray);
    const double sign = v.u + v.v + v.w < 0.0 ? -1.0 : 1.0;
    const auto distance = [&](double volume, const V& edge) {
        const double spanned = d.cross(edge).length();
        return spanned > 0.0 ? sign * volume / spanned : 0.0;
    };
    hit.margin = area > 0.0 ? std::min({distance(v.u, bc), distance(v.v, ca), distance(v.w, ab)})
                            : -std::numeric_limits<double>::infinity();
    return hit;
}

ExactHit exact_hit(const SphereShape& s, const Ray& ray) {
    using V = Vector<__float128>;
    const V f = V(ray.origin) - V(s.center), d(ray.direction);
    const __float128 dd = d.dot(d), b = -f.dot(d), r = s.radius;
    const V perpendicular = {f.x + b / dd * d.x, f.y + b / dd * d.y, f.z + b / dd * d.z};
    const __float128 from_axis = perpendicular.dot(perpendicular);
    const auto half_chord_squared = static_cast<double>(r * r - from_axis);
    const double half_chord = std::sqrt(std::max(0.0, half_chord_squared));
    const double speed = std::sqrt(static_cast<double>(dd));

    ExactHit hit;
    hit.unit = kUlp * (f.largest() + s.radius);
    hit.margin = static_cast<double>(r) - std::sqrt(static_cast<double>(from_axis));
    const auto middle = static_cast<double>(b / dd);
    const auto starts_inside = f.dot(f) < r * r;
    hit.t = starts_inside ? middle + half_chord / speed : middle - half_chord / speed;
    // Near the outline a shift by one unit moves the hit by the square root of it.
    const double cosine = std::max(half_chord / s.radius, std::sqrt(hit.unit / s.radius));
    hit.t_unit = hit.unit / (speed * cosine);
    return hit;
}

}  // namespace ctpbench
