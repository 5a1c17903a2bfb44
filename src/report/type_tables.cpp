#include "report/type_tables.h"

#include <cmath>
#include <limits>
#include <utility>

#include "report/csv.h"
#include "report/figures.h"
#include "wavefront/type_choice.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench {
namespace {

const SceneResult* scene_of(const CellResult& cell, const Results& results) {
    for (const SceneResult& s : results.scenes)
        if (s.name == cell.workload.scene && s.spheres == cell.workload.spheres) return &s;
    return nullptr;
}

// The same contender with other types on the same workload; null if there is none.
const CellResult* with_types(const CellResult& cell, const std::string& types, const Results& results) {
    Contender other = cell.contender;
    other.types = types;
    return results.find(cell.workload, other.label());
}

std::string strategy_of(const Contender& c) {
    return c.renders() ? c.shade + (c.launch.empty() || c.launch == "isolated" ? "" : "/" + c.launch)
                       : c.strategy + (c.restart_carries_t ? "" : "_fresh_t");
}

std::string bytes_text(std::size_t bytes) { return bytes == 0 ? "" : std::to_string(bytes); }

std::string figure(double value) { return std::isnan(value) ? "" : csv_number(value); }

// A kernel of types.csv, and the stages that it consists of.
struct Part {
    const char* name;
    std::vector<std::string> stages;
};
const std::vector<Part>& parts_of(const Contender& c) {
    static const std::vector<Part> intersect{{"intersect", {"intersect"}}};
    static const std::vector<Part> frame{{"shade", {"shade"}},
                                         {"sort+shade+compact", {"sort", "shade", "compact"}},
                                         {"frame", {"intersect", "sort", "shade", "compact"}}};
    return c.renders() ? frame : intersect;
}

// Seconds of each round.
std::vector<double> seconds_of(const CellResult& cell, const Part& part) {
    std::vector<double> sum;
    for (const std::string& stage : part.stages) {
        const KernelSeries* k = cell.find(stage);
        if (k == nullptr) continue;
        sum.resize(k->seconds.size(), 0.0);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += k->seconds[i];
    }
    return sum;
}

// Of the reference of a cell's ratios: ctp with one type.
const CellResult* of_one_type(const CellResult& cell, const Results& results) {
    Contender c = cell.contender;
    c.types = "synthetic_1";
    if (c.renders())
        c.shade = "ctp";
    else
        c.strategy = "ctp", c.restart_carries_t = true;
    return results.find(cell.workload, c.label());
}

}  // namespace

std::string narrowing_csv(const Results& results) {
    std::string out =
        csv_line({"scene", "scene_source", "triangles", "spheres", "backend", "kernel", "strategy", "types",
                  "all_mrays_s", "scene_mrays_s", "gain", "gain_lo", "gain_hi", "all_bytes", "scene_bytes"});
    for (const CellResult& cell : results.cells) {
        const Contender& c = cell.contender;
        if (c.types != kTypesOfScene || !cell.valid) continue;
        const CellResult* all = with_types(cell, kAllTypes, results);
        const SceneResult* scene = scene_of(cell, results);
        if (all == nullptr || scene == nullptr || !all->valid) continue;
        const std::string_view kernel = main_kernel(cell);
        const Estimate gain = ratio_of(&cell, all, kernel);
        if (std::isnan(gain.median)) continue;
        out += csv_line(
            {cell.workload.scene, cell.scene_source, std::to_string(cell.triangles),
             std::to_string(cell.workload.spheres), c.backend, std::string(kernel), strategy_of(c),
             c.renders() ? material_list(c.types, Watertight::Offset::name, scene->needs)
                         : primitive_list(c.types, scene->needs),
             csv_number(throughput_of(all, kernel).median), csv_number(throughput_of(&cell, kernel).median),
             csv_number(gain.median), csv_number(gain.lo), csv_number(gain.hi), bytes_text(all->layout_bytes),
             bytes_text(cell.layout_bytes)});
    }
    return out;
}

std::string types_csv(const Results& results) {
    std::string out =
        csv_line({"scene", "scene_source", "triangles", "backend", "kernel", "strategy", "listed", "used",
                  "large", "median_mrays_s", "lo_mrays_s", "hi_mrays_s", "ratio", "ratio_lo", "ratio_hi"});
    for (const CellResult& cell : results.cells) {
        const Contender& c = cell.contender;
        if (c.is_yardstick() || !cell.valid) continue;
        const TypeChoice choice = type_choice(c.types);
        if (!choice.synthetic.any()) continue;
        const CellResult* reference = of_one_type(cell, results);
        for (const Part& part : parts_of(c)) {
            const std::vector<double> seconds = seconds_of(cell, part);
            const KernelSeries* counted = cell.find(main_kernel(cell));
            if (seconds.empty() || counted == nullptr) continue;
            // A kernel's own Mrays/s are of all rays of the frame, of which it may have traced a share.
            std::vector<double> speed;
            for (std::size_t i = 0; i < seconds.size(); ++i)
                speed.push_back(counted->mrays[i] * counted->seconds[i] / seconds[i]);
            const Estimate s = estimate_median(speed);
            constexpr double nan = std::numeric_limits<double>::quiet_NaN();
            Estimate ratio{nan, nan, nan};
            if (reference != nullptr && reference->valid)
                if (const std::vector<double> one = seconds_of(*reference, part);
                    one.size() == seconds.size())
                    ratio = estimate_paired_ratio(one, seconds);
            const char* large = !choice.synthetic.large ? "none" : choice.first_used == 0 ? "used" : "unused";
            out += csv_line({cell.workload.scene, cell.scene_source, std::to_string(cell.triangles),
                             c.backend, part.name, strategy_of(c), std::to_string(choice.synthetic.listed),
                             std::to_string(choice.used), large, csv_number(s.median), csv_number(s.lo),
                             csv_number(s.hi), figure(ratio.median), figure(ratio.lo), figure(ratio.hi)});
        }
    }
    return out;
}

}  // namespace ctpbench
