#include "report/growth.h"

#include "measure/statistics.h"
#include "report/bounces.h"
#include "report/csv.h"

namespace ctpbench {

std::string growth_csv(const Results& results, int threads) {
    std::string out =
        csv_line({"scene", "triangles", "rays", "contender", "threads", "ns_per_ray", "lo_ns", "hi_ns"});
    for (const auto& [workload, bounce] : recorded_bounces(results))
        for (const CellResult& cell : results.cells) {
            if (cell.workload != workload) continue;
            const BounceSeries* series = cpu_series(&cell, bounce);
            if (series == nullptr) continue;
            std::vector<double> ns;
            for (const double mrays : series->mrays) ns.push_back(1000 / mrays);
            const Estimate cost = estimate_median(ns);
            out += csv_line({scene_of(workload), std::to_string(cell.triangles), rays_of(bounce),
                             label_without_threads(cell.contender), threads_of(cell.contender, threads),
                             csv_number(cost.median), csv_number(cost.lo), csv_number(cost.hi)});
        }
    return out;
}

}  // namespace ctpbench
