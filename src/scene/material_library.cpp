#include "scene/material_library.h"

#include <tiny_obj_loader.h>

#include <fstream>
#include <map>
#include <string>

#include "base/error.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamesInNotice = 3;

struct Library {
    std::map<std::string, int> ids;  // the form that tinyobjloader fills
    std::vector<tinyobj::material_t> materials;
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
}

float clamp_to_unit(float value) { return value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f; }  // NaN: 0

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

std::vector<Material> read_materials(const ObjMesh& mesh, const fs::path& obj_path, Notices& notices) {
    Library library;
    for (const ObjName& name : mesh.libraries) read_library(name, obj_path, library, notices);

    std::vector<Material> materials;
    std::vector<const ObjName*> unknown;
    for (const ObjName& used : mesh.materials) {
        Material material;
        material.name = used.name.empty() ? "default" : used.name;
        if (const auto found = library.ids.find(used.name); found != library.ids.end()) {
            const tinyobj::real_t* diffuse =
                library.materials[static_cast<std::size_t>(found->second)].diffuse;
            for (int channel = 0; channel < 3; ++channel)
                material.look.diffuse[channel] = clamp_to_unit(diffuse[channel]);
        } else if (!used.name.empty()) {
            unknown.push_back(&used);
        }
        materials.push_back(std::move(material));
    }
    notice_unknown(unknown, obj_path, notices);
    return materials;
}

}  // namespace ctpbench
