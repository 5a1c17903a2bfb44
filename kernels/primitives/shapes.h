// The geometry of each primitive type as the scene stores it, before a strategy lays it out for
// traversal. Units are the scene's own.
#pragma once

#include "../vec.h"

namespace ctpbench {

struct TriangleShape {
    Vec3 a, b, c;
};

struct SphereShape {
    Vec3 center;
    float radius;
};

}  // namespace ctpbench
