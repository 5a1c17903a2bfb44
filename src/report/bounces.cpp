#include "report/bounces.h"

#include <algorithm>

namespace ctpbench {

std::string scene_of(const Workload& workload) {
    const std::string name = workload.name(), bare = workload.scene + "/0";
    return name == bare ? workload.scene : name;
}

std::string rays_of(std::uint32_t bounce) {
    return bounce == 0 ? "primary" : "bounce" + std::to_string(bounce);
}

const BounceSeries* cpu_series(const CellResult* cell, std::uint32_t bounce) {
    if (cell == nullptr || !cell->valid || cell->contender.renders() || cell->contender.backend != "cpu")
        return nullptr;
    for (const BounceSeries& series : cell->bounces)
        if (series.bounce == bounce && !series.mrays.empty()) return &series;
    return nullptr;
}

std::string threads_of(const Contender& contender, int threads) {
    return contender.threads == 0 ? std::to_string(threads) : std::to_string(contender.threads);
}

std::string label_without_threads(Contender contender) {
    contender.threads = 0;
    return contender.label();
}

std::vector<std::pair<Workload, std::uint32_t>> recorded_bounces(const Results& results) {
    std::vector<std::pair<Workload, std::uint32_t>> all;
    for (const CellResult& cell : results.cells)
        for (const BounceSeries& series : cell.bounces)
            if (const std::pair section(cell.workload, series.bounce);
                std::find(all.begin(), all.end(), section) == all.end())
                all.push_back(section);
    return all;
}

}  // namespace ctpbench
