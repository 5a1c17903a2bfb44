// Cosine and sine from additions and multiplications alone. Mathematics libraries round their sine
// differently from version to version; a stand-in mesh must not depend on which one is installed.
#pragma once

#include <cmath>

namespace ctpbench::recipe {

struct CirclePoint {
    float cos, sin;
};

// The point on the unit circle after `turns` full turns. Taylor series on an eighth of a turn to either
// side of the nearest axis; the error in double is below 1e-12, far under the rounding to float.
inline CirclePoint circle(double turns) {
    const double fraction = turns - std::floor(turns);
    const double quarter = std::floor(fraction * 4.0 + 0.5);
    const double x = (fraction - quarter * 0.25) * 6.283185307179586;
    const double xx = x * x;
    const double s =
        x * (1 - xx / 6 * (1 - xx / 20 * (1 - xx / 42 * (1 - xx / 72 * (1 - xx / 110 * (1 - xx / 156))))));
    const double c =
        1 - xx / 2 * (1 - xx / 12 * (1 - xx / 30 * (1 - xx / 56 * (1 - xx / 90 * (1 - xx / 132)))));
    switch (static_cast<int>(quarter) & 3) {
        case 0:
            return {static_cast<float>(c), static_cast<float>(s)};
        case 1:
            return {static_cast<float>(-s), static_cast<float>(c)};
        case 2:
            return {static_cast<float>(-c), static_cast<float>(-s)};
        default:
            return {static_cast<float>(s), static_cast<float>(-c)};
    }
}

}  // namespace ctpbench::recipe
