// The oracle of last resort over whole scenes: closest hits by our tree, whose boxes are widened in float64
// so that nothing is left out that a float32 program may report, with exact_hit() at the leaves.
#pragma once

#include <cstdint>

#include "accel/tree.h"
#include "oracle/check.h"

namespace ctpbench {

// What is certain of a ray, and what is not.
struct ExactClosest {
    std::uint32_t primitive = kNoPrimitive;  // the nearest that no program may miss
    double t = 0.0;
    bool decided =
        false;  // hit beyond doubt; else passed at its outline, where the surface goes on all around:
                // a program may report any of the triangles there, but must report one of them
};

class ExactTracer {
public:
    // All must outlive it. The tree is over all primitives of the scene. Primitives with NaN, infinite or
    // absurdly large coordinates are not in it, and so are never hit.
    ExactTracer(const Judge& judge, const Tree& tree);

    ExactClosest closest(const ExactRay& ray) const;
    // Of a path that starts on `start`, at a point that float32 need not hold: the closest hit without any
    // allowance for rounding. A triangle is not hit by what starts on it, a sphere on its far side at most.
    ExactClosest after_departure(const ExactRay& ray, std::uint32_t start) const;
    // The same for a float32 ray, as a reference for the judge: t rounded, u and v 0.
    Hit reference(const Ray& ray) const;

private:
    template <class Test>
    void for_each_met(const ExactRay& ray, const double& bound, const Test& test) const;

    const Judge& judge_;
    const Tree& tree_;
    double extent_;  // largest |coordinate| of the tree's bounds
};

}  // namespace ctpbench
