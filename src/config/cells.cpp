#include "config/cells.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.h"

namespace ctpbench {
namespace {

template <class T>
bool allows(const std::vector<T>& axis, const T& value) {
    return axis.empty() || std::find(axis.begin(), axis.end(), value) != axis.end();
}

// As allows(), for an axis that may mean nothing for the cell: then only an axis not given allows it.
template <class T>
bool allows_if(bool meaningful, const std::vector<T>& axis, const T& value) {
    return meaningful ? allows(axis, value) : axis.empty();
}

std::vector<Workload> workloads_of(const Axes& axes, const Config& config) {
    const Axes defaults = default_axes();
    const double radius = defaults.sphere_radius.front();
    std::vector<Workload> workloads;
    if (config.study == Study::stability) {
        for (const std::string& name : config.stress)
            workloads.push_back({name, 0, radius, defaults.builder.front()});
        return workloads;
    }
    for (const std::string& scene : axes.scene)
        for (const std::uint32_t spheres : axes.spheres)
            for (const double r : axes.sphere_radius)
                for (const std::string& builder : axes.builder)
                    workloads.push_back({scene, spheres, spheres > 0 ? r : radius, builder});
    return workloads;
}

// Calls f(axis, member, meaningful) for every axis that varies a contender of one backend and strategy, the
// one that varies slowest first. `meaningful(contender)`: of one in which the axes before have been set.
template <class F>
void for_each_part(Study study, F&& f) {
    const auto ours = [](const Contender& c) { return !c.is_yardstick(); };
    const auto renders = [](const Contender& c) { return c.renders(); };
    f(&Axes::restart_carries_t, &Contender::restart_carries_t,
      [](const Contender& c) { return c.strategy == "restart"; });
    f(&Axes::traversal, &Contender::traversal, ours);
    f(&Axes::methods, &Contender::methods, ours);
    f(&Axes::types, &Contender::types, ours);
    f(&Axes::triangle_test, &Contender::triangle_test, ours);
    f(&Axes::sphere_test, &Contender::sphere_test, ours);
    f(&Axes::box_test, &Contender::box_test, ours);
    f(&Axes::shade, &Contender::shade, [](const Contender&) { return true; });
    f(&Axes::offset, &Contender::offset, [study](const Contender& c) {
        return c.renders() || (study == Study::stability && !c.is_yardstick());
    });
    f(&Axes::bounce_limit, &Contender::bounce_limit, renders);
    f(&Axes::roulette, &Contender::roulette, renders);
    f(&Axes::launch, &Contender::launch,
      [](const Contender& c) { return c.renders() && c.backend == "cuda"; });
    f(&Axes::threads, &Contender::threads,
      [](const Contender& c) { return !c.renders() && c.backend == "cpu"; });
}

std::vector<Contender> contenders_of(const Axes& axes, Study study, const KnownNames& known) {
    std::vector<Contender> all;
    for (const std::string& backend : axes.backend)
        for (const std::string& strategy : axes.strategy) {
            const KnownNames::Yardstick* yardstick = known.yardstick(strategy);
            if (yardstick != nullptr && yardstick->backend != backend) continue;
            std::vector<Contender> list(1);
            list[0].backend = backend, list[0].strategy = strategy;
            if (yardstick != nullptr) list[0].traversal = list[0].methods = list[0].types = own_way;
            for_each_part(study, [&](auto axis, auto member, auto meaningful) {
                std::vector<Contender> varied;
                for (const Contender& c : list) {
                    if (!meaningful(c)) {
                        varied.push_back(c);
                        continue;
                    }
                    for (const auto& value : axes.*axis) varied.emplace_back(c).*member = value;
                }
                list = std::move(varied);
            });
            // A yardstick only intersects.
            std::erase_if(list, [](const Contender& c) { return c.is_yardstick() && c.renders(); });
            if (known.available) std::erase_if(list, [&](const Contender& c) { return !known.available(c); });
            all.insert(all.end(), list.begin(), list.end());
        }
    return all;
}

// Whether the methods that the contender is there for have anything to do with the workload.
bool meets(const Contender& contender, const KnownNames::Stress& stress) {
    const auto has = [&](const char* kind) {
        return std::find(stress.kinds.begin(), stress.kinds.end(), kind) != stress.kinds.end();
    };
    // A yardstick forms no rays of its own.
    if (contender.is_yardstick()) return !has("offset");
    return contender.kind() == "bundle" || has(contender.kind().c_str());
}

}  // namespace

std::vector<Cell> expand_axes(const Axes& axes, const Config& config, const KnownNames& known) {
    std::vector<std::optional<Contender>> contenders;
    if (config.measure) {
        for (Contender& contender : contenders_of(axes, config.study, known))
            contenders.emplace_back(std::move(contender));
    } else {
        contenders.emplace_back(std::nullopt);
    }
    std::vector<Cell> cells;
    std::set<std::string> seen;  // axes that mean nothing have made equal cells
    for (const Workload& workload : workloads_of(axes, config)) {
        const KnownNames::Stress* stress =
            config.study == Study::stability ? known.find_stress(workload.scene) : nullptr;
        for (const auto& contender : contenders) {
            if (stress != nullptr && !meets(*contender, *stress)) continue;
            Cell cell{workload, contender};
            if (seen.insert(cell.name()).second) cells.push_back(std::move(cell));
        }
    }
    return cells;
}

bool matches(const Cell& cell, const Axes& pattern, Study study) {
    const Workload& w = cell.workload;
    if (!(allows(pattern.scene, w.scene) && allows(pattern.spheres, w.spheres) &&
          allows_if(w.spheres > 0, pattern.sphere_radius, w.sphere_radius) &&
          allows(pattern.builder, w.builder)))
        return false;
    const bool measured = cell.contender.has_value();
    const Contender c = cell.contender.value_or(Contender{});
    bool all =
        allows_if(measured, pattern.backend, c.backend) && allows_if(measured, pattern.strategy, c.strategy);
    for_each_part(study, [&](auto axis, auto member, auto meaningful) {
        all = all && allows_if(measured && meaningful(c), pattern.*axis, c.*member);
    });
    return all;
}

std::vector<Cell> expand(const Config& config, const KnownNames& known) {
    std::vector<Cell> cells = expand_axes(config.matrix, config, known);
    std::erase_if(cells, [&](const Cell& cell) {
        return std::any_of(config.exclude.begin(), config.exclude.end(),
                           [&](const Axes& pattern) { return matches(cell, pattern, config.study); });
    });
    for (const Axes& axes : config.include) {
        for (Cell& cell : expand_axes(axes, config, known)) cells.push_back(std::move(cell));
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

bool any_on_cuda(const std::vector<Cell>& cells) {
    return std::any_of(cells.begin(), cells.end(),
                       [](const Cell& cell) { return cell.contender && cell.contender->backend == "cuda"; });
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

}  // namespace ctpbench
