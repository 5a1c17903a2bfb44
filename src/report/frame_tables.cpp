#include "report/frame_tables.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "report/csv.h"
#include "report/figures.h"
#include "report/paper_figures.h"

namespace ctpbench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kKernels[] = {"intersect", "sort", "shade", "compact"};  // of the table and the figure

std::vector<const CellResult*> frames(const Results& results) {
    std::vector<const CellResult*> cells;
    for (const CellResult& c : results.cells)
        if (c.contender.renders()) cells.push_back(&c);
    return cells;
}

// What is compared within itself alone.
struct Section {
    Workload workload;
    std::string backend, launch;
    bool operator==(const Section&) const = default;
};
std::vector<Section> sections(const Results& results) {
    std::vector<Section> all;
    for (const CellResult* c : frames(results)) {
        const Section section{c->workload, c->contender.backend, c->contender.launch};
        if (std::find(all.begin(), all.end(), section) == all.end()) all.push_back(section);
    }
    return all;
}

const CellResult* find_shade(const std::vector<const CellResult*>& cells, std::string_view shade) {
    for (const CellResult* c : cells)
        if (c->contender.shade == shade) return c;
    return nullptr;
}

std::string column_of(const CellResult& c) {
    std::string name = c.workload.scene;
    if (c.workload.spheres > 0) name += "+" + std::to_string(c.workload.spheres);
    name += "/" + c.contender.backend + "/" + c.contender.shade;
    const std::string& launch = c.contender.launch;
    return launch.empty() || launch == default_axes().launch.front() ? name : name + "/" + launch;
}

paper::Table1Row printed_for(const CellResult& any, std::string_view kernel) {
    for (const paper::Table1Row& row : paper::table1)
        if (row.backend == any.contender.backend && row.scene == any.workload.scene && row.kernel == kernel &&
            any.scene_source == "mesh")
            return row;
    return {"", "", kernel, kNaN, kNaN, kNaN};
}

std::string printed_ratio(double a, double b) { return a > 0 && b > 0 ? fixed(a / b, 2) : "n/a"; }
std::string printed_speed(double speed) { return speed > 0 ? fixed(speed, 2) : "n/a"; }

std::string kernels_section(const std::vector<const CellResult*>& cells) {
    std::string out = "| kernel | ctp: paper | oop: paper | sort: paper |";
    std::string rule = "\n| --- | --- | --- | --- |";
    for (const CellResult* c : cells) out += " " + c->contender.shade + " |", rule += " --- |";
    out += " ctp/oop: paper | ctp/oop | ctp/sort: paper | ctp/sort |" + rule + " --- | --- | --- | --- |\n";
    for (const char* kernel : kKernels) {
        const paper::Table1Row printed = printed_for(*cells.front(), kernel);
        out += "| " + std::string(kernel) + " | " + printed_speed(printed.ctp) + " | " +
               printed_speed(printed.oop) + " | " + printed_speed(printed.sort) + " |";
        for (const CellResult* c : cells) out += " " + fixed(throughput_of(c, kernel).median, 2) + " |";
        const CellResult* ctp = find_shade(cells, "ctp");
        out += " " + printed_ratio(printed.ctp, printed.oop) + " | " +
               with_interval(ratio_of(ctp, find_shade(cells, "oop"), kernel)) + " | " +
               printed_ratio(printed.ctp, printed.sort) + " | " +
               with_interval(ratio_of(ctp, find_shade(cells, "sort"), kernel)) + " |\n";
    }
    return out;
}

std::string shares_section(const std::vector<const CellResult*>& cells) {
    const paper::Table1Row intersect = printed_for(*cells.front(), "intersect");
    const paper::Table1Row shade = printed_for(*cells.front(), "shade");
    const CellResult* ctp = find_shade(cells, "ctp");
    std::string out =
        "\n| shade strategy | shade / ctp's | whole frame, s | shade / intersect, time | dropped samples per "
        "1e6 |\n| --- | --- | --- | --- | --- |\n";
    for (const CellResult* c : cells) {
        double seconds = 0.0;
        for (const char* kernel : kKernels) {
            const double part = seconds_of_kernel(c, kernel).median;
            if (part > 0.0) seconds += part;
        }
        out += "| " + c->contender.shade + " | " + with_interval(ratio_of(c, ctp, "shade")) + " | " +
               fixed(seconds, 3) + " | " + with_interval(seconds_ratio_of(c, "shade", "intersect")) + " | " +
               fixed(c->dropped_per_million(), 1) + " |\n";
    }
    out += "\nThe paper's text: shading takes about 10 % of what intersecting takes";
    if (intersect.ctp > 0) out += "; by its Table 1, ctp " + fixed(100 * intersect.ctp / shade.ctp, 0) + " %";
    return out + ".\n";
}

