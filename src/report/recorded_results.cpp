#include "report/recorded_results.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "config/cells.h"
#include "report/csv_table.h"
#include "report/figures.h"
#include "report/meta_comparison.h"
#include "wavefront/cuda_workload.h"

namespace ctpbench {
namespace {

// What identifies the place where a yardstick is looked for, and the contender there.
constexpr const char* place_columns[] = {"scene",         "scene_source", "triangles", "spheres",
                                         "sphere_radius", "builder",      "backend",   "threads"};
constexpr const char* contender_columns[] = {"strategy", "restart_carries_t", "traversal",   "methods",
                                             "types",    "triangle_test",     "sphere_test", "box_test",
                                             "offset",   "bounce_limit",      "roulette",    "shade",
                                             "launch"};

template <std::size_t N>
std::string joined(const CsvTable& table, std::size_t line, const char* const (&columns)[N]) {
    std::string key;
    for (const char* column : columns) key += table.field(line, table.column(column)) + "|";
    return key;
}

Contender contender_of(const CsvTable& table, std::size_t line) {
    const auto text = [&](const char* name) { return table.field(line, table.column(name)); };
    const auto whole = [&](const char* name) {
        return static_cast<std::uint32_t>(table.number(line, table.column(name)));
    };
    Contender c;
    c.backend = text("backend"), c.strategy = text("strategy");
    c.restart_carries_t = text("restart_carries_t") == "true";
    c.traversal = text("traversal"), c.methods = text("methods"), c.shade = text("shade");
    c.launch = text("launch"), c.types = text("types"), c.offset = text("offset");
    c.triangle_test = text("triangle_test"), c.sphere_test = text("sphere_test"),
    c.box_test = text("box_test");
    c.bounce_limit = whole("bounce_limit"), c.roulette = text("roulette") == "true";
    c.threads = c.backend == "cpu" ? whole("threads") : 0;
    return c;
}

Workload workload_of(const CsvTable& table, std::size_t line) {
    return {table.field(line, table.column("scene")),
            static_cast<std::uint32_t>(table.number(line, table.column("spheres"))),
            table.number(line, table.column("sphere_radius")), table.field(line, table.column("builder"))};
}

// Neither what runs inside another stage, nor what is timed beside the contenders.
bool is_shown(std::string_view kernel) { return kernel != "copy" && !kernel.starts_with("shade_"); }

// Adds one run's rows.
class Reader {
public:
    Reader(RecordedResults& results, const CsvTable& table, std::string file)
        : results_(results), table_(table), file_(std::move(file)) {}

    void read() {
        const std::size_t kernel = table_.column("kernel"), run = table_.column("run_id");
        const std::size_t valid = table_.column("valid"), hash = table_.column("hit_hash");
        const std::size_t bounce = table_.column("bounce"), round = table_.column("round");
        const std::size_t active = table_.column("active_rays"), rays = table_.column("rays");
        const std::size_t time = table_.column("time_ms");
        for (std::size_t i = 0; i < table_.lines(); ++i) {
            if (!is_shown(table_.field(i, kernel))) continue;
            RecordedKernel& k = kernel_of(i, table_.field(i, kernel));
            if (table_.field(i, valid) == "false") k.valid = false;
            const double b = table_.number(i, bounce), milliseconds = table_.number(i, time);
            if (!(milliseconds > 0.0)) continue;  // of a check, which is not timed
            const RecordedKernel::Rays of_bounce{table_.number(i, active), table_.number(i, rays)};
            k.rays[b] = of_bounce;
            if (!table_.field(i, hash).empty()) k.hit_hash[b] = table_.field(i, hash);
            Sums& sums = sums_[{k.key, file_ + "#" + table_.field(i, run)}][table_.number(i, round)];
            ++sums.bounces;
            // As in the contest: a batch stands for all paths that were active at its bounce.
            sums.rays += of_bounce.active;
            sums.milliseconds += milliseconds * of_bounce.active / of_bounce.timed;
        }
        for (RecordedKernel& k : results_.kernels)
            for (const auto& [whose, rounds] : sums_) {
                if (whose.first != k.key) continue;
                for (const auto& [number, sums] : rounds) {
                    if (sums.bounces == k.rays.size())
                        k.runs[whose.second][number] = sums.rays / sums.milliseconds * 1e-3;
                    else
                        ++k.incomplete;
                }
            }
    }

private:
    struct Sums {
        std::size_t bounces = 0;
        double rays = 0.0, milliseconds = 0.0;
    };

