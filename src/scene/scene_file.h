// A scene file, scenes/NAME.json: which mesh or recipe, seen from where, with which spheres.
//
//     { "schema_version": 1,
//       "name": "conference",
//       "mesh": {"file": "conference/conference.obj", "triangles": 331179, "variant": "..."},
//       "stand_in": "conference_like",
//       "paper_triangles": 331000,
//       "camera": {"eye": [0, 1, 2], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 75},
//       "spheres": {"count": 0, "radius": 0.03, "seed": 1, "diffuse": [0.8, 0.8, 0.8]},
//       "overrides": {"materials": {"carpet": {"diffuse": [0.5, 0.4, 0.3]}}} }
//
// "mesh" may be a list of editions, each with a "camera" of its own if its coordinates differ, and "file" a
// list of places; the first that is there is used. "recipe": {"name": "...", "seed": 1} stands in place of
// "mesh".
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json_document.h"
#include "scene/scene.h"

namespace ctpbench {

struct MeshEdition {
    std::vector<std::string> files;  // absolute, or relative to a folder of the search path
    std::uint64_t triangles = 0;     // that the file holds; 0 if not known
    std::string variant;             // what to say when the count is not the paper's
    std::optional<Camera> camera;
};

struct RecipeChoice {
    std::string name;
    std::uint64_t seed = 1;
};

struct SphereSettings {
    std::uint32_t count = 0;
    float radius = 0.03f;  // as a share of the mean spacing
    std::uint64_t seed = 1;
    Vec3 diffuse{0.8f, 0.8f, 0.8f};
};

struct MaterialOverride {
    std::string material;
    Vec3 diffuse;
    JsonPlace place;  // where the file says so
};

struct SceneFile {
    std::filesystem::path path;
    std::string name;
    std::vector<MeshEdition> meshes;     // either these
    std::optional<RecipeChoice> recipe;  // or this
    std::string stand_in;                // the name of another scene file; empty if there is none
    std::uint64_t paper_triangles = 0;   // 0 if the scene is not in the paper
    std::optional<Camera> camera;
    SphereSettings spheres;
    std::vector<MaterialOverride> overrides;
};

// Throws Error(usage) with every mistake in the file, each with its line.
SceneFile read_scene_file(const std::filesystem::path& path);

}  // namespace ctpbench
