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
                largest_coordinate(scene_bounds(scene))} {
    std::vector<MaterialWord> word_of(scene.materials.size());
    for (std::uint32_t type = 0; type < Materials::size; ++type) {
        for (std::size_t m = 0; m < scene.materials.size(); ++m) {
            if (scene.materials[m].look.type != type) continue;
            word_of[m] = MaterialWord::make(type, static_cast<std::uint32_t>(descriptions_.size()));
            descriptions_.push_back(scene.materials[m].look);
        }
        first_[type + 1] = static_cast<std::uint32_t>(descriptions_.size());
    }
    words_.reserve(scene.mesh.material.size());
    for (const std::uint32_t m : scene.mesh.material) words_.push_back(word_of[m]);
    of_spheres_ = word_of[scene.sphere_material];
}

MaterialInput SceneView::materials() const {
    MaterialInput in{descriptions_.data(), {}};
    std::copy(std::begin(first_), std::end(first_), std::begin(in.first));
    return in;
}

}  // namespace ctpbench