std::string copies_section(const std::vector<const CellResult*>& cells) {
    std::string out =
        "\n| reordering | Mrays/s | a plain copy of the index buffer, Mrays/s | ratio |\n| --- | --- | --- | "
        "--- "
        "|\n";
    for (const CellResult* c : cells)
        for (const char* kernel : {"sort", "compact"}) {
            if (c->find(kernel) == nullptr) continue;
            out += "| " + c->contender.shade + ": " + kernel + " | " +
                   fixed(throughput_of(c, kernel).median, 0) + " | " +
                   fixed(throughput_of(c, "copy").median, 0) + " | " +
                   with_interval(kernel_ratio_of(c, kernel, "copy")) + " |\n";
        }
    return out;
}

}  // namespace

std::string table1_csv(const Results& results) {
    const std::vector<const CellResult*> cells = frames(results);
    std::vector<std::string> header{"kernel"};
    for (const CellResult* c : cells) header.push_back(column_of(*c));
    std::string out = csv_line(header);
    for (const char* kernel : kKernels) {
        std::vector<std::string> line{kernel};
        for (const CellResult* c : cells) {
            const std::string speed = csv_number(throughput_of(c, kernel).median, 4);
            line.push_back(speed.empty() ? "n/a" : speed);
        }
        out += csv_line(line);
    }
    return out;
}

std::string table1_markdown(const Results& results) {
    std::string out =
        "# Table 1: throughput of a bounce's kernels, Mrays/s\n\n"
        "Paper: dual Xeon E5-2637 v2, 16 threads, and GeForce GTX 1080 Ti. Speeds do not travel between "
        "machines; "
        "ratios\n"
        "within a machine do. Ours are medians over frames with 95 % bootstrap intervals.\n";
    for (const auto& [workload, backend, launch] : sections(results)) {
        std::vector<const CellResult*> cells;
        for (const CellResult* c : frames(results))
            if (c->workload == workload && c->contender.backend == backend && c->contender.launch == launch)
                cells.push_back(c);
        const CellResult& any = *cells.front();
        out += "\n## " + workload.name() + ", " + backend + (launch.empty() ? "" : ", " + launch) + " (" +
               any.scene_source + ", " + std::to_string(any.triangles) + " triangles; intersect strategy " +
               any.contender.strategy + ")\n\n" + kernels_section(cells) + shares_section(cells) +
               copies_section(cells);
    }
    return out;
}

std::string figure4_csv(const Config& config, const Results& results) {
    std::string out =
        csv_line({"scene", "scene_source", "triangles", "spheres", "backend", "strategy", "kernel", "seconds",
                  "lo_seconds", "hi_seconds", "rays", "bounces", "width", "height"});
    for (const CellResult* c : frames(results))
        for (const char* kernel : kKernels) {
            const Estimate seconds = seconds_of_kernel(c, kernel);
            if (c->find(kernel) == nullptr || !c->valid) continue;
            out += csv_line(
                {c->workload.scene, c->scene_source, std::to_string(c->triangles),
                 std::to_string(c->workload.spheres), c->contender.backend,
                 c->contender.shade + (c->contender.launch.empty() || c->contender.launch == "isolated"
                                           ? ""
                                           : "/" + c->contender.launch),
                 kernel, csv_number(seconds.median), csv_number(seconds.lo), csv_number(seconds.hi),
                 std::to_string(c->find(kernel)->rays), std::to_string(config.bounces),
                 std::to_string(config.width), std::to_string(config.height)});
        }
    return out;
}

}  // namespace ctpbench
