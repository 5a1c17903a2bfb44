// One ray against one primitive in float64, and in quadruple precision where that is undecided: the last
// word on a disagreement between float32 programs, Embree included.
#pragma once

#include "kernels/primitives/shapes.h"
#include "kernels/ray.h"

namespace ctpbench {

struct ExactHit {
    // Distance in scene units by which the ray passes inside the primitive's outline as seen along the
    // ray; negative outside.
    double margin;
    double t;       // NaN if there is no t > 0
    double unit;    // rounding of the coordinates involved: 2^-24 times the largest |coordinate - origin|
    double t_unit;  // error of t that such a rounding causes: unit kappa / (|d| cos), see t_error()

    // A float32 program may decide either way within this many units of the outline.
    static constexpr double kTolerance = 8.0;
    bool inside() const { return margin > kTolerance * unit && t > 0.0; }
    bool outside() const { return margin < -kTolerance * unit || !(t > -kTolerance * t_unit); }
    // Scaled error of a float32 program's t; at most kTolerance for a sound test.
    double t_error(float candidate) const;
};

ExactHit exact_hit(const TriangleShape& triangle, const Ray& ray);
ExactHit exact_hit(const SphereShape& sphere, const Ray& ray);

// Signed distance of the ray's line from the line through a and b, positive if the line through a and b
// passes the ray on the side that makes (a, b) turn counterclockwise about it.
double edge_distance(Vec3 a, Vec3 b, const Ray& ray);

}  // namespace ctpbench
