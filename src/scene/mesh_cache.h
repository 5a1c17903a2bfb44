// Parsed OBJ files, kept by what they contain. San Miguel's text takes seconds to parse and its triangles a
// fraction of one to read back. Only what the OBJ file itself says is kept; its MTL files are small and are
// read every time, so a change in one always shows.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/notices.h"
#include "scene/obj_mesh.h"

namespace ctpbench {

// $CTPBENCH_CACHE, or ~/.cache/ctpbench/parsed; nothing if neither variable is set.
std::optional<std::filesystem::path> mesh_cache_folder();

// As parse_obj() for the file, through the cache if there is a folder. A damaged cache file is replaced, and
// a folder that cannot be written is noticed; neither is an error. Throws Error(scene_missing) if the OBJ
// file cannot be read.
ObjMesh load_obj(const std::filesystem::path& path, const std::optional<std::filesystem::path>& cache_folder,
                 Notices& notices);

}  // namespace ctpbench
