// A scene's triangles, spheres or both, as the tree builder sees them. The type of a reference is the
// position in the list of primitives: 0 for triangles, 1 for spheres. Or its triangles, each of a type given.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/sbvh.h"
#include "kernels/primitives/sphere_bounds.h"
#include "kernels/primitives/triangle_bounds.h"
#include "scene/scene.h"

namespace ctpbench {

enum class PrimitiveSet { all, triangles, spheres };

// Refers to the scene, which must outlive it.
class ScenePrimitives {
public:
    explicit ScenePrimitives(const Scene& scene, PrimitiveSet which = PrimitiveSet::all)
        : scene_(&scene),
          triangles_(
              which == PrimitiveSet::spheres ? 0 : static_cast<std::uint32_t>(scene.mesh.triangles.size())),
          spheres_(which == PrimitiveSet::triangles ? 0 : static_cast<std::uint32_t>(scene.spheres.size())) {}

    // The triangles alone, types[i] being that of triangle i; the types must outlive this too.
    ScenePrimitives(const Scene& scene, std::span<const std::uint8_t> types)
        : ScenePrimitives(scene, PrimitiveSet::triangles) {
        types_ = types.data();
    }

    std::size_t size() const { return std::size_t{triangles_} + spheres_; }
    PrimitiveRef ref(std::uint32_t i) const {
        if (types_ != nullptr) return {types_[i], i};
        return i < triangles_ ? PrimitiveRef{0, i} : PrimitiveRef{1, i - triangles_};
    }
    Box bounds(std::uint32_t i) const {
        return i < triangles_ ? ctpbench::bounds(scene_->mesh.triangle(i))
                              : ctpbench::bounds(scene_->spheres[i - triangles_]);
    }
    Box clip(std::uint32_t i, const Box& box) const {
        return i < triangles_ ? ctpbench::clip(scene_->mesh.triangle(i), box)
                              : ctpbench::clip(scene_->spheres[i - triangles_], box);
    }

    template <class Use>
    void with_shape(std::uint32_t i, const Use& use) const {
        if (i < triangles_) {
            use(scene_->mesh.triangle(i));
        } else {
            use(scene_->spheres[i - triangles_]);
        }
    }

private:
    const Scene* scene_;
    std::uint32_t triangles_, spheres_;
    const std::uint8_t* types_ = nullptr;  // null: triangles are of type 0
};

extern template Tree build_sbvh(const ScenePrimitives&, const SbvhSettings&, const BuildProgress&);

}  // namespace ctpbench
