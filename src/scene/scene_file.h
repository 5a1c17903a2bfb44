// A scene file, scenes/NAME.json: which mesh or recipe, seen from where, with which spheres.
//
//     { "schema_version": 1,
//       "name": "conference",
//       "mesh": {"file": "conference/conference.obj", "triangles": 331179, "variant": "..."},
//       "stand_in": "conference_like",
//       "paper_triangles": 331000,
//       "camera": {"eye": [0, 1, 2], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 75},
//       "ambient": [1, 1, 1],      // radiance from outside, from every direction
//       "exposure": 1,             // by which pictures are multiplied
//       "spheres": {"count": 0, "radius": 0.03, "seed": 1, "specular": [0.9, 0.9, 0.9],
//                   "placed": [{"center": [0, 1, 0], "radius": 0.5}]},
//       "overrides": {"materials": {"carpet": {"type": "matte", "diffuse": [0.5, 0.4, 0.3]},
//                                   "table": {"type": "plastic", "specular": [0.1, 0.1, 0.1], "exponent":
//                                   50}, "lamp": {"type": "emissive", "emission": [10, 10, 9]}}} }
//
// "mesh" may be a list of editions, each with a "camera" of its own if its coordinates differ and with
// "overrides" of its own, which come after the file's; and "file" a list of places. The first that is there
// is used. "recipe": {"name": "...", "seed": 1, "origin": [0, 0, 0]} stands in place of "mesh", with
// "triangles" if the recipe comes in more than one size. The spheres are mirrors: `count` of them are
// scattered, those "placed" are there whatever the count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/material_overrides.h"
#include "scene/scene.h"

namespace ctpbench {

struct MeshEdition {
    std::vector<std::string> files;  // absolute, or relative to a folder of the search path
    std::uint64_t triangles = 0;     // that the file holds; 0 if not known
    std::string variant;             // what to say when the count is not the paper's
    std::optional<Camera> camera;
    std::vector<MaterialOverride> overrides;
};

struct RecipeChoice {
    std::string name;
    std::uint64_t seed = 1;
    std::uint64_t triangles = 0;
    Vec3 origin{0.0f, 0.0f, 0.0f};  // where the recipe's zero lies; not the camera's or the placed spheres'
};

struct SphereSettings {
    std::uint32_t count = 0;
    float radius = 0.03f;  // as a share of the mean spacing
    std::uint64_t seed = 1;
    Vec3 specular{0.9f, 0.9f, 0.9f};
    std::vector<SphereShape> placed;
};

struct SceneFile {
    std::filesystem::path path;
    std::string name;
    std::vector<MeshEdition> meshes;     // either these
    std::optional<RecipeChoice> recipe;  // or this
    std::string stand_in;                // the name of another scene file; empty if there is none
    std::uint64_t paper_triangles = 0;   // 0 if the scene is not in the paper
    std::optional<Camera> camera;
    Vec3 ambient{1.0f, 1.0f, 1.0f};
    float exposure = 1.0f;
    SphereSettings spheres;
    std::vector<MaterialOverride> overrides;
};

// Throws Error(usage) with every mistake in the file, each with its line.
SceneFile read_scene_file(const std::filesystem::path& path);

}  // namespace ctpbench
