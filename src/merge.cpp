#include "merge.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "base/json_document.h"
#include "config/config.h"
#include "contests.h"
#include "experiment.h"
#include "report/csv.h"
#include "report/finished.h"
#include "report/meta.h"
#include "report/meta_comparison.h"
#include "run_tables.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Part {
    fs::path folder;
    json meta;
    FinishedLog finished;
};

// One workload as one of the parts has it.
struct Found {
    const Part* part;
    const FinishedWorkload* workload;
};

void refuse_if_any(const std::vector<std::string>& mistakes) {
    if (mistakes.empty()) return;
    std::string text = "ctpbench merge: error: these are not the shards of one run:";
    for (const std::string& m : mistakes) text += "\n  " + m;
    throw Error(ExitCode::usage, text);
}

std::vector<Part> read_parts(const std::vector<fs::path>& folders) {
    std::vector<Part> parts;
    std::vector<std::string> mistakes;
    for (const fs::path& folder : folders) {
        Part& part = parts.emplace_back(Part{folder, read_meta(folder), {}});
        if (!part.meta.contains("workloads"))
            throw Error(ExitCode::usage, (folder / "meta.json").string() +
                                             ": error: does not say which workloads its run has; it is of an "
                                             "older program, whose results cannot be merged");
        for (const std::string& d : differences(part.meta, parts.front().meta))
            mistakes.push_back(folder.string() + ": " + d + " in " + folders.front().string());
    }
    refuse_if_any(mistakes);
    for (Part& part : parts) part.finished = read_finished(part.folder);
    return parts;
}

// The same scene must be the same wherever it was measured, whatever spheres were added to it.
void compare_scenes(const std::vector<Part>& parts, std::vector<std::string>& mistakes) {
    struct Seen {
        const Part* part;
        const SceneResult* scene;
    };
    std::map<std::string, Seen> seen;
    for (const Part& part : parts)
        for (const FinishedWorkload& w : part.finished.workloads)
            for (const SceneResult& scene : w.results.scenes) {
                const auto [first, added] = seen.try_emplace(scene.name, Seen{&part, &scene});
                if (added || first->second.scene->base_hash == scene.base_hash) continue;
                mistakes.push_back("scene " + scene.name + ": hash " + hex(scene.base_hash) + ", " +
                                   scene.source + " in " + part.folder.string() + ", " +
                                   hex(first->second.scene->base_hash) + ", " + first->second.scene->source +
                                   " in " + first->second.part->folder.string());
            }
}

// The run's workloads in its order.
std::vector<Found> find_all(const std::vector<Part>& parts, std::vector<std::string>& mistakes) {
    std::vector<Found> found;
    const json& planned = parts.front().meta.at("workloads");
    for (std::size_t i = 0; i < planned.size(); ++i) {
        const std::size_t before = found.size();
        const auto hash = planned[i].at("hash").get<std::string>();
        const auto name = planned[i].at("name").get<std::string>();
        for (const Part& part : parts)
            for (const FinishedWorkload& w : part.finished.workloads)
                if (w.hash == hash) found.push_back({&part, &w});
        if (found.size() == before)
            mistakes.push_back(name +
                               ": finished in none of the folders; finish its shard with --resume, or name "
                               "its folder too");
        for (std::size_t f = before + 1; f < found.size(); ++f)
            mistakes.push_back(name + ": finished in " + found[before].part->folder.string() + " and in " +
                               found[f].part->folder.string() + "; name one of them");
    }
    return found;
}

std::string header_of(const Part& part) {
    const std::string rows =
        read_part(part.folder / "rows.csv", 0, part.finished.workloads.front().rows_begin);
    return rows.substr(0, rows.find('\n') + 1);
}

