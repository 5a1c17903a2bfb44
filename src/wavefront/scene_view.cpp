#include "wavefront/scene_view.h"

#include <algorithm>
#include <cmath>

namespace ctpbench {
namespace {

float largest_coordinate(const Box& box) {
    if (box.is_empty()) return 0.0f;
    float extent = 0.0f;
    for (const Vec3& corner : {box.lo, box.hi})
        for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, std::fabs(corner[axis]));
    return extent;
}

}  // namespace

SceneView::SceneView(const Scene& scene)
    : scene_(scene),
      geometry_{scene.mesh.positions.data(),
                scene.mesh.triangles.data(),
                scene.spheres.data(),
                static_cast<std::uint32_t>(scene.mesh.triangles.size()),
                static_cast<std::uint32_t>(scene.spheres.size()),
                largest_coordinate(scene_bounds(scene))} {}

}  // namespace ctpbench
