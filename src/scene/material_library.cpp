#include "scene/material_library.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include "base/error.h"
#include "kernels/materials/list.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamesInNotice = 3;
constexpr float kMirrorExponent = 100.0f;  // a glossy lobe sharper than that counts as a mirror

struct Library {
    std::map<std::string, int> ids;  // the form that tinyobjloader fills
    std::vector<tinyobj::material_t> materials;
    std::vector<fs::path> folders;  // of each material's MTL file, relative to the OBJ's folder
};

bool leads_outside(const fs::path& name) {
    const fs::path normal = name.lexically_normal();
    return name.is_absolute() || normal.empty() || *normal.begin() == "..";
}

void read_library(const ObjName& name, const fs::path& obj_path, Library& library, Notices& notices) {
    const std::string mention =
        obj_path.string() + ":" + std::to_string(name.line) + ": material library \"" + name.name + "\"";
    if (leads_outside(name.name)) {
        throw Error(
            ExitCode::usage,
            mention + " is outside the OBJ file's folder and is not read; put it beside the OBJ file");
    }
    const fs::path path = obj_path.parent_path() / name.name;
    std::ifstream stream(path, std::ios::binary);
    if (!fs::is_regular_file(path) || !stream) {
        notices.push_back(mention + " cannot be read; its materials get the default grey");
        return;
    }
    std::string warnings, errors;  // of no use here: they are about textures and transparency
    tinyobj::LoadMtl(&library.ids, &library.materials, &stream, &warnings, &errors);
    library.folders.resize(library.materials.size(), fs::path(name.name).parent_path());
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

MeshMaterials read_materials(const ObjMesh& mesh, const fs::path& obj_path, Notices& notices) {
    Library library;
    for (const ObjName& name : mesh.libraries) read_library(name, obj_path, library, notices);

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

}  // namespace ctpbench
