// The matrix of a config, multiplied out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/config.h"

namespace ctpbench {

// What is traced: it fixes the trees and, with the reference strategy, the rays.
struct Workload {
    std::string scene;
    std::uint32_t spheres = 0;
    double sphere_radius = 0;
    std::string builder;

    // `conference/1000`; a sphere radius and a builder other than the default are appended.
    std::string name() const;
    bool operator==(const Workload&) const = default;
};

// Who traces it.
struct Contender {
    std::string backend;
    std::string strategy;
    bool restart_carries_t = true;  // means nothing unless the strategy is restart
    std::string traversal;          // own_way for a yardstick
    std::string methods;            // own_way for a yardstick
    std::string shade = no_shade;
    std::string launch{};  // of a frame on a GPU; else empty

    // Whether whole frames are measured rather than the intersection of recorded rays.
    bool renders() const { return shade != no_shade; }

    // Short and unique within a workload: the strategy (`restart_fresh_t` for a restart whose second pass
    // starts without the first one's hit), `+shade` if it renders, then `/x` for each axis that has not its
    // default.
    std::string label() const;
    // The same without the backend, for what tells backends apart by itself.
    std::string label_on_backend() const;
    bool operator==(const Contender&) const = default;
};

// A yardstick's traversal and methods: they are its own, whatever these axes say.
inline constexpr const char* own_way = "own";

struct Cell {
    Workload workload;
    std::optional<Contender> contender;  // none if the config measures nothing

    // `conference/1000/cpu/ctp/single/watertight`, `conference/0/cpu/restart+sort/single/watertight`
    std::string name() const;
    bool operator==(const Cell&) const = default;
};

// One workload and all that are measured on it, in rounds together.
struct WorkloadCells {
    Workload workload;
    std::vector<Contender> contenders;
};

// Cells in the order of axes.h, an axis' values in the order written; then those of `include`. An axis that
// means nothing for a cell makes no further cells: restart_carries_t but for restart, sphere_radius without
// spheres, traversal and methods for yardsticks, launch but for frames on a GPU, all of a contender if
// nothing is measured. A yardstick is a cell on its own backend alone.
std::vector<Cell> expand(const Config& config, const KnownNames& known);

// The cells of these axes alone.
std::vector<Cell> expand_axes(const Axes& axes, bool measure, const KnownNames& known);

// Whether every axis that `pattern` gives means something for the cell and holds the cell's value.
bool matches(const Cell& cell, const Axes& pattern);

// The cells whose name contains `part`, letter for letter. Throws Error(usage) if none does.
std::vector<Cell> filter(const std::vector<Cell>& cells, std::string_view part);

// Workloads in order of first appearance.
std::vector<WorkloadCells> group_by_workload(const std::vector<Cell>& cells);

// A table with a line per cell, for --dry-run.
std::string format_cells(const std::vector<Cell>& cells);

}  // namespace ctpbench
