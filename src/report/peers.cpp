#include "report/peers.h"

#include <limits>

#include "measure/statistics.h"
#include "report/bounces.h"
#include "report/csv.h"

namespace ctpbench {

std::string peers_csv(const Results& results, int threads) {
    constexpr const char* intersect1 = "embree_default";
    std::string out = csv_line({"scene", "rays", "contender", "threads", "median_mrays_s",
                                "ratio_to_rtcintersect1", "ratio_lo", "ratio_hi", "mismatch_rate"});
    for (const auto& [workload, bounce] : recorded_bounces(results))
        for (const CellResult& cell : results.cells) {
            if (cell.workload != workload) continue;
            const BounceSeries* series = cpu_series(&cell, bounce);
            if (series == nullptr) continue;
            const Contender& c = cell.contender;
            const BounceSeries* yardstick =
                cpu_series(results.find(workload, intersect1 + c.threads_part()), bounce);
            constexpr double nan = std::numeric_limits<double>::quiet_NaN();
            Estimate ratio{nan, nan, nan};
            if (yardstick != nullptr && yardstick->mrays.size() == series->mrays.size())
                ratio = estimate_paired_ratio(series->mrays, yardstick->mrays);
            const Verdict& verdict = series->against_reference;
            out += csv_line({scene_of(workload), rays_of(bounce), label_without_threads(c),
                             threads_of(c, threads), csv_number(median(series->mrays)),
                             csv_number(ratio.median), csv_number(ratio.lo), csv_number(ratio.hi),
                             verdict.rays == 0 ? "" : csv_number(verdict.mismatch_rate())});
        }
    return out;
}

}  // namespace ctpbench
