// One ray against one primitive in float64, and in quadruple precision where that is undecided: the last
// word on a disagreement between float32 programs, Embree included.
#pragma once

#include <array>

#include "kernels/primitives/shapes.h"
#include "kernels/ray.h"

namespace ctpbench {

// A ray without end in float64: what a float32 ray says exactly, or one that float32 cannot hold, such as one
// that starts on a surface.
struct ExactRay {
    std::array<double, 3> origin;
    std::array<double, 3> direction;

    ExactRay(const std::array<double, 3>& o, const std::array<double, 3>& d) : origin(o), direction(d) {}
    ExactRay(const Ray& ray)
        : origin{ray.origin.x, ray.origin.y, ray.origin.z},
          direction{ray.direction.x, ray.direction.y, ray.direction.z} {}
};

struct ExactHit {
    // Distance in scene units by which the ray's line passes inside the primitive's outline, as seen along
    // the ray; negative outside.
    double margin;
    double t;       // NaN if there is none; may be negative
    double unit;    // rounding of the coordinates involved: 2^-24 times the largest |coordinate - origin|
    double t_unit;  // error of t that such a rounding causes: unit kappa / (|d| cos), see t_error()
    // A second answer that is as right: where a ray starts on a sphere within rounding, the point that it
    // starts from. NaN if there is none.
    double other_t;

    // A float32 program may decide either way within this many units of the outline, or of t = 0.
    static constexpr double kTolerance = 8.0;
    bool inside() const { return margin > kTolerance * unit && t > kTolerance * t_unit; }
    bool outside() const { return margin < -kTolerance * unit || !(t > -kTolerance * t_unit); }
    // Of the right answers, the one that is nearest to a program's t.
    double t_nearest(float candidate) const;
    // Scaled error of a float32 program's t, at most kTolerance for a sound test:
    // |dt| |d| cos / (2^-24 M kappa), with M the largest |v - o| and kappa = L^2 / |e1 x e2| for the longest
    // edge L; for a sphere M is |c - o| + r and kappa 1, cos at its outline as small as M's rounding makes
    // it.
    double t_error(float candidate) const;
};

ExactHit exact_hit(const TriangleShape& triangle, const ExactRay& ray);
ExactHit exact_hit(const SphereShape& sphere, const ExactRay& ray);

}  // namespace ctpbench
