// The scene's geometry as every strategy sees it while it lays out its primitives, and as shading sees
// it to find normals. Ids are scene-wide: triangles from 0 in mesh order, then spheres.
#pragma once

#include <array>
#include <cstdint>

#include "shapes.h"

namespace ctpbench {

struct GeometryView {
    const Vec3* positions;
    const std::array<std::uint32_t, 3>* triangles;
    const SphereShape* spheres;
    std::uint32_t triangle_count;
    std::uint32_t sphere_count;
    float extent;  // largest absolute coordinate of the bounds

    CTP_INLINE TriangleShape triangle(std::uint32_t i) const {
        const auto& t = triangles[i];
        return {positions[t[0]], positions[t[1]], positions[t[2]]};
    }
    CTP_INLINE std::uint32_t first_sphere() const { return triangle_count; }
    CTP_INLINE std::uint32_t size() const { return triangle_count + sphere_count; }
};

}  // namespace ctpbench
