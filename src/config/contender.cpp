// How workloads, contenders and cells are called.
#include <array>
#include <charconv>

#include "config/cells.h"

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

}  // namespace

std::string Workload::name() const {
    std::string name = scene + "/" + std::to_string(spheres);
    if (sphere_radius != defaults().sphere_radius.front()) name += "/radius" + shortest(sphere_radius);
    if (builder != defaults().builder.front()) name += "/" + builder + "_tree";
    return name;
}

std::string Contender::strategy_name() const {
    return strategy + (restart_carries_t ? "" : "_fresh_t") + (renders() ? "+" + shade : "");
}

std::string Contender::exchanged() const {
    std::string parts;
    for (const std::string* part : {&triangle_test, &sphere_test, &box_test, &offset})
        if (*part != of_bundle) parts += "/" + *part;
    if (bounce_limit != 0) parts += "/limit" + std::to_string(bounce_limit);
    if (roulette) parts += "/roulette";
    return parts;
}

std::string Contender::kind() const {
    std::string kind = "bundle";
    int exchanged_parts = 0;
    const auto look = [&](const std::string& part, const char* name) {
        if (part != of_bundle) kind = name, ++exchanged_parts;
    };
    look(triangle_test, "triangle"), look(sphere_test, "sphere"), look(box_test, "box");
    look(offset, "offset");
    const bool in_default = methods == defaults().methods.front();
    return exchanged_parts == 1 && in_default ? kind : "bundle";
}

std::string Contender::method() const {
    if (is_yardstick()) return strategy;
    const std::string parts = exchanged();
    const std::string with = traversal == defaults().traversal.front() ? "" : "/" + traversal;
    return (kind() == "bundle" ? methods + parts : parts.substr(1)) + with;
}

std::string Contender::label() const {
    if (backend == defaults().backend.front()) return label_on_backend();
    const std::string all = label_on_backend(), name = strategy_name();
    return name + "/" + backend + all.substr(name.size());
}

std::string Contender::label_on_backend() const {
    std::string label = strategy_name();
    if (!launch.empty() && launch != defaults().launch.front()) label += "/" + launch;
    if (traversal != own_way && traversal != defaults().traversal.front()) label += "/" + traversal;
    if (!is_yardstick() && methods != defaults().methods.front()) label += "/" + methods;
    return label + types_part() + exchanged() + threads_part();
}

std::string Contender::types_part() const {
    return types == own_way || types == defaults().types.front() ? "" : "/" + types;
}

std::string Contender::threads_part() const {
    return threads == 0 ? "" : "/" + std::to_string(threads) + (threads == 1 ? "thread" : "threads");
}

std::string Cell::name() const {
    if (!contender) return workload.name();
    const Contender& c = *contender;
    return workload.name() + "/" + c.backend + "/" + c.strategy_name() + "/" + c.traversal + "/" + c.methods +
           c.types_part() + c.exchanged() + c.threads_part() + (c.launch.empty() ? "" : "/" + c.launch);
}

std::string format_cells(const std::vector<Cell>& cells) {
    std::vector<std::vector<std::string>> rows = {{"scene", "spheres", "sphere_radius", "builder", "backend",
                                                   "contender", "traversal", "methods", "types", "launch",
                                                   "threads"}};
    for (const Cell& cell : cells) {
        const Workload& w = cell.workload;
        rows.push_back(
            {w.scene, std::to_string(w.spheres), w.spheres > 0 ? shortest(w.sphere_radius) : "-", w.builder});
        if (const auto& c = cell.contender) {
            for (const std::string& column :
                 {c->backend, c->strategy_name(), c->traversal, c->methods + c->exchanged(), c->types,
                  c->launch.empty() ? std::string("-") : c->launch,
                  c->threads == 0 ? std::string("-") : std::to_string(c->threads)}) {
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
