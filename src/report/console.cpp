#include "report/console.h"

#include <cmath>
#include <cstdio>

#include "report/figures.h"
#include "report/judgement.h"

namespace ctpbench {

std::string table_text(const Config& config, const Results& results) {
    std::string out;
    char line[256];
    if (!results.trees.empty()) {
        std::snprintf(line, sizeof line, "%-32s %-14s %10s %10s %6s %8s %9s\n", "scene/spheres", "tree",
                      "nodes", "references", "depth", "SAH", "build s");
        out += line;
        for (const TreeResult& t : results.trees) {
            std::snprintf(line, sizeof line, "%-32s %-14s %10s %10s %6s %8s %9.2f\n",
                          t.workload.name().c_str(), t.kind.c_str(),
                          t.nodes ? std::to_string(t.nodes).c_str() : "-",
                          t.nodes ? std::to_string(t.references).c_str() : "-",
                          t.nodes ? std::to_string(t.depth).c_str() : "-",
                          t.nodes ? fixed(t.sah, 1).c_str() : "-", t.build_seconds);
            out += line;
        }
        out += '\n';
    }
    if (results.cells.empty()) return out;
    std::snprintf(line, sizeof line, "%-32s %-18s %9s  %-19s %-20s %-8s %-20s %s\n", "scene/spheres",
                  "strategy", "Mrays/s", "95 % interval", ("/ " + config.reference).c_str(), "verdict",
                  "/ yardstick", "hits");
    out += line;
    const Judgements judgements(config, results);
    for (const CellResult& c : results.cells) {
        const std::string_view kernel = main_kernel(c);
        const Judgement* judgement = judgements.find(c, kernel);
        const Estimate speed = throughput_of(&c, kernel);
        const std::string interval =
            std::isnan(speed.median) ? "" : fixed(speed.lo, 3) + " .. " + fixed(speed.hi, 3);
        std::snprintf(line, sizeof line, "%-32s %-18s %9s  %-19s %-20s %-8s %-20s %s\n",
                      c.workload.name().c_str(), c.contender.label().c_str(), fixed(speed.median, 3).c_str(),
                      interval.c_str(),
                      with_interval(ratio_of(&c, reference_of(c, results, config.reference), kernel)).c_str(),
                      judgement == nullptr ? "" : judgement->verdict.c_str(),
                      with_interval(ratio_of(&c, yardstick_of(c, results), kernel)).c_str(),
                      !c.valid    ? "REJECTED"
                      : c.checked ? "checked"
                                  : "unchecked");
        out += line;
    }
    for (const CellResult& c : results.cells)
        if (!c.valid && !c.reason.empty())
            out += c.workload.name() + "/" + c.contender.label() + ": rejected: " + c.reason + "\n";
    for (const std::string& warning : judgements.warnings()) out += warning + "\n";
    return out;
}

}  // namespace ctpbench
