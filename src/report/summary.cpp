#include "report/summary.h"

#include "base/hash.h"
#include "report/csv.h"
#include "report/figures.h"
#include "report/judgement.h"

namespace ctpbench {

std::string summary_csv(const Config& config, const Results& results) {
    std::string out = csv_line({"scene",
                                "scene_source",
                                "triangles",
                                "spheres",
                                "sphere_radius",
                                "builder",
                                "backend",
                                "strategy",
                                "types",
                                "shade",
                                "kernel",
                                "rays",
                                "rounds",
                                "median_mrays_s",
                                "lo_mrays_s",
                                "hi_mrays_s",
                                "ratio_to_reference",
                                "ratio_lo",
                                "ratio_hi",
                                "ratio_to_yardstick",
                                "yardstick_lo",
                                "yardstick_hi",
                                "image_hash",
                                "samples",
                                "valid",
                                "mismatch_rate",
                                "verdict",
                                "drift",
                                "bimodal",
                                "stopped_by"});
    const Judgements judgements(config, results);
    for (const CellResult& c : results.cells) {
        const CellResult* reference = reference_of(c, results, config.reference);
        const auto line = [&](std::string_view kernel, std::uint64_t rays, std::size_t rounds) {
            const Judgement* judgement = judgements.find(c, kernel);
            const Estimate speed = throughput_of(&c, kernel);
            const Estimate ratio = ratio_of(&c, reference, kernel);
            const Estimate yardstick = ratio_of(&c, yardstick_of(c, results), kernel);
            out += csv_line({c.workload.scene,
                             c.scene_source,
                             std::to_string(c.triangles),
                             std::to_string(c.workload.spheres),
                             csv_number(c.workload.sphere_radius),
                             c.workload.builder,
                             c.contender.backend,
                             c.contender.label(),
                             c.contender.types,
                             c.contender.shade,
                             std::string(kernel),
                             std::to_string(rays),
                             std::to_string(rounds),
                             csv_number(speed.median),
                             csv_number(speed.lo),
                             csv_number(speed.hi),
                             csv_number(ratio.median),
                             csv_number(ratio.lo),
                             csv_number(ratio.hi),
                             csv_number(yardstick.median),
                             csv_number(yardstick.lo),
                             csv_number(yardstick.hi),
                             c.image_hash != 0 ? hex(c.image_hash) : "",
                             c.samples != 0 ? std::to_string(c.samples) : "",
                             c.validity(),
                             c.checked ? csv_number(c.verdict.mismatch_rate()) : "",
                             judgement == nullptr ? "" : judgement->verdict,
                             judgement == nullptr ? "" : csv_number(judgement->flags.drift, 3),
                             judgement == nullptr       ? ""
                             : judgement->flags.bimodal ? "true"
                                                        : "false",
                             c.stopped_by});
        };
        if (c.kernels.empty()) line(main_kernel(c), 0, 0);
        for (const KernelSeries& k : c.kernels) line(k.kernel, k.rays, k.mrays.size());
    }
    return out;
}

std::string trees_csv(const Results& results) {
    std::string out = csv_line({"scene", "spheres", "sphere_radius", "builder", "tree", "primitives", "nodes",
                                "references", "depth", "sah", "build_seconds", "bytes"});
    const auto known = [](std::size_t n) { return n == 0 ? std::string() : std::to_string(n); };
    for (const TreeResult& t : results.trees)
        out += csv_line({t.workload.scene, std::to_string(t.workload.spheres),
                         csv_number(t.workload.sphere_radius), t.workload.builder, t.kind,
                         std::to_string(t.primitives), known(t.nodes), known(t.references), known(t.depth),
                         t.nodes == 0 ? "" : csv_number(t.sah), csv_number(t.build_seconds), known(t.bytes)});
    return out;
}

}  // namespace ctpbench
