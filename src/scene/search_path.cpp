#include "scene/search_path.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/suggest.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

}  // namespace

std::vector<std::string> scene_names(const Folders& folders) {
    std::set<std::string> names;
    // Every NAME.json, except the list of downloads that scripts/fetch_scenes reads.
    for (const fs::path& folder : folders) {
        std::error_code code;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
            if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
        }
    }
    names.erase("manifest");
    return {names.begin(), names.end()};
}

Folders scene_search_path(const Folders& scene_dirs) {
    Folders folders;
    const auto add = [&](const fs::path& folder) {
        const fs::path absolute = fs::absolute(folder).lexically_normal();
        if (std::find(folders.begin(), folders.end(), absolute) == folders.end()) folders.push_back(absolute);
    };
    for (const fs::path& folder : scene_dirs) add(folder);
    std::stringstream listed(environment("CTPBENCH_SCENES"));
    for (std::string folder; std::getline(listed, folder, ':');) {
        if (!folder.empty()) add(folder);
    }
    if (const std::string home = environment("HOME"); !home.empty()) {
        add(fs::path(home) / ".cache" / "ctpbench" / "scenes");
    }
#ifdef CTPBENCH_SCENES_DIR
    add(CTPBENCH_SCENES_DIR);
#endif
    add("scenes");
    return folders;
}

std::optional<fs::path> find_file(const std::vector<std::string>& files, const Folders& folders) {
    for (const fs::path& folder : folders) {
        for (const std::string& file : files) {
            const fs::path path = folder / file;  // an absolute file replaces the folder
            std::error_code code;
            if (fs::is_regular_file(path, code)) return path;
        }
    }
    return std::nullopt;
}

fs::path find_scene_file(const std::string& name, const Folders& folders) {
    if (const auto path = find_file({name + ".json"}, folders)) return *path;
    throw Error(ExitCode::usage, unknown_name("scene", name, scene_names(folders)));
}

}  // namespace ctpbench
