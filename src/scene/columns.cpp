#include "scene/columns.h"

#include "kernels/material_words.h"

namespace ctpbench {
namespace {

template <class Elements>
std::size_t bytes_of(const Elements& elements) {
    return elements.size() * sizeof(elements[0]);
}

}  // namespace

std::vector<SceneColumn> columns_of(const Scene& scene) {
    const Mesh& mesh = scene.mesh;
    return {{"positions", bytes_of(mesh.positions)},
            {"triangles", bytes_of(mesh.triangles)},
            {"material_words", mesh.material.size() * sizeof(MaterialWord)},
            {"texcoords", bytes_of(mesh.texcoords)},
            {"texels", bytes_of(scene.texels)},
            {"spheres", bytes_of(scene.spheres)},
            {"materials", scene.materials.size() * sizeof(MaterialDescription)}};
}

}  // namespace ctpbench
