// The MTL files of an OBJ file.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/notices.h"
#include "scene/obj_mesh.h"
#include "scene/textures.h"

namespace ctpbench {

struct MeshMaterials {
    std::vector<Material> materials;     // one for each of ObjMesh::materials
    std::vector<TextureFiles> textures;  // map_Kd and map_d of each; not read yet
};

// A material is
//     emissive  if its Ke is above 0,
//     matte     if its Ks is 0,
//     mirror    if its illum is 3 or 5 or its Ns above 100,
//     plastic   else.
// Kd and Ks are clamped to [0, 1]; what is negative, infinite or no number is 0. An MTL file that cannot be
// read and a material that is in none are noticed; such materials are grey and matte. Throws Error(usage) for
// an MTL file or an image outside the OBJ's folder: a mesh must not make us read elsewhere.
MeshMaterials read_materials(const ObjMesh& mesh, const std::filesystem::path& obj_path, Notices& notices);

}  // namespace ctpbench
