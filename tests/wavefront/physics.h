// What the tests of light in whole frames share: shapes, and statistics of images.
#pragma once

#include <cmath>

#include "looks.h"
#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench::test {

// A scene's parts, added one after the other. Each returns the number of what it added.
inline std::uint32_t add_material(Scene& scene, const MaterialDescription& look) {
    scene.materials.push_back({"", look});
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline void add_mesh(Scene& scene, const Mesh& mesh, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
    scene.mesh.positions.insert(scene.mesh.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& t : mesh.triangles) {
        scene.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        scene.mesh.material.push_back(material);
        if (!scene.mesh.texcoords.empty()) scene.mesh.texcoords.push_back({});
    }
}

// The square of half-width `half` at height z, seen from either side. Its texture coordinates are 0 to 1.
inline void add_square(Scene& scene, float half, float z, std::uint32_t material) {
    Mesh mesh;
    mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    add_mesh(scene, mesh, material);
    scene.mesh.texcoords.resize(scene.mesh.triangles.size());
    const std::size_t n = scene.mesh.triangles.size();
    scene.mesh.texcoords[n - 2] = {{{0, 0}, {1, 0}, {1, 1}}};
    scene.mesh.texcoords[n - 1] = {{{0, 0}, {1, 1}, {0, 1}}};
}

// The mean of values that are independent of each other, and its standard error.
class Mean {
public:
    void add(double value) { ++n_, sum_ += value, squares_ += value * value; }
    double value() const { return sum_ / n_; }
    double sigma() const { return std::sqrt(std::fmax(0.0, squares_ / n_ - value() * value()) / n_); }
    double count() const { return n_; }

private:
    double n_ = 0.0, sum_ = 0.0, squares_ = 0.0;
};

inline std::uint32_t clamped(const Frames& frames) {
    std::uint32_t sum = 0;
    for (const StageTime& s : frames.stages) sum += s.clamped;
    return sum;
}

}  // namespace ctpbench::test
