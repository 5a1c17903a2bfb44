#include "scene/mesh_cache.h"

#include <cstdlib>
#include <system_error>

#include "base/error.h"
#include "scene/cached_mesh.h"
#include "scene/mapped_file.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

std::optional<ObjMesh> read_if_there(const fs::path& path, const MeshKey& key, Notices& notices) {
    std::error_code code;
    if (!fs::exists(path, code)) return std::nullopt;
    try {
        if (auto mesh = read_cached_mesh(path, key)) return mesh;
        notices.push_back("the cached mesh " + path.string() + " is damaged; it is written anew");
    } catch (const std::system_error& error) {
        notices.push_back("the cached mesh " + path.string() + " cannot be read (" + error.code().message() +
                          "); the OBJ file is parsed again");
    }
    return std::nullopt;
}

void write_if_possible(const fs::path& path, const MeshKey& key, const ObjMesh& mesh, Notices& notices) {
    try {
        write_cached_mesh(path, key, mesh);
    } catch (const std::system_error& error) {
        notices.push_back("the parsed mesh cannot be kept in " + path.parent_path().string() + " (" +
                          error.code().message() +
                          "), so the next start parses again; CTPBENCH_CACHE names another folder");
    }
}

}  // namespace

std::optional<fs::path> mesh_cache_folder() {
    const char* folder = std::getenv("CTPBENCH_CACHE");
    if (folder != nullptr && *folder != '\0') return fs::path(folder);
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home != '\0') return fs::path(home) / ".cache" / "ctpbench" / "parsed";
    return std::nullopt;
}

ObjMesh load_obj(const fs::path& path, const std::optional<fs::path>& cache_folder, Notices& notices) {
    const auto file = [&] {
        try {
            return MappedFile(path);
        } catch (const std::system_error& error) {
            throw Error(ExitCode::scene_missing,
                        path.string() + ": the OBJ file cannot be read: " + error.code().message());
        }
    }();
    if (!cache_folder) return parse_obj(file.bytes(), path.string());

    const MeshKey key = MeshKey::of(file.bytes());
    const fs::path cached = *cache_folder / key.file_name();
    if (auto mesh = read_if_there(cached, key, notices)) return std::move(*mesh);
    ObjMesh mesh = parse_obj(file.bytes(), path.string());
    write_if_possible(cached, key, mesh, notices);
    return mesh;
}

}  // namespace ctpbench
