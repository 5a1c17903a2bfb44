// A scene as kernels see it: its geometry, and its materials numbered by type. Refers to the scene, which
// must outlive it.
#pragma once

#include <vector>

#include "kernels/dispatch/shade/layout.h"
#include "scene/scene.h"

namespace ctpbench {

class SceneView {
public:
    explicit SceneView(const Scene& scene);

    const GeometryView& geometry() const { return geometry_; }
    SurfaceAttributes attributes() const { return {scene_.mesh.texcoords.data(), scene_.texels.data()}; }
    std::size_t texcoord_count() const { return scene_.mesh.texcoords.size(); }
    std::size_t texel_count() const { return scene_.texels.size(); }
    MaterialWords words() const { return {words_.data(), geometry_.triangle_count, of_spheres_}; }
    MaterialInput materials() const;
    Vec3 ambient() const { return scene_.ambient; }

private:
    const Scene& scene_;
    GeometryView geometry_;
    std::vector<MaterialDescription> descriptions_;  // grouped by type
    std::uint32_t first_[Materials::size + 1] = {};
    Array<MaterialWord> words_;  // of each triangle
    MaterialWord of_spheres_{};
};

}  // namespace ctpbench
