#include "report/convergence.h"

#include <cmath>
#include <vector>

#include "measure/error_slope.h"
#include "measure/statistics.h"
#include "report/csv.h"
#include "wavefront/methods.h"

namespace ctpbench {
namespace {

using Fields = std::vector<std::string>;

const Fields kContender = {"scene", "scene_source", "triangles", "spheres", "backend", "strategy",
                           "shade", "methods",      "offset",    "bounces", "roulette"};

Fields contender_fields(const Config& config, const CellResult& cell) {
    const Contender& c = cell.contender;
    return {cell.workload.scene,
            cell.scene_source,
            std::to_string(cell.triangles),
            std::to_string(cell.workload.spheres),
            c.backend,
            c.strategy + (c.restart_carries_t ? "" : "_fresh_t"),
            c.shade,
            intersect_methods(c.methods, c.triangle_test, c.sphere_test, c.box_test, of_bundle),
            offset_of(c.methods, c.offset),
            std::to_string(c.bounce_limit != 0 ? c.bounce_limit : config.bounces),
            c.roulette ? "true" : "false"};
}

std::string line(Fields fields, const Fields& more) {
    fields.insert(fields.end(), more.begin(), more.end());
    return csv_line(fields);
}

// Of every seed, after 2^k samples.
std::vector<double> after(const std::vector<std::vector<double>>& by_seed, std::size_t k) {
    std::vector<double> values;
    for (const std::vector<double>& of_seed : by_seed) values.push_back(of_seed[k]);
    return values;
}

}  // namespace

std::string convergence_csv(const Config& config, const Results& results) {
    std::string out = line(kContender, {"seeds", "samples", "seconds", "lo_seconds", "hi_seconds", "relmse",
                                        "lo_relmse", "hi_relmse", "rmse"});
    for (const CellResult& cell : results.cells) {
        const Convergence& c = cell.convergence;
        if (!cell.valid || c.relmse.empty()) continue;
        for (std::size_t k = 0; k < c.relmse.front().size(); ++k) {
            const Estimate seconds = estimate_median(after(c.seconds, k));
            const BoundedValue relmse = mean_interval(after(c.relmse, k));
            out += line(contender_fields(config, cell),
                        {std::to_string(c.relmse.size()), std::to_string(std::size_t{1} << k),
                         csv_number(seconds.median), csv_number(seconds.lo), csv_number(seconds.hi),
                         csv_number(relmse.value), csv_number(relmse.lo), csv_number(relmse.hi),
                         csv_number(std::sqrt(relmse.value))});
        }
    }
    return out;
}

std::string convergence_fits_csv(const Config& config, const Results& results) {
    std::string out =
        line(kContender, {"slope", "lo_slope", "hi_slope", "bias_relmse", "lo_bias", "hi_bias"});
    for (const CellResult& cell : results.cells) {
        const Convergence& c = cell.convergence;
        if (!cell.valid || c.relmse.empty()) continue;
        const BoundedValue slope = rmse_slope(c.relmse);
        out += line(contender_fields(config, cell),
                    {csv_number(slope.value), csv_number(slope.lo), csv_number(slope.hi),
                     csv_number(c.bias.value), csv_number(c.bias.lo), csv_number(c.bias.hi)});
    }
    return out;
}

}  // namespace ctpbench
