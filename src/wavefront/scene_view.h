// A scene as all kernels see it, whatever types they know: its geometry and what surfaces carry. Refers to
// the scene, which must outlive it.
#pragma once

#include "kernels/materials/scattering.h"
#include "kernels/primitives/geometry.h"
#include "scene/scene.h"

namespace ctpbench {

class SceneView {
public:
    explicit SceneView(const Scene& scene);

    const GeometryView& geometry() const { return geometry_; }
    SurfaceAttributes attributes() const { return {scene_.mesh.texcoords.data(), scene_.texels.data()}; }
    std::size_t texcoord_count() const { return scene_.mesh.texcoords.size(); }
    std::size_t texel_count() const { return scene_.texels.size(); }
    Vec3 ambient() const { return scene_.ambient; }

private:
    const Scene& scene_;
    GeometryView geometry_;
};

}  // namespace ctpbench
