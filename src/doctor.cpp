#include "doctor.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "backends/cuda.h"
#include "measure/machine.h"
#include "report/health.h"
#include "scene/find_scene.h"
#include "scene/texture_image.h"
#include "wavefront/interleaved/isa.h"
#include "wavefront/type_choice.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;
using State = Diagnosis::State;

constexpr std::uintmax_t kLeastSpace = std::uintmax_t{1} << 30;

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

void add_parts(std::vector<Diagnosis>& diagnoses) {
    diagnoses.push_back(
        can_read_images()
            ? Diagnosis{State::ok, "OpenImageIO", "textures and pictures"}
            : Diagnosis{State::missing, "OpenImageIO", "not compiled in: no textures, no pictures",
                        "apt-get install libopenimageio-dev openimageio-tools, and build again"});
    const std::vector<std::string> types = type_choices();
    diagnoses.push_back(std::all_of(types.begin(), types.end(), types_built)
                            ? Diagnosis{State::ok, "types", "all lists"}
                            : Diagnosis{State::missing, "types", "long lists of synthetic types are left out",
                                        "build with -DCTPBENCH_FEW_TYPES=OFF"});
    diagnoses.push_back({State::ok, "instructions", joined(usable_isas())});
}

Diagnosis examine_cuda(const CommandLine& line) {
    const std::string obstacle = cuda_obstacle(line.device);
    const int toolkit = cuda_toolkit();
    const std::string built = toolkit == 0 ? ""
                                           : "toolkit " + std::to_string(toolkit / 1000) + "." +
                                                 std::to_string(toolkit % 1000 / 10) + ", ";
    if (obstacle.empty()) return {State::ok, "CUDA", built + use_cuda_device(line.device).name};
    Diagnosis diagnosis{State::missing, "CUDA", built + obstacle};
    if (std::find(line.backends.begin(), line.backends.end(), "cuda") != line.backends.end())
        diagnosis.failure = ExitCode::no_backend;
    return diagnosis;
}

// Without a trace: the folder need not be there yet.
Diagnosis examine_output(const CommandLine& line) {
    const fs::path folder = fs::absolute(line.out.empty() ? "results" : line.out);
    fs::path there = folder;
    std::error_code failed;
    while (!fs::exists(there, failed) && there.has_parent_path() && there != there.parent_path())
        there = there.parent_path();
    const std::uintmax_t space = fs::space(there, failed).available;
    const bool writable = fs::is_directory(there, failed) && ::access(there.c_str(), W_OK | X_OK) == 0;
    if (!writable || space == 0)
        return {State::missing, "output", folder.string() + " cannot be written", "name another with --out",
                ExitCode::output};
    if (space < kLeastSpace)
        return {State::warning, "output",
                folder.string() + " has " + std::to_string(space >> 20) + " MiB left",
                "free some space, or name another with --out"};
    return {State::ok, "output", folder.string()};
}

Diagnosis examine_scene(const std::string& name, const Folders& folders, SceneChoice choice) {
    Diagnosis diagnosis{State::ok, "scene " + name, ""};
    try {
        const SceneFile file = read_scene_file(find_scene_file(name, folders));
        if (file.recipe) {
            diagnosis.detail = "procedural";
            return diagnosis;
        }
        if (const auto mesh = find_mesh(file, folders)) {
            diagnosis.detail = mesh->path.string();
            return diagnosis;
        }
        diagnosis.state = State::missing;
        diagnosis.detail = file.stand_in.empty()
                               ? "its mesh is not here"
                               : "its mesh is not here, " + file.stand_in + " takes its place";
        diagnosis.remedy = "scripts/fetch_scenes";
        if (choice == SceneChoice::real || file.stand_in.empty()) diagnosis.failure = ExitCode::scene_missing;
    } catch (const Error& error) {
        diagnosis.state = State::missing;
        diagnosis.detail = error.what();
        diagnosis.failure = error.code();
    }
    return diagnosis;
}

}  // namespace

ExitCode examine(const CommandLine& line) {
    std::vector<Diagnosis> diagnoses = examine_build(describe_build());
    add_parts(diagnoses);
    diagnoses.push_back(examine_cuda(line));
    for (Diagnosis& f : examine_machine(describe_machine())) diagnoses.push_back(std::move(f));
    diagnoses.push_back(examine_output(line));
    const Folders folders = scene_search_path(line.scene_dirs);
    const std::vector<std::string> scenes = scene_names(folders);
    if (scenes.empty())
        diagnoses.push_back({State::missing, "scenes", "no scene files",
                             "--scene-dir names the folder that holds them", ExitCode::scene_missing});
    for (const std::string& name : scenes) diagnoses.push_back(examine_scene(name, folders, line.scenes));
    std::printf("%s", diagnoses_text(diagnoses).c_str());
    return exit_code_of(diagnoses);
}

}  // namespace ctpbench
