#include "config/cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <utility>

#include "base/error.h"

namespace ctpbench {
namespace {

const Axes& defaults() {
    static const Axes axes = default_axes();
    return axes;
}

// The shortest text that reads back as the same number.
std::string shortest(double value) {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

bool is_restart(const Cell& cell) { return cell.contender && cell.contender->strategy == "restart"; }
bool is_yardstick(const Cell& cell) { return cell.contender && cell.contender->methods == own_way; }

std::string strategy_of(const Contender& contender) {
    return contender.strategy + (contender.restart_carries_t ? "" : "_fresh_t") +
           (contender.renders() ? "+" + contender.shade : "");
}

template <class T>
bool allows(const std::vector<T>& axis, const T& value) {
    return axis.empty() || std::find(axis.begin(), axis.end(), value) != axis.end();
}

// As allows(), for an axis that may mean nothing for the cell: then only an axis not given allows it.
template <class T>
bool allows_if(bool meaningful, const std::vector<T>& axis, const T& value) {
    return meaningful ? allows(axis, value) : axis.empty();
}

std::vector<Workload> workloads_of(const Axes& axes) {
    std::vector<Workload> workloads;
    for (const std::string& scene : axes.scene) {
        for (const std::uint32_t spheres : axes.spheres) {
            for (const double radius : axes.sphere_radius) {
                for (const std::string& builder : axes.builder) {
                    const double used = spheres > 0 ? radius : defaults().sphere_radius.front();
                    workloads.push_back({scene, spheres, used, builder});
                }
            }
        }
    }
    return workloads;
}

// Every value of an axis, or `own` alone where the axis means nothing.
std::vector<std::string> values_if(bool meaningful, const std::vector<std::string>& axis, const char* own) {
    return meaningful ? axis : std::vector<std::string>{own};
}

std::vector<Contender> contenders_of(const Axes& axes, const KnownNames& known) {
    std::vector<Contender> contenders;
    const auto add = [&](const std::string& backend, const std::string& strategy) {
        const KnownNames::Yardstick* yardstick = known.yardstick(strategy);
        if (yardstick != nullptr && yardstick->backend != backend) return;
        const bool ours = yardstick == nullptr;
        for (const bool carries_t : axes.restart_carries_t)
            for (const std::string& traversal : values_if(ours, axes.traversal, own_way))
                for (const std::string& methods : values_if(ours, axes.methods, own_way))
                    for (const std::string& shade : axes.shade) {
                        if (!ours && shade != no_shade) continue;  // it only intersects
                        const bool launched = backend == "cuda" && shade != no_shade;
                        for (const std::string& launch : values_if(launched, axes.launch, ""))
                            contenders.push_back({backend, strategy, strategy != "restart" || carries_t,
                                                  traversal, methods, shade, launch});
                    }
    };
    for (const std::string& backend : axes.backend)
        for (const std::string& strategy : axes.strategy) add(backend, strategy);
    return contenders;
}

}  // namespace

std::string Workload::name() const {
    std::string name = scene + "/" + std::to_string(spheres);
    if (sphere_radius != defaults().sphere_radius.front()) name += "/radius" + shortest(sphere_radius);
    if (builder != defaults().builder.front()) name += "/" + builder + "_tree";
    return name;
}

std::string Contender::label() const {
    if (backend == defaults().backend.front()) return label_on_backend();
    Contender here = *this;
    here.backend = defaults().backend.front();
    const std::string rest = here.label_on_backend(), name = strategy_of(*this);
    return name + "/" + backend + rest.substr(name.size());
}

std::string Contender::label_on_backend() const {
    std::string label = strategy_of(*this);
    if (!launch.empty() && launch != defaults().launch.front()) label += "/" + launch;
    if (traversal != own_way && traversal != defaults().traversal.front()) label += "/" + traversal;
    if (methods != own_way && methods != defaults().methods.front()) label += "/" + methods;
    return label;
}

std::string Cell::name() const {
    if (!contender) return workload.name();
    const Contender& c = *contender;
    return workload.name() + "/" + c.backend + "/" + strategy_of(c) + "/" + c.traversal + "/" + c.methods +
           (c.launch.empty() ? "" : "/" + c.launch);
}

std::vector<Cell> expand_axes(const Axes& axes, bool measure, const KnownNames& known) {
    std::vector<std::optional<Contender>> contenders;
    if (measure) {
        for (Contender& contender : contenders_of(axes, known)) contenders.emplace_back(std::move(contender));
    } else {
        contenders.emplace_back(std::nullopt);
    }
    std::vector<Cell> cells;
    std::set<std::string> seen;  // axes that mean nothing have made equal cells
    for (const Workload& workload : workloads_of(axes)) {
        for (const auto& contender : contenders) {
            Cell cell{workload, contender};
            if (seen.insert(cell.name()).second) cells.push_back(std::move(cell));
        }
    }
    return cells;
}

bool matches(const Cell& cell, const Axes& pattern) {
    const Workload& w = cell.workload;
    const bool workload = allows(pattern.scene, w.scene) && allows(pattern.spheres, w.spheres) &&
                          allows_if(w.spheres > 0, pattern.sphere_radius, w.sphere_radius) &&
                          allows(pattern.builder, w.builder);
    const bool measured = cell.contender.has_value();
    const Contender c = cell.contender.value_or(Contender{});
    return workload && allows_if(measured, pattern.backend, c.backend) &&
           allows_if(measured, pattern.strategy, c.strategy) &&
           allows_if(is_restart(cell), pattern.restart_carries_t, c.restart_carries_t) &&
           allows_if(measured && !is_yardstick(cell), pattern.traversal, c.traversal) &&
           allows_if(measured && !is_yardstick(cell), pattern.methods, c.methods) &&
           allows_if(measured, pattern.shade, c.shade) &&
           allows_if(!c.launch.empty(), pattern.launch, c.launch);
}

std::vector<Cell> expand(const Config& config, const KnownNames& known) {
    std::vector<Cell> cells = expand_axes(config.matrix, config.measure, known);
    std::erase_if(cells, [&](const Cell& cell) {
        return std::any_of(config.exclude.begin(), config.exclude.end(),
                           [&](const Axes& pattern) { return matches(cell, pattern); });
    });
    for (const Axes& axes : config.include) {
        for (Cell& cell : expand_axes(axes, config.measure, known)) cells.push_back(std::move(cell));
    }
    return cells;
}

std::vector<Cell> filter(const std::vector<Cell>& cells, std::string_view part) {
    std::vector<Cell> kept;
    for (const Cell& cell : cells) {
        if (cell.name().find(part) != std::string::npos) kept.push_back(cell);
    }
    if (kept.empty()) {
        std::string message = "--filter " + std::string(part) + ": error: no cell's name contains this";
        if (!cells.empty()) message += "; names look like " + cells.front().name();
        throw Error(ExitCode::usage, message + ", and --dry-run shows the cells");
    }
    return kept;
}

std::vector<WorkloadCells> group_by_workload(const std::vector<Cell>& cells) {
    std::vector<WorkloadCells> groups;
    for (const Cell& cell : cells) {
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const WorkloadCells& g) { return g.workload == cell.workload; });
        if (group == groups.end()) group = groups.insert(groups.end(), {cell.workload, {}});
        if (cell.contender) group->contenders.push_back(*cell.contender);
    }
    return groups;
}

std::string format_cells(const std::vector<Cell>& cells) {
    std::vector<std::vector<std::string>> rows = {{"scene", "spheres", "sphere_radius", "builder", "backend",
                                                   "contender", "traversal", "methods", "launch"}};
    for (const Cell& cell : cells) {
        const Workload& w = cell.workload;
        rows.push_back(
            {w.scene, std::to_string(w.spheres), w.spheres > 0 ? shortest(w.sphere_radius) : "-", w.builder});
        if (const auto& c = cell.contender) {
            for (const std::string& column : {c->backend, strategy_of(*c), c->traversal, c->methods,
                                              c->launch.empty() ? std::string("-") : c->launch}) {
                rows.back().push_back(column);
            }
        } else {
            rows.back().resize(rows.front().size(), "-");
        }
    }
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            text += row[i] + std::string(width[i] - row[i].size() + 2, ' ');
        }
        text += row.back() + '\n';
    }
    return text;
}

}  // namespace ctpbench
