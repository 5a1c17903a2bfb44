#include "report/peers.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "measure/statistics.h"
#include "report/csv.h"

namespace ctpbench {
namespace {

constexpr const char* kIntersect1 = "embree_default";

// The scene, with what else tells its workloads apart: `conference`, `smoke/200`.
std::string scene_of(const Workload& workload) {
    const std::string name = workload.name(), bare = workload.scene + "/0";
    return name == bare ? workload.scene : name;
}

std::string rays_of(std::uint32_t bounce) {
    return bounce == 0 ? "primary" : "bounce" + std::to_string(bounce);
}

bool is_shown(const CellResult& cell) {
    return cell.valid && !cell.contender.renders() && cell.contender.backend == "cpu";
}

const BounceSeries* find(const CellResult* cell, std::uint32_t bounce) {
    if (cell == nullptr || !is_shown(*cell)) return nullptr;
    for (const BounceSeries& series : cell->bounces)
        if (series.bounce == bounce && !series.mrays.empty()) return &series;
    return nullptr;
}

// The bounces and workloads that are there, each once, in order of appearance.
std::vector<std::pair<Workload, std::uint32_t>> sections(const Results& results) {
    std::vector<std::pair<Workload, std::uint32_t>> all;
    for (const CellResult& cell : results.cells)
        for (const BounceSeries& series : cell.bounces)
            if (const std::pair section(cell.workload, series.bounce);
                std::find(all.begin(), all.end(), section) == all.end())
                all.push_back(section);
    return all;
}

}  // namespace

std::string peers_csv(const Results& results, int threads) {
    std::string out = csv_line({"scene", "rays", "contender", "threads", "median_mrays_s",
                                "ratio_to_rtcintersect1", "ratio_lo", "ratio_hi", "mismatch_rate"});
    for (const auto& [workload, bounce] : sections(results))
        for (const CellResult& cell : results.cells) {
            if (cell.workload != workload) continue;
            const BounceSeries* series = find(&cell, bounce);
            if (series == nullptr) continue;
            Contender c = cell.contender;
            const BounceSeries* yardstick =
                find(results.find(workload, kIntersect1 + c.threads_part()), bounce);
            constexpr double nan = std::numeric_limits<double>::quiet_NaN();
            Estimate ratio{nan, nan, nan};
            if (yardstick != nullptr && yardstick->mrays.size() == series->mrays.size())
                ratio = estimate_paired_ratio(series->mrays, yardstick->mrays);
            const std::uint32_t own = c.threads;
            c.threads = 0;
            const Verdict& verdict = series->against_reference;
            out += csv_line({scene_of(workload), rays_of(bounce), c.label(),
                             own == 0 ? std::to_string(threads) : std::to_string(own),
                             csv_number(median(series->mrays)), csv_number(ratio.median),
                             csv_number(ratio.lo), csv_number(ratio.hi),
                             verdict.rays == 0 ? "" : csv_number(verdict.mismatch_rate())});
        }
    return out;
}

}  // namespace ctpbench
