// Where scene files and meshes are looked for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ctpbench {

using Folders = std::vector<std::filesystem::path>;

// Absolute, each once, in this order: the given folders, those of $CTPBENCH_SCENES (separated by colons),
// ~/.cache/ctpbench/scenes, the scenes/ folder of the source tree the program was built from, ./scenes.
Folders scene_search_path(const Folders& scene_dirs);

// The first folder that holds one of the files wins, and in it the first file.
std::optional<std::filesystem::path> find_file(const std::vector<std::string>& files, const Folders& folders);

// The names of all scene files there, sorted.
std::vector<std::string> scene_names(const Folders& folders);

// The scene file NAME.json. Throws Error(usage) that lists the scenes there are.
std::filesystem::path find_scene_file(const std::string& name, const Folders& folders);

}  // namespace ctpbench
