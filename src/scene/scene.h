// A scene as plain host data. Made once per scene file and sphere count; nothing here knows of trees,
// strategies or backends.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/array.h"
#include "kernels/box.h"
#include "kernels/materials/description.h"
#include "kernels/primitives/shapes.h"
#include "kernels/vec.h"

namespace ctpbench {

struct Material {
    std::string name;
    MaterialDescription look;
};

// Vertices are shared; `material[i]` belongs to `triangles[i]`.
struct Mesh {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> material;
    // Of each triangle's vertices, in OBJ's sense (v = 0 at the bottom); empty if no material is textured.
    std::vector<std::array<Vec2, 3>> texcoords;

    TriangleShape triangle(std::size_t i) const {
        const auto& t = triangles[i];
        return {positions[t[0]], positions[t[1]], positions[t[2]]};
    }
};

// `fov_degrees` spans the smaller image side.
struct Camera {
    Vec3 eye{0, 0, 0};
    Vec3 target{0, 0, -1};
    Vec3 up{0, 1, 0};
    float fov_degrees = 60.0f;
};

enum class SceneSource { mesh, stand_in };

// What loading took out of a scene since no ray can ask for it (trim.h).
struct SceneSavings {
    std::size_t unused_vertices = 0;
    std::size_t unused_texcoords = 0;  // triangles that had some
    std::size_t unused_materials = 0;
    std::size_t merged_materials = 0;  // into an earlier one that behaves alike
    bool operator==(const SceneSavings&) const = default;
};

struct Scene {
    std::string name;                        // as the config names it
    SceneSource source = SceneSource::mesh;  // where its triangles come from
    Mesh mesh;
    std::vector<SphereShape> spheres;
    std::vector<Material> materials;  // never empty
    std::uint32_t sphere_material = 0;
    Array<Texel> texels;             // of all textures
    Vec3 ambient{1.0f, 1.0f, 1.0f};  // radiance that arrives from outside, from every direction
    Camera camera;
    float exposure = 1.0f;              // by which pictures for the eye are multiplied
    std::size_t dropped_triangles = 0;  // NaN, infinite or absurdly large vertices; zero area
    SceneSavings savings;
    std::uint64_t content_hash = 0;  // of triangles, materials and spheres
};

// Bounds of all triangles and spheres.
Box scene_bounds(const Scene& scene);

// Of each material, whether some triangle has it or, if there are any, the spheres.
std::vector<bool> used_materials(const Scene& scene);

}  // namespace ctpbench