    RecordedKernel& kernel_of(std::size_t line, const std::string& kernel) {
        const std::string place = joined(table_, line, place_columns);
        const std::string key = place + joined(table_, line, contender_columns) + kernel;
        const auto found = std::find_if(results_.kernels.begin(), results_.kernels.end(),
                                        [&](const RecordedKernel& k) { return k.key == key; });
        if (found != results_.kernels.end()) return *found;
        const Contender contender = contender_of(table_, line);
        RecordedKernel& k = results_.kernels.emplace_back();
        k.key = key, k.place = place;
        k.name = workload_of(table_, line).name() + "/" + contender.label() + ", " + kernel;
        k.yardstick = contender.is_yardstick(), k.renders = contender.renders();
        k.normalises = contender.strategy == kYardstick || contender.strategy == kCudaYardstick;
        return k;
    }

    RecordedResults& results_;
    const CsvTable& table_;
    std::string file_;
    std::map<std::pair<std::string, std::string>, std::map<double, Sums>> sums_;  // by key and run, by round
};

}  // namespace

const RecordedKernel* RecordedResults::find(const std::string& key) const {
    for (const RecordedKernel& k : kernels)
        if (k.key == key) return &k;
    return nullptr;
}

const RecordedKernel* RecordedResults::yardstick_of(const RecordedKernel& kernel) const {
    if (kernel.renders || kernel.normalises) return nullptr;
    for (const RecordedKernel& k : kernels)
        if (k.normalises && k.valid && k.place == kernel.place) return &k;
    return nullptr;
}

std::vector<std::vector<double>> speeds_of(const RecordedKernel& kernel, const RecordedKernel* yardstick) {
    std::vector<std::vector<double>> speeds;
    for (const auto& [run, rounds] : kernel.runs) {
        std::vector<double>& of_run = speeds.emplace_back();
        for (const auto& [round, mrays] : rounds) {
            if (yardstick == nullptr) {
                of_run.push_back(mrays);
                continue;
            }
            const auto same_run = yardstick->runs.find(run);
            if (same_run == yardstick->runs.end()) continue;
            const auto same_round = same_run->second.find(round);
            if (same_round != same_run->second.end()) of_run.push_back(mrays / same_round->second);
        }
        if (of_run.empty()) speeds.pop_back();
    }
    return speeds;
}

RecordedResults read_results(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> runs;
    std::error_code failed;
    if (std::filesystem::exists(folder / "rows.csv", failed)) {
        runs.push_back(folder);
    } else {
        for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
            if (std::filesystem::exists(entry.path() / "rows.csv", failed)) runs.push_back(entry.path());
        std::sort(runs.begin(), runs.end());
    }
    if (runs.empty())
        throw Error(ExitCode::usage, folder.string() +
                                         ": error: no results here: neither a rows.csv nor folders that hold "
                                         "one; name a folder that --out named");
    RecordedResults results;
    results.folder = folder;
    for (const std::filesystem::path& run : runs) {
        results.meta.push_back(std::filesystem::exists(run / "meta.json", failed) ? read_meta(run)
                                                                                  : nlohmann::json());
        Reader(results, CsvTable::load(run / "rows.csv"), run.string()).read();
    }
    return results;
}

}  // namespace ctpbench
