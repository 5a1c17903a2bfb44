#include "report/tree_tables.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "report/csv.h"
#include "report/figures.h"
#include "report/paper_figures.h"

namespace ctpbench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, 3> kKinds{"mixed", "triangles", "spheres"};

// Nodes by scene and builder, sphere count and kind of tree.
class Nodes {
public:
    explicit Nodes(const Results& results) {
        for (const TreeResult& t : results.trees) {
            Workload column = t.workload;
            column.spheres = 0;
            if (std::find(columns_.begin(), columns_.end(), column) == columns_.end())
                columns_.push_back(column);
            counts_.insert(t.workload.spheres);
            nodes_[t.workload.name() + '|' + t.kind] = t.nodes;
        }
    }
    const std::vector<Workload>& columns() const { return columns_; }  // their spheres do not count
    const std::set<std::uint32_t>& counts() const { return counts_; }
    // Null where there is no such tree.
    const std::size_t* find(Workload column, std::uint32_t spheres, const std::string& kind) const {
        column.spheres = spheres;
        const auto found = nodes_.find(column.name() + '|' + kind);
        return found == nodes_.end() ? nullptr : &found->second;
    }
    // In thousands; NaN where there is no such tree.
    double kilo(const Workload& column, std::uint32_t spheres, const std::string& kind) const {
        const std::size_t* nodes = find(column, spheres, kind);
        return nodes == nullptr ? kNaN : static_cast<double>(*nodes) * 1e-3;
    }

private:
    std::vector<Workload> columns_;
    std::set<std::uint32_t> counts_;
    std::map<std::string, std::size_t> nodes_;
};

const SceneResult* scene_of(const Results& results, const std::string& name) {
    for (const SceneResult& s : results.scenes)
        if (s.name == name) return &s;
    return nullptr;
}

// NaN for what the paper does not have.
double printed_kilo_nodes(const std::string& scene, std::uint32_t spheres) {
    for (const paper::Table2Row& row : paper::table2)
        if (row.scene == scene && row.spheres == spheres) return row.kilo_nodes;
    return kNaN;
}

}  // namespace

std::string table2_csv(const Results& results) {
    const Nodes nodes(results);
    std::vector<std::string> header{"spheres"};
    for (const Workload& w : nodes.columns())
        for (const char* kind : {"combined", "triangles_alone", "spheres_alone"})
            header.push_back(w.scene + "/" + w.builder + "/" + kind);
    std::string out = csv_line(header);
    for (const std::uint32_t spheres : nodes.counts()) {
        std::vector<std::string> line{std::to_string(spheres)};
        for (const Workload& w : nodes.columns())
            for (const char* kind : kKinds) {
                const std::size_t* found = nodes.find(w, spheres, kind);
                line.push_back(found == nullptr ? "" : std::to_string(*found));
            }
        out += csv_line(line);
    }
    return out;
}

std::string table2_markdown(const Results& results) {
    const Nodes nodes(results);
    std::string out =
        "# Table 2: nodes of the trees, in thousands\n\n"
        "`combined` holds triangles and spheres in one tree, as `ctp` and `oop` traverse it; `restart` has "
        "a\n"
        "tree of each alone. The last two columns say how much larger spheres make the combined tree.\n";
    for (const Workload& column : nodes.columns()) {
        const SceneResult* scene = scene_of(results, column.scene);
        if (scene == nullptr) continue;
        // Not beside a stand-in.
        const auto printed = [&](std::uint32_t spheres) {
            return scene->source == "mesh" ? printed_kilo_nodes(column.scene, spheres) : kNaN;
        };
        out += "\n## " + column.scene + " (" + scene->source + ", " + std::to_string(scene->triangles) +
               " triangles, builder " + column.builder + ", sphere radius " +
               csv_number(column.sphere_radius) +
               " of the mean spacing)\n\n"
               "| spheres | combined: paper | combined | triangles | spheres alone | "
               "combined/triangles: paper | combined/triangles |\n"
               "| --- | --- | --- | --- | --- | --- | --- |\n";
        for (const std::uint32_t spheres : nodes.counts()) {
            const double combined = nodes.kilo(column, spheres, "mixed");
            const double triangles = nodes.kilo(column, spheres, "triangles");
            out += "| " + std::to_string(spheres) + " | " + fixed(printed(spheres), 0) + " | " +
                   fixed(combined, 1) + " | " + fixed(triangles, 1) + " | " +
                   fixed(nodes.kilo(column, spheres, "spheres"), 1) + " | " +
                   fixed(printed(spheres) / printed(0), 3) + " | " + fixed(combined / triangles, 3) + " |\n";
        }
    }
    return out;
}

}  // namespace ctpbench
