#include "scene/recipes/mesh_edit.h"

#include <string>

#include "base/error.h"

namespace ctpbench::recipe {

void reserve(Mesh& mesh, std::size_t triangles, std::size_t vertices) {
    mesh.positions.reserve(vertices);
    mesh.triangles.reserve(triangles);
    mesh.material.reserve(triangles);
}

void place(Mesh& mesh, const Mesh& part, const Frame& frame) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : part.positions) mesh.positions.push_back(frame.point(p));
    for (const auto& t : part.triangles) mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
    mesh.material.insert(mesh.material.end(), part.material.begin(), part.material.end());
}

std::size_t remaining(const Mesh& mesh, std::size_t target, std::size_t least) {
    const std::size_t have = mesh.triangles.size();
    if (have + least > target) {
        throw Error(ExitCode::internal, "recipe: its fixed parts already have " + std::to_string(have) +
                                            " of " + std::to_string(target) + " triangles and at least " +
                                            std::to_string(least) +
                                            " are needed to fill up; lower the tessellation of a fixed part");
    }
    return target - have;
}

}  // namespace ctpbench::recipe
