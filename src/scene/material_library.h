// The MTL files of an OBJ file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/notices.h"
#include "scene/obj_mesh.h"
#include "scene/textures.h"

namespace ctpbench {

struct MeshMaterials {
    std::vector<Material> materials;     // one for each of ObjMesh::materials
    std::vector<TextureFiles> textures;  // map_Kd and map_d of each; not read yet
};

struct MtlText {
    std::string name;  // as the OBJ file gives it
    std::string text;
};

// The MTL files that the mesh names; one that cannot be read is noticed. Throws Error(usage) for one outside
// the OBJ's folder, since a mesh must not make us read elsewhere, and for too many or too large ones.
std::vector<MtlText> read_libraries(const ObjMesh& mesh, const std::filesystem::path& obj_path,
                                    Notices& notices);

// A material is
//     emissive  if its Ke is above 0,
//     matte     if its Ks is 0,
//     mirror    if its illum is 3 or 5 or its Ns above 100,
//     plastic   else.
// Kd and Ks are clamped to [0, 1]; what is negative, infinite or no number is 0. A material that is in no MTL
// file is noticed, and is grey and matte. Throws Error(usage) for an image outside the OBJ's folder.
MeshMaterials find_materials(const ObjMesh& mesh, const std::vector<MtlText>& libraries,
                             const std::filesystem::path& obj_path, Notices& notices);

// Both.
MeshMaterials read_materials(const ObjMesh& mesh, const std::filesystem::path& obj_path, Notices& notices);

}  // namespace ctpbench
