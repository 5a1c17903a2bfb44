// From the name of a scene to the scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "config/scene_choice.h"
#include "scene/notices.h"
#include "scene/scene.h"
#include "scene/search_path.h"

namespace ctpbench {

struct SceneRequest {
    std::string name;  // of a scene file on the search path, or the path of a .json or .obj file
    SceneChoice choice = SceneChoice::auto_;
    Folders scene_dirs;                    // searched first
    std::optional<std::uint32_t> spheres;  // these three override the scene file
    std::optional<float> sphere_radius;
    std::optional<std::uint64_t> seed;
};

// Triangles, then the spheres that are placed, then those scattered in the triangles' bounds, all of one
// material. The light, the exposure and the placed spheres are those of the file that the triangles come
// from. What no ray can ask for is left out (trim.h), so of materials alike only the first's name is there.
// Throws Error(scene_missing) if the mesh cannot be found and Error(usage) if a file is wrong.
Scene load_scene(const SceneRequest& request, Notices& notices);

}  // namespace ctpbench
