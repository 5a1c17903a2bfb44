#include "scene/find_scene.h"

#include "base/error.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

// The mesh of an OBJ that is named in place of a scene file.
SceneFile bare_obj(const fs::path& path) {
    SceneFile file;
    file.path = path;
    file.name = path.stem().string();
    file.meshes.emplace_back().files = {path.string()};
    return file;
}

}  // namespace

SceneFile find_and_read(const std::string& name, Folders& folders) {
    const fs::path path(name);
    if (path.extension() == ".obj") {
        folders.insert(folders.begin(), fs::current_path());
        return bare_obj(path);
    }
    if (path.extension() != ".json") return read_scene_file(find_scene_file(name, folders));
    folders.insert(folders.begin(), fs::absolute(path).parent_path());  // its meshes may lie beside it
    return read_scene_file(path);
}

std::optional<FoundMesh> find_mesh(const SceneFile& file, const Folders& folders) {
    for (const fs::path& folder : folders) {
        for (const MeshEdition& edition : file.meshes) {
            if (const auto path = find_file(edition.files, {folder})) return FoundMesh{&edition, *path};
        }
    }
    return std::nullopt;
}

void fail_without_mesh(const SceneFile& file, const Folders& folders) {
    std::string text = "scene \"" + file.name + "\": ";
    if (file.recipe) {
        throw Error(ExitCode::scene_missing,
                    text + "it is procedural and has no mesh; ask for \"auto\" or \"stand-in\"");
    }
    text += "its mesh was not found. Looked for\n";
    bool in_folders = false;
    for (const MeshEdition& edition : file.meshes) {
        for (const std::string& name : edition.files) {
            text += "  " + name + "\n";
            in_folders = in_folders || !fs::path(name).is_absolute();
        }
    }
    if (in_folders) {
        text += "in\n";
        for (const fs::path& folder : folders) text += "  " + folder.string() + "\n";
        text +=
            "scripts/fetch_scenes downloads the known meshes; --scene-dir or CTPBENCH_SCENES names another "
            "folder";
    } else {
        text += "check the path";
    }
    throw Error(ExitCode::scene_missing, text);
}

bool takes_stand_in(const SceneFile& file, SceneChoice choice, const Folders& folders) {
    if (choice == SceneChoice::real && file.recipe) fail_without_mesh(file, folders);
    if (file.recipe) return false;
    if (choice == SceneChoice::stand_in) {
        if (!file.stand_in.empty()) return true;
        throw Error(ExitCode::usage,
                    "scene \"" + file.name + "\" has no stand-in; ask for \"auto\" or \"real\"");
    }
    if (find_mesh(file, folders)) return false;
    if (choice == SceneChoice::auto_ && !file.stand_in.empty()) return true;
    fail_without_mesh(file, folders);
}

void require_scenes(const std::set<std::string>& names, SceneChoice choice, const Folders& scene_dirs) {
    std::string problems;
    ExitCode code = ExitCode::scene_missing;
    for (const std::string& name : names) {
        try {
            Folders folders = scene_search_path(scene_dirs);
            const SceneFile file = find_and_read(name, folders);
            if (!takes_stand_in(file, choice, folders)) continue;
            read_scene_file(find_scene_file(file.stand_in, folders));
        } catch (const Error& error) {
            problems += (problems.empty() ? "" : "\n") + std::string(error.what());
            if (error.code() != ExitCode::scene_missing) code = error.code();
        }
    }
    if (!problems.empty()) throw Error(code, problems);
}

}  // namespace ctpbench
