#include "run_folder.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/hash.h"
#include "report/image.h"
#include "report/meta_comparison.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

void add(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

void refuse(const fs::path& folder, const std::vector<std::string>& differences) {
    if (differences.empty()) return;
    constexpr std::size_t kShown = 12;
    std::string text = folder.string() + ": error: cannot be resumed, it holds another run:\n";
    for (std::size_t i = 0; i < std::min(kShown, differences.size()); ++i)
        text += "  " + differences[i] + "\n";
    if (differences.size() > kShown)
        text += "  and " + std::to_string(differences.size() - kShown) + " more\n";
    throw Error(ExitCode::usage,
                text +
                    "repeat the command that began it, with the same program and scenes on the "
                    "same machine, or name another folder with --out");
}

// Each scene is looked at once, in the first workload that was finished in it.
std::vector<std::string> scenes_that_changed(const FinishedLog& log, const RunRecord& run,
                                             const LookAtScene& look) {
    std::vector<std::string> lines;
    std::set<std::string> seen;
    for (const FinishedWorkload& done : log.workloads)
        for (const SceneResult& then : done.results.scenes) {
            if (!seen.insert(then.name).second) continue;
            for (const PlannedWorkload& w : run.workloads) {
                if (w.hash != done.hash) continue;
                const SceneResult now = look(w.cells.workload);
                if (now.hash != then.hash || now.base_hash != then.base_hash)
                    lines.push_back("scene " + then.name + ": hash " + hex(then.hash) + "/" +
                                    hex(then.base_hash) + ", " + then.source + " there, " + hex(now.hash) +
                                    "/" + hex(now.base_hash) + ", " + now.source + " here");
            }
        }
    return lines;
}

// What was said of the run before.
void take_over(const nlohmann::json& there, const fs::path& folder, std::size_t kept, RunRecord& run) {
    try {
        there.at("run_id").get_to(run.run_id);
        for (const nlohmann::json& r : there.at("resumed"))
            run.resumed.push_back({r.at("command"), r.at("workloads_kept")});
        run.resumed.push_back({run.command, kept});
        there.at("command").get_to(run.command);
    } catch (const nlohmann::json::exception& e) {
        throw Error(ExitCode::usage, (folder / "meta.json").string() + ": error: is not what a run writes (" +
                                         e.what() + "); begin anew in another folder with --out");
    }
}

}  // namespace

FinishedLog open_run_folder(const fs::path& folder, const Config& config, RunRecord& run, bool resume,
                            const LookAtScene& look) {
    FinishedLog log;
    std::error_code ignored;
    // Of a run that is started, meta.json is written first.
    if (resume && fs::exists(folder / "meta.json", ignored)) {
        const nlohmann::json there = read_meta(folder), here = meta_of(config, run, {}, "running");
        std::vector<std::string> different = differences(there, here);
        add(different, differences_of_machine(there, here));
        refuse(folder, different);
        log = read_finished(folder);
        refuse(folder, scenes_that_changed(log, run, look));
        take_over(there, folder, log.workloads.size(), run);
    } else if (fs::exists(folder / "rows.csv", ignored)) {
        throw Error(ExitCode::output,
                    folder.string() +
                        ": error: holds the results of another run; name another folder with "
                        "--out, move this one away, or go on with it with --resume");
    }
    require_output_folder(folder);
    if (config.images) require_image_output(folder / "image.exr");
    Results kept;
    for (const FinishedWorkload& w : log.workloads) append(kept, w.results);
    write_meta(folder, meta_of(config, run, kept, "running"));
    return log;
}

}  // namespace ctpbench
