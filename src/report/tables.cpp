#include "report/tables.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "report/csv.h"
#include "report/figures.h"
#include "report/paper_figures.h"

namespace ctpbench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Of the cells that intersect only, in order of first appearance, without repetition.
template <class T, class F>
std::vector<T> distinct(const Results& results, F&& of) {
    std::vector<T> values;
    for (const CellResult& c : results.cells)
        if (!c.contender.renders() && std::find(values.begin(), values.end(), of(c)) == values.end())
            values.push_back(of(c));
    return values;
}

// What a column of Table 3 holds fixed beside the strategy.
struct Column {
    Workload workload;  // its spheres do not count
    std::string backend, name, label;
    bool operator==(const Column&) const = default;
};
Workload without_spheres(Workload w) {
    w.spheres = 0;
    return w;
}

std::string printed_speed(double speed) { return speed > 0 ? fixed(speed, 2) : "n/a"; }

// Triangles that the mesh has and that no ray can hit.
std::string dropped_text(const Results& results, const Workload& column) {
    for (const SceneResult& s : results.scenes)
        if (s.name == column.scene && s.dropped_triangles > 0)
            return " and " + std::to_string(s.dropped_triangles) + " dropped as degenerate";
    return {};
}

std::vector<std::uint32_t> sphere_counts(const Results& results) {
    auto counts = distinct<std::uint32_t>(results, [](const CellResult& c) { return c.workload.spheres; });
    std::sort(counts.begin(), counts.end());
    return counts;
}

}  // namespace

std::string table3_csv(const Results& results) {
    const auto columns = distinct<Column>(results, [](const CellResult& c) {
        return Column{without_spheres(c.workload), c.contender.backend, c.contender.label_on_backend(),
                      c.contender.label()};
    });
    std::vector<std::string> header{"spheres"};
    const auto builders =
        distinct<std::string>(results, [](const CellResult& c) { return c.workload.builder; });
    const auto radii =
        distinct<double>(results, [](const CellResult& c) { return c.workload.sphere_radius; });
    for (const Column& c : columns) {
        std::string name = c.workload.scene + "/" + c.backend + "/" + c.name;
        if (builders.size() > 1) name += "/" + c.workload.builder;
        if (radii.size() > 1) name += "/r=" + csv_number(c.workload.sphere_radius);
        header.push_back(name);
    }
    std::string out = csv_line(header);
    for (std::uint32_t spheres : sphere_counts(results)) {
        std::vector<std::string> line{std::to_string(spheres)};
        for (const Column& column : columns) {
            Workload w = column.workload;
            w.spheres = spheres;
            line.push_back(csv_number(throughput_of(results.find(w, column.label)).median, 4));
        }
        out += csv_line(line);
    }
    return out;
}

std::string table3_markdown(const Results& results) {
    std::string out =
        "# Table 3: intersect throughput, triangles and spheres in one scene\n\n"
        "Paper: dual Xeon E5-2637 v2, 16 threads, and GeForce GTX 1080 Ti. Speeds do not travel between "
        "machines; "
        "ratios\n"
        "within a machine do. Ours are medians over rounds with 95 % bootstrap intervals; `restart_fresh_t`\n"
        "starts its second pass without the first one's hit.\n";
    struct Section {
        Workload workload;
        std::string backend, traversal;
        bool operator==(const Section&) const = default;
    };
    const std::string usual = default_axes().traversal.front();
    for (const auto& [column, backend, traversal] : distinct<Section>(results, [](const CellResult& c) {
             return Section{without_spheres(c.workload), c.contender.backend, c.contender.traversal};
         })) {
        if (traversal == own_way) continue;  // a yardstick is in the sections of all others
        const auto of_column = [&, &column = column, &backend = backend, &traversal = traversal](
                                   std::uint32_t spheres, std::string label) {
            Workload w = column;
            w.spheres = spheres;
            if (traversal != usual) label += "/" + traversal;
            if (backend != "cpu") label += "/" + backend;
            return results.find(w, label);
        };
        const CellResult* any = nullptr;
        for (const CellResult& c : results.cells)
            if (any == nullptr && !c.contender.renders() && c.contender.backend == backend &&
                without_spheres(c.workload) == column)
                any = &c;
        out += "\n## " + column.scene + ", " + backend + (traversal == usual ? "" : ", " + traversal) + " (" +
               any->scene_source + ", " + std::to_string(any->triangles) + " triangles" +
               dropped_text(results, column) + ", builder " + column.builder + ", sphere radius " +
               csv_number(column.sphere_radius) + " of the mean spacing)\n\n";
        out +=
            "| spheres | ctp: paper | ctp | oop: paper | oop | restart: paper | restart | ctp/oop: paper | "
            "ctp/oop | ctp/restart: paper | ctp/restart | ctp/restart_fresh_t | typed_leaves/restart | "
            "typed_phases/restart | ctp/yardstick |\n"
            "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
        for (std::uint32_t spheres : sphere_counts(results)) {
            const CellResult* ctp = of_column(spheres, "ctp");
            const CellResult* oop = of_column(spheres, "oop");
            const CellResult* restart = of_column(spheres, "restart");
            paper::Table3Row printed{"", "", 0, kNaN, kNaN, kNaN};
            for (const paper::Table3Row& row : paper::table3)
                if (row.backend == backend && row.scene == column.scene && row.spheres == spheres &&
                    any->scene_source == "mesh")
                    printed = row;
            out += "| " + std::to_string(spheres) + " | " + fixed(printed.ctp, 2) + " | " +
                   fixed(throughput_of(ctp).median, 2) + " | " + printed_speed(printed.oop) + " | " +
                   fixed(throughput_of(oop).median, 2) + " | " + fixed(printed.restart, 2) + " | " +
                   fixed(throughput_of(restart).median, 2) + " | " +
                   (printed.oop > 0 ? fixed(printed.ctp / printed.oop, 2) : "n/a") + " | " +
                   with_interval(ratio_of(ctp, oop)) + " | " + fixed(printed.ctp / printed.restart, 2) +
                   " | " + with_interval(ratio_of(ctp, restart)) + " | " +
                   with_interval(ratio_of(ctp, of_column(spheres, "restart_fresh_t"))) + " | " +
                   with_interval(ratio_of(of_column(spheres, "typed_leaves"), restart)) + " | " +
                   with_interval(ratio_of(of_column(spheres, "typed_phases"), restart)) + " | " +
                   with_interval(ratio_of(ctp, ctp == nullptr ? nullptr : yardstick_of(*ctp, results))) +
                   " |\n";
        }
    }
    return out;
}

}  // namespace ctpbench
