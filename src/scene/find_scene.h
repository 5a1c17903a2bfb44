// From the name of a scene to its files: which scene file, which edition of its mesh, or which stand-in.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/scene_choice.h"
#include "scene/scene_file.h"
#include "scene/search_path.h"

namespace ctpbench {

// `name` is that of a scene file in one of the folders, or the path of a .json or .obj file. Meshes of the
// latter may lie beside them, so their folder comes first from here on.
SceneFile find_and_read(const std::string& name, Folders& folders);

struct FoundMesh {
    const MeshEdition* edition;
    std::filesystem::path path;
};
// A folder that is searched earlier beats an edition that is named earlier.
std::optional<FoundMesh> find_mesh(const SceneFile& file, const Folders& folders);

// Says where a mesh was looked for and where to get it, or that the scene never has one.
[[noreturn]] void fail_without_mesh(const SceneFile& file, const Folders& folders);

// Throws where there is neither what is chosen nor what may take its place.
bool takes_stand_in(const SceneFile& file, SceneChoice choice, const Folders& folders);

// Whether load_scene() will find these scenes and their meshes: throws what it would throw for want of a file
// or for a mistake in a scene file, of all of them together. For before a run, that may load the last of its
// scenes hours later.
void require_scenes(const std::set<std::string>& names, SceneChoice choice, const Folders& scene_dirs);

}  // namespace ctpbench
