// The hemisphere over a point on a surface, in coordinates that the samplers know nothing of: the cosine to
// the normal, and the azimuth from the plane of wo. Integrals over it are adaptive, since a glossy lobe at a
// grazing angle is far narrower than any grid.
#pragma once

#include <array>
#include <cmath>

#include "kernels/materials/scattering.h"

namespace ctpbench::test {

inline constexpr double kPi = 3.14159265358979323846;

struct Rectangle {
    double c0, c1, p0, p1;  // cosines and azimuths
};

class Hemisphere {
public:
    // wo is at that cosine to the normal, in the plane of the normal and `side`.
    Hemisphere(Vec3 normal, Vec3 side, double cosine) {
        n_ = scaled({normal.x, normal.y, normal.z}, 1.0);
        const std::array<double, 3> s = {side.x, side.y, side.z};
        const double along = s[0] * n_[0] + s[1] * n_[1] + s[2] * n_[2];
        t_ = scaled({s[0] - along * n_[0], s[1] - along * n_[1], s[2] - along * n_[2]}, 1.0);
        b_ = {n_[1] * t_[2] - n_[2] * t_[1], n_[2] * t_[0] - n_[0] * t_[2], n_[0] * t_[1] - n_[1] * t_[0]};
        point_ = {direction(1.0, 0.0), direction(cosine, 0.0), &kNoAttributes, 0, 0.0f, 0.0f};
    }

    const SurfacePoint& point() const { return point_; }

    Vec3 direction(double cosine, double azimuth) const {
        const double sine = std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
        const double x = sine * std::cos(azimuth), y = sine * std::sin(azimuth);
        const auto component = [&](int i) {
            return static_cast<float>(x * t_[i] + y * b_[i] + cosine * n_[i]);
        };
        return {component(0), component(1), component(2)};
    }

    // In [-1, 1], and in [0, 2 pi).
    double cosine_of(Vec3 d) const { return inner(n_, d); }
    double azimuth_of(Vec3 d) const {
        const double p = std::atan2(inner(b_, d), inner(t_, d));
        return p < 0.0 ? p + 2.0 * kPi : p;
    }

private:
    static constexpr SurfaceAttributes kNoAttributes{nullptr, nullptr};

    static std::array<double, 3> scaled(std::array<double, 3> v, double to) {
        const double f = to / std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return {v[0] * f, v[1] * f, v[2] * f};
    }
    static double inner(const std::array<double, 3>& a, Vec3 b) {
        return a[0] * b.x + a[1] * b.y + a[2] * b.z;
    }

    std::array<double, 3> n_, t_, b_;
    SurfacePoint point_;
};

// Of f(direction) over the solid angle of the rectangle, to about the tolerance.
template <class F>
class Integral {
public:
    Integral(const Hemisphere& hemisphere, const F& f) : hemisphere_(hemisphere), f_(f) {}

    double over(const Rectangle& r, double tolerance) const { return refine(r, gauss(r), tolerance, 9); }

    // The rows are of equal angle, so that they are finest about the normal.
    double over_all(int rows, int columns, double tolerance) const {
        double sum = 0.0;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j)
                sum += over(cell(i, j, rows, columns), tolerance / (rows * columns));
        return sum;
    }

    static Rectangle cell(int i, int j, int rows, int columns) {
        return {std::cos(0.5 * kPi * (i + 1) / rows), std::cos(0.5 * kPi * i / rows), 2.0 * kPi * j / columns,
                2.0 * kPi * (j + 1) / columns};
    }

private:
    double gauss(const Rectangle& r) const {
        constexpr double x[3] = {-0.774596669241483, 0.0, 0.774596669241483}, w[3] = {5.0, 8.0, 5.0};
        const double hc = 0.5 * (r.c1 - r.c0), hp = 0.5 * (r.p1 - r.p0);
        double sum = 0.0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                sum += w[i] * w[j] *
                       f_(hemisphere_.direction(r.c0 + hc * (1.0 + x[i]), r.p0 + hp * (1.0 + x[j])));
        return sum * hc * hp / 81.0;
    }
    double refine(const Rectangle& r, double whole, double tolerance, int depth) const {
        const double c = 0.5 * (r.c0 + r.c1), p = 0.5 * (r.p0 + r.p1);
        const Rectangle quarters[4] = {
            {r.c0, c, r.p0, p}, {c, r.c1, r.p0, p}, {r.c0, c, p, r.p1}, {c, r.c1, p, r.p1}};
        double parts[4], sum = 0.0;
        for (int i = 0; i < 4; ++i) sum += parts[i] = gauss(quarters[i]);
        if (depth == 0 || std::fabs(sum - whole) <= tolerance) return sum;
        sum = 0.0;
        for (int i = 0; i < 4; ++i) sum += refine(quarters[i], parts[i], 0.5 * tolerance, depth - 1);
        return sum;
    }

    const Hemisphere& hemisphere_;
    const F& f_;
};

}  // namespace ctpbench::test
