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

// A yardstick's traversal, methods and types: they are its own, whatever these axes say.
inline constexpr const char* own_way = "own";

// Who traces it.
struct Contender {
    std::string backend;
    std::string strategy;
    bool restart_carries_t = true;  // means nothing unless the strategy is restart
    std::string traversal;          // own_way for a yardstick
    std::string methods;            // own_way for a yardstick
    std::string shade = no_shade;
    std::string launch{};  // of a frame on a GPU; else empty
    std::string triangle_test = of_bundle, sphere_test = of_bundle, box_test = of_bundle;
    std::string offset = of_bundle;
    std::uint32_t bounce_limit = 0;      // of a frame; 0: the config's `bounces`
    bool roulette = false;               // of a frame
    std::string types = types_of_scene;  // that it is compiled for; own_way for a yardstick
    std::uint32_t threads = 0;           // of the CPU that trace recorded rays; 0: the run's own

    // Whether whole frames are measured rather than the intersection of recorded rays.
    bool renders() const { return shade != no_shade; }
    bool is_yardstick() const { return methods == own_way; }

    // What a study of methods compares it with: "triangle", "sphere", "box" or "offset" if that is the one
    // part exchanged in its bundle, else "bundle" (a yardstick is a bundle too).
    std::string kind() const;
    // Its name among those of its kind: `pluecker`, `watertight`, `embree_robust`; several parts are joined.
    std::string method() const;

    // Short and unique within a workload: the strategy (`restart_fresh_t` for a restart whose second pass
    // starts without the first one's hit), `+shade` if it renders, then `/x` for each axis that has not its
    // default.
    std::string label() const;
    // The same without the backend, for what tells backends apart by itself.
    std::string label_on_backend() const;
    // The strategy with what belongs to it: `restart_fresh_t`, `restart+sort`.
    std::string strategy_name() const;
    // `/all`; nothing for the default.
    std::string types_part() const;
    // `/1thread`, `/2threads`; nothing for the run's own.
    std::string threads_part() const;
    // `/pluecker/limit4/roulette`: what is neither strategy, traversal, methods, types, launch nor
    // threads and has not its default.
    std::string exchanged() const;
    bool operator==(const Contender&) const = default;
};

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
// spheres, traversal, methods and types for yardsticks, launch but for frames on a GPU, threads but for rays
// on a CPU, offset but for frames and in a stability study, all of a contender if nothing is measured. A
// yardstick is a cell on its own backend alone. In a stability study the workloads are the config's `stress`,
// each with those who can meet it.
std::vector<Cell> expand(const Config& config, const KnownNames& known);

// The cells of these axes alone, in a config like this.
std::vector<Cell> expand_axes(const Axes& axes, const Config& config, const KnownNames& known);

// Whether every axis that `pattern` gives means something for the cell and holds the cell's value.
bool matches(const Cell& cell, const Axes& pattern, Study study);

// The cells whose name contains `part`, letter for letter. Throws Error(usage) if none does.
std::vector<Cell> filter(const std::vector<Cell>& cells, std::string_view part);

// Whether a CUDA device is to measure any of them.
bool any_on_cuda(const std::vector<Cell>& cells);

// Workloads in order of first appearance.
std::vector<WorkloadCells> group_by_workload(const std::vector<Cell>& cells);

// A table with a line per cell, for --dry-run.
std::string format_cells(const std::vector<Cell>& cells);

}  // namespace ctpbench
