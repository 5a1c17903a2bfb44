// Fuzzes the way from an OBJ file and its MTL file to triangles and materials. An input holds both: what is
// behind a line "MTL" is the text of every material library that the mesh names.
#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "kernels/platform.h"
#include "scene/material_library.h"
#include "scene/obj_mesh.h"

namespace {

using namespace ctpbench;

// What the rest of the program takes for granted.
void check(const ObjMesh& obj, const MeshMaterials& found) {
    const Mesh& mesh = obj.mesh;
    if (mesh.triangles.empty() || mesh.material.size() != mesh.triangles.size()) trap();
    if (!mesh.texcoords.empty() && mesh.texcoords.size() != mesh.triangles.size()) trap();
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= mesh.positions.size()) trap();
    for (const std::uint32_t material : mesh.material)
        if (material >= found.materials.size()) trap();
    if (found.textures.size() != found.materials.size()) trap();
    for (const TextureFiles& files : found.textures)
        for (const std::filesystem::path& path : {files.color, files.mask})
            if (!path.empty() && !path.lexically_normal().string().starts_with("folder/")) trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view separator = "\nMTL\n";
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::size_t end = std::min(input.find(separator), size);
    const std::string mtl(input.substr(std::min(end + separator.size(), size)));
    try {
        const ObjMesh mesh = parse_obj(input.substr(0, end), "folder/fuzz.obj");
        std::vector<MtlText> libraries;
        for (const ObjName& name : mesh.libraries) libraries.push_back({name.name, mtl});
        Notices notices;
        check(mesh, find_materials(mesh, libraries, "folder/fuzz.obj", notices));
    } catch (const Error& error) {
        if (error.code() != ExitCode::usage || std::string_view(error.what()).empty()) trap();
    }
    return 0;
}