// Copies the rows, and pictures if there are some.
void copy(const std::vector<Found>& found, const fs::path& out, bool pictures) {
    GrowingFile rows(out / "rows.csv");
    FinishedFile finished(out, 0);
    rows.append(header_of(*found.front().part));
    for (const Found& f : found) {
        const std::uint64_t begin = rows.size();
        rows.append(read_part(f.part->folder / "rows.csv", f.workload->rows_begin, f.workload->rows_end));
        finished.append(f.workload->hash, rows, begin, f.workload->results);
        if (!pictures || f.workload->results.cells.empty()) continue;
        const Workload& workload = f.workload->results.cells.front().workload;
        for (const auto& file : fs::directory_iterator(f.part->folder)) {
            const fs::path name = file.path().filename();
            if (is_picture_of(workload, name.string()))
                write_file(out / name, read_part(file.path(), 0, file.file_size()));
        }
    }
}

// What the first part has, with what all have in the place of its own; each part's own beside it.
json merged_meta(const std::vector<Part>& parts, const json& measured, const std::string& command) {
    json meta = parts.front().meta;
    for (const char* key : {"scenes", "trees", "oracle", "exams", "notices"}) meta[key] = measured.at(key);
    meta["run_id"] = meta.at("config").at("experiment").get<std::string>() + "-merged";
    meta["state"] = "complete", meta["command"] = command, meta["shard"] = Shard{}.text();
    meta["resumed"] = json::array();
    for (const Part& p : parts) {
        json own = {{"folder", p.folder.string()}};
        for (const char* key :
             {"run_id", "shard", "command", "resumed", "machine", "gpu", "peak_memory_bytes"})
            own[key] = p.meta.at(key);
        meta["parts"].push_back(own);
    }
    return meta;
}

ExitCode merge_parts(const std::vector<fs::path>& folders, const fs::path& out, const std::string& command) {
    const std::vector<Part> parts = read_parts(folders);
    std::vector<std::string> mistakes;
    compare_scenes(parts, mistakes);
    const std::vector<Found> found = find_all(parts, mistakes);
    refuse_if_any(mistakes);
    std::error_code failed;
    if (fs::exists(out / "rows.csv", failed))
        throw Error(ExitCode::output, out.string() +
                                          ": error: holds results already; name another folder with "
                                          "--out");
    require_output_folder(out);

    const json& first = parts.front().meta;
    const Config config = read_config(
        JsonDocument::parse(first.at("config").dump(), (parts.front().folder / "meta.json").string()),
        known_names());
    Results results;
    for (const Found& f : found) append(results, f.workload->results);
    const auto note = [&](const std::string& text) {
        if (std::find(results.notices.begin(), results.notices.end(), text) == results.notices.end())
            results.notices.push_back(text);
    };
    for (const Part& part : parts) {
        for (const json& n : part.meta.at("notices")) note(n);
        for (const char* key : {"/machine/cpu", "/machine/cpu_model", "/gpu/name"}) {
            const json::json_pointer pointer(key);
            if (part.meta.value(pointer, json()) == first.value(pointer, json())) continue;
            note("measured on unlike machines: " + std::string(key) + " is " +
                 part.meta.value(pointer, json()).dump() + " in " + part.folder.string() + " and " +
                 first.value(pointer, json()).dump() + " in " + parts.front().folder.string() +
                 "; ratios within a workload stand, speeds of different workloads do not compare");
            std::fprintf(stderr, "%s\n", results.notices.back().c_str());
        }
    }
    copy(found, out, config.images);
    write_tables(out, config, results, first.at("threads"));
    write_meta(out, merged_meta(parts, meta_of(config, {}, results, "complete"), command));
    std::printf("merged %zu workloads of %zu folders: %s\n", found.size(), parts.size(),
                out.string().c_str());
    const bool all_valid =
        std::all_of(results.cells.begin(), results.cells.end(), [](const CellResult& c) { return c.valid; });
    return all_valid ? ExitCode::ok : ExitCode::oracle;
}

}  // namespace

ExitCode merge_runs(const std::vector<fs::path>& folders, const fs::path& out, const std::string& command) {
    try {
        return merge_parts(folders, out, command);
    } catch (const json::exception& e) {
        throw Error(ExitCode::usage,
                    "ctpbench merge: error: meta.json in one of these folders is not what a run "
                    "writes (" +
                        std::string(e.what()) + "); measure that shard again");
    }
}

}  // namespace ctpbench
