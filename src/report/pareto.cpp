#include "report/pareto.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/statistics.h"
#include "report/csv.h"
#include "report/figures.h"

namespace ctpbench {
namespace {

bool is_shown(const Config& config, const CellResult& cell) {
    return cell.valid && cell.accuracy && !std::isnan(throughput_of(&cell).median) &&
           (cell.contender.is_yardstick() || cell.contender.strategy == config.reference);
}

bool beats(const CellResult& a, const CellResult& b) {
    const double speed_a = throughput_of(&a).median, speed_b = throughput_of(&b).median;
    const std::size_t failures_a = a.accuracy->failures(), failures_b = b.accuracy->failures();
    return speed_a >= speed_b && failures_a <= failures_b && (speed_a > speed_b || failures_a < failures_b);
}

}  // namespace

std::string pareto_csv(const Config& config, const Results& results) {
    std::string out =
        csv_line({"scene", "scene_source", "triangles", "spheres", "backend", "methods", "triangle_test",
                  "sphere_test", "box_test", "median_mrays_s", "lo_mrays_s", "hi_mrays_s", "rays", "failures",
                  "failures_per_million", "lo", "hi", "p99_scaled_error", "on_front"});
    for (const CellResult& cell : results.cells) {
        if (!is_shown(config, cell)) continue;
        const Contender& c = cell.contender;
        const Estimate speed = throughput_of(&cell);
        const std::size_t rays = cell.accuracy->verdict.rays, failures = cell.accuracy->failures();
        const Interval share = binomial_interval(failures, rays);
        const bool beaten =
            std::any_of(results.cells.begin(), results.cells.end(), [&](const CellResult& other) {
                return is_shown(config, other) && other.workload == cell.workload &&
                       other.contender.backend == c.backend && beats(other, cell);
            });
        out += csv_line({cell.workload.scene, cell.scene_source, std::to_string(cell.triangles),
                         std::to_string(cell.workload.spheres), c.backend,
                         c.is_yardstick() ? c.strategy : c.methods, c.triangle_test, c.sphere_test,
                         c.box_test, csv_number(speed.median), csv_number(speed.lo), csv_number(speed.hi),
                         std::to_string(rays), std::to_string(failures),
                         csv_number(1e6 * static_cast<double>(failures) / static_cast<double>(rays)),
                         csv_number(1e6 * share.lo), csv_number(1e6 * share.hi),
                         csv_number(cell.accuracy->p99_scaled_error), beaten ? "false" : "true"});
    }
    return out;
}

}  // namespace ctpbench
