#include "report/meta_comparison.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ctpbench {
namespace {

using nlohmann::json;

json at(const json& meta, const char* pointer) {
    const json::json_pointer p(pointer);
    return meta.contains(p) ? meta.at(p) : json();
}

std::string shown(const json& value) {
    constexpr std::size_t kLongest = 60;
    std::string text = value.is_null() ? "nothing" : value.dump();
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

void compare(const json& there, const json& here, const std::vector<const char*>& pointers,
             std::vector<std::string>& lines) {
    for (const char* pointer : pointers) {
        const json theirs = at(there, pointer), ours = at(here, pointer);
        for (const json& step : json::diff(theirs, ours)) {
            const auto path = step.at("path").get<std::string>();
            // An element appended to a list has no place in the other.
            const json::json_pointer place(path);
            const json before = path.ends_with("/-") || !theirs.contains(place) ? json() : theirs.at(place);
            const json after = step.contains("value") ? step.at("value") : json();
            lines.push_back(pointer + path + ": " + shown(before) + " there, " + shown(after) + " here");
        }
    }
}

}  // namespace

json read_meta(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / "meta.json";
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(ExitCode::usage, path.string() + ": error: cannot be read; name the folder of a run");
    // What is nested deeper is none of ours, and to compare it takes a stack frame a level.
    constexpr int kDeepest = 64;
    const auto shallow = [](int depth, json::parse_event_t, json&) { return depth <= kDeepest; };
    json meta = json::parse(file, shallow, false);
    if (!meta.is_object())
        throw Error(ExitCode::usage, path.string() + ": error: is no JSON object; name the folder of a run");
    return meta;
}

std::vector<std::string> differences(const json& there, const json& here) {
    std::vector<std::string> lines;
    compare(there, here,
            {"/schema_version", "/config", "/workloads", "/threads", "/isa", "/build/version",
             "/build/git_commit", "/build/compiler", "/build/flags", "/build/build_type", "/build/embree"},
            lines);
    // A commit says what a program is made of unless something was changed since.
    const json clean(false);
    if (at(there, "/build/git_dirty") != clean || at(here, "/build/git_dirty") != clean)
        compare(there, here, {"/build/program"}, lines);
    return lines;
}

std::vector<std::string> differences_of_machine(const json& there, const json& here) {
    std::vector<std::string> lines;
    compare(there, here, {"/machine/cpu", "/machine/cpu_model", "/gpu/name", "/shard"}, lines);
    return lines;
}

}  // namespace ctpbench
