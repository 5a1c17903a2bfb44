#include "scene/material_library.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

#include "base/error.h"
#include "kernels/materials/list.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamesInNotice = 3;
constexpr float kMirrorExponent = 100.0f;  // a glossy lobe sharper than that counts as a mirror

// What the library makes of a material takes more than a kilobyte, and of a statement of ten bytes.
constexpr std::size_t kMostMaterials = 50'000;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;

struct Library {
    std::map<std::string, int> ids;  // the form that tinyobjloader fills
    std::vector<tinyobj::material_t> materials;
    std::vector<fs::path> folders;  // of each material's MTL file, relative to the OBJ's folder
};

bool leads_outside(const fs::path& name) {
    const fs::path normal = name.lexically_normal();
    return name.is_absolute() || normal.empty() || *normal.begin() == "..";
}

// Nothing if it cannot be read, which is noticed.
std::optional<MtlText> read_mtl(const ObjName& name, const fs::path& obj_path, Notices& notices) {
    const std::string mention =
        obj_path.string() + ":" + std::to_string(name.line) + ": material library \"" + name.name + "\"";
    if (leads_outside(name.name)) {
        throw Error(
            ExitCode::usage,
            mention + " is outside the OBJ file's folder and is not read; put it beside the OBJ file");
    }
    const fs::path path = obj_path.parent_path() / name.name;
    std::error_code failed;
    // Before it is opened: to open a named pipe is to wait for its writer.
    const std::uintmax_t size = fs::is_regular_file(path, failed) ? fs::file_size(path, failed) : 0;
    if (size > kMostBytes)
        throw Error(ExitCode::usage, mention + " has " + std::to_string(size) + " bytes; an MTL file has " +
                                         std::to_string(kMostBytes) + " at most, so split the mesh");
    std::ifstream stream;
    if (fs::is_regular_file(path, failed)) stream.open(path, std::ios::binary);
    MtlText mtl{name.name, std::string(size, '\0')};
    if (!stream.is_open() || !stream.read(mtl.text.data(), static_cast<std::streamsize>(size))) {
        notices.push_back(mention + " cannot be read; its materials get the default grey");
        return std::nullopt;
    }
    return mtl;
}

void parse_mtl(const MtlText& mtl, Library& library) {
    std::size_t statements = 0;
    for (std::size_t at = 0; (at = mtl.text.find("newmtl", at)) != std::string::npos; at += 6) ++statements;
    if (library.materials.size() + statements > kMostMaterials)
        throw Error(ExitCode::usage, "material library \"" + mtl.name + "\": a mesh has more than " +
                                         std::to_string(kMostMaterials) +
                                         " materials with it; name fewer, or split the mesh");
    std::istringstream stream(mtl.text);
    std::string warnings, errors;  // of no use here: they are about textures and transparency
    tinyobj::LoadMtl(&library.ids, &library.materials, &stream, &warnings, &errors);
    library.folders.resize(library.materials.size(), fs::path(mtl.name).parent_path());
}

float non_negative(float value) { return value > 0.0f && std::isfinite(value) ? value : 0.0f; }  // NaN: 0
Vec3 non_negative(const tinyobj::real_t* v) {
    return {non_negative(v[0]), non_negative(v[1]), non_negative(v[2])};
}
Vec3 reflectance(const tinyobj::real_t* v) { return min(non_negative(v), Vec3{1.0f, 1.0f, 1.0f}); }

std::uint32_t type_of(const MaterialDescription& look, int illum) {
    const Vec3 none{0.0f, 0.0f, 0.0f};
    if (look.emission != none) return material_type<Emissive>;
    if (look.specular == none) return material_type<Matte>;
    if (illum == 3 || illum == 5 || look.exponent > kMirrorExponent) return material_type<Mirror>;
    return material_type<Plastic>;
}

MaterialDescription describe(const tinyobj::material_t& given) {
    MaterialDescription look;
    look.diffuse = reflectance(given.diffuse);
    look.specular = reflectance(given.specular);
    look.exponent = non_negative(given.shininess);
    look.emission = non_negative(given.emission);
    look.type = type_of(look, given.illum);
    return look;
}

fs::path image_path(std::string name, const std::string& material, const fs::path& mtl_folder,
                    const fs::path& obj_path) {
    name.erase(name.find_last_not_of(" \t") + 1);
    if (name.empty()) return {};
    std::replace(name.begin(), name.end(), '\\', '/');
    // An absolute name replaces the folder, and is outside as well.
    if (!leads_outside(mtl_folder / name)) return obj_path.parent_path() / mtl_folder / name;
    throw Error(ExitCode::usage, obj_path.string() + ": material \"" + material + "\": its texture \"" +
                                     name +
                                     "\" is outside the OBJ file's folder and is not read; put it there and "
                                     "name it in the MTL file relative to that");
}

void notice_unknown(const std::vector<const ObjName*>& unknown, const fs::path& obj_path, Notices& notices) {
    if (unknown.empty()) return;
    std::string text = obj_path.string() + ":" + std::to_string(unknown.front()->line) + ": " +
                       std::to_string(unknown.size()) +
                       " of its materials are in no MTL file and get the default grey: ";
    for (std::size_t i = 0; i < unknown.size() && i < kNamesInNotice; ++i) {
        text += (i > 0 ? ", \"" : "\"") + unknown[i]->name + "\"";
    }
    if (unknown.size() > kNamesInNotice) text += ", ...";
    notices.push_back(text);
}

}  // namespace

std::vector<MtlText> read_libraries(const ObjMesh& mesh, const fs::path& obj_path, Notices& notices) {
    std::vector<MtlText> texts;
    for (const ObjName& name : mesh.libraries)
        if (auto mtl = read_mtl(name, obj_path, notices)) texts.push_back(std::move(*mtl));
    return texts;
}

MeshMaterials find_materials(const ObjMesh& mesh, const std::vector<MtlText>& libraries,
                             const fs::path& obj_path, Notices& notices) {
    Library library;
    for (const MtlText& mtl : libraries) parse_mtl(mtl, library);

    MeshMaterials out;
    std::vector<const ObjName*> unknown;
    for (const ObjName& used : mesh.materials) {
        Material& material = out.materials.emplace_back();
        TextureFiles& textures = out.textures.emplace_back();
        material.name = used.name.empty() ? "default" : used.name;
        if (const auto found = library.ids.find(used.name); found != library.ids.end()) {
            const auto at = static_cast<std::size_t>(found->second);
            const tinyobj::material_t& given = library.materials[at];
            material.look = describe(given);
            textures.color = image_path(given.diffuse_texname, used.name, library.folders[at], obj_path);
            textures.mask = image_path(given.alpha_texname, used.name, library.folders[at], obj_path);
        } else if (!used.name.empty()) {
            unknown.push_back(&used);
        }
    }
    notice_unknown(unknown, obj_path, notices);
    return out;
}

MeshMaterials read_materials(const ObjMesh& mesh, const fs::path& obj_path, Notices& notices) {
    return find_materials(mesh, read_libraries(mesh, obj_path, notices), obj_path, notices);
}

}  // namespace ctpbench
