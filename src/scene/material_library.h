// The MTL files of an OBJ file.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/notices.h"
#include "scene/obj_mesh.h"

namespace ctpbench {

// One material for each of mesh.materials, its colour (Kd, clamped to [0, 1]) from the MTL files that the OBJ
// names. A file that cannot be read and a material that is in none are noticed; such materials keep the
// default colour. Throws Error(usage) for a file outside the OBJ's folder: a mesh must not make us read
// elsewhere.
std::vector<Material> read_materials(const ObjMesh& mesh, const std::filesystem::path& obj_path,
                                     Notices& notices);

}  // namespace ctpbench
