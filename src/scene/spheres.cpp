#include "scene/spheres.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace ctpbench {
namespace {

float place(std::uint32_t word, float lo, float hi) {
    const double u = (static_cast<double>(word) + 0.5) * 0x1p-32;
    const double at = static_cast<double>(lo) + u * (static_cast<double>(hi) - static_cast<double>(lo));
    return std::clamp(static_cast<float>(at), lo, hi);
}

}  // namespace

double mean_spacing(const Box& bounds, std::uint32_t count) {
    double measure = 1.0;
    int dimensions = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = static_cast<double>(bounds.hi[axis]) - static_cast<double>(bounds.lo[axis]);
        if (!(extent > 0.0)) continue;
        measure *= extent;
        ++dimensions;
    }
    const double share = measure / std::max(count, 1u);
    switch (dimensions) {
        case 3:
            return std::cbrt(share);
        case 2:
            return std::sqrt(share);
        case 1:
            return share;
        default:
            return 0.0;
    }
}

std::vector<SphereShape> scatter_spheres(const Box& bounds, std::uint32_t count, float radius_share,
                                         std::uint64_t seed) {
    if (count == 0) return {};
    if (!(radius_share > 0.0f) || !std::isfinite(radius_share)) {
        throw Error(ExitCode::usage, "sphere radius " + std::to_string(radius_share) +
                                         " is not positive; it is a share of the mean spacing, such as 0.03");
    }
    const double spacing = bounds.is_empty() ? 0.0 : mean_spacing(bounds, count);
    if (!(spacing > 0.0)) {
        throw Error(ExitCode::usage,
                    "spheres cannot be scattered in a scene without extent; set their count to 0");
    }

    const float radius = static_cast<float>(radius_share * spacing);
    const r123::Philox4x32 philox;
    const r123::Philox4x32::key_type key{
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    std::vector<SphereShape> spheres(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto words = philox(r123::Philox4x32::ctr_type{{i, 0, 0, 0}}, key);
        for (int axis = 0; axis < 3; ++axis) {
            spheres[i].center[axis] = place(words[axis], bounds.lo[axis], bounds.hi[axis]);
        }
        spheres[i].radius = radius;
    }
    return spheres;
}

}  // namespace ctpbench
