"""What it gains to compile kernels for the types of the scene alone, rather than for all that are known."""

import textwrap

from plot_chart import Chart, distinct, line_looks, whisker, with_interval, workload_title
from plot_inputs import InputError, number, read_rows, require_once

KERNELS = ["intersect", "shade"]
WORKLOAD = ["scene", "scene_source", "triangles", "spheres"]
NAMES = WORKLOAD + ["backend", "kernel", "strategy", "types"]
FIGURES = ["all_mrays_s", "scene_mrays_s", "gain", "gain_lo", "gain_hi", "all_bytes", "scene_bytes"]
LANE = 0.105  # inches; one for each strategy and each line of text
LINE_OF_TYPES = 60  # letters that fit a panel


class Gains:
    """The rows by where they are drawn."""

    def __init__(self, folder):
        self.path = folder / "narrowing.csv"
        self.rows = read_rows(self.path, NAMES + FIGURES)
        require_once(self.path, self.rows, ["scene", "spheres", "backend", "kernel", "strategy"])
        self.gains, self.titles, self.types, self.strategies = {}, {}, {}, {}
        for row in self.rows:
            self._add(row)
        self.kernels = [kernel for kernel in KERNELS if kernel in self.strategies]
        self.backends = distinct(row["backend"] for row in self.rows)

    def _add(self, row):
        kernel, workload = row["kernel"], tuple(row[name] for name in WORKLOAD)
        if kernel not in KERNELS:
            raise InputError(f"{self.path}:{row['line']}: unknown kernel \"{kernel}\"; known are {', '.join(KERNELS)}")
        types = self.types.setdefault((workload, kernel), row["types"])
        if types != row["types"]:
            raise InputError(f"{self.path}:{row['line']}: types is \"{row['types']}\", but \"{types}\" on a line above "
                             "for the same scene and kernel")
        for name in FIGURES:
            number(self.path, row, name)
        self.titles[workload] = workload_title(self.path, row)
        self.gains[(workload, row["backend"], kernel, row["strategy"])] = [number(self.path, row, name)
                                                                         for name in ("gain", "gain_lo", "gain_hi")]
        if row["strategy"] not in self.strategies.setdefault(kernel, []):
            self.strategies[kernel].append(row["strategy"])

    def of(self, workload, backend, kernel):
        """Of the strategies that were measured."""
        found = {s: self.gains.get((workload, backend, kernel, s)) for s in self.strategies[kernel]}
        return {s: gain for s, gain in found.items() if gain and gain[0] is not None}

    def lines_of_types(self, workload, kernel):
        return textwrap.wrap(self.types.get((workload, kernel), "").replace("+", " + "), LINE_OF_TYPES)


def place(gains):
    """The first lane of each workload, and the number of all; its types come first, then its strategies."""
    lanes, tops = 0, {}
    for workload in gains.titles:
        tops[workload] = lanes
        lanes += 1.2 + max(len(gains.lines_of_types(workload, kernel)) + len(gains.strategies[kernel])
                           for kernel in gains.kernels)
    return tops, lanes


def draw_workload(panel, top, types, gains, strategies, looks, ground):
    panel.text(0.015, top + 0.35, "\n".join(types), transform=panel.get_yaxis_transform(), va="top", fontsize=7,
               color="#404040", linespacing=1, bbox={"facecolor": ground, "linewidth": 0, "pad": 0.5})
    for lane, strategy in enumerate(strategies, len(types)):
        if strategy in gains:
            panel.errorbar(gains[strategy][0], top + lane + 1, xerr=whisker(*gains[strategy]), **looks[strategy],
                           linestyle="", markersize=4, elinewidth=1, capsize=2)


def narrowing(folder):
    """A row of panels for each backend, a column for each kernel; the scenes share their height across."""
    gains = Gains(folder)
    looks = line_looks(distinct(s for kernel in gains.kernels for s in gains.strategies[kernel]))
    tops, lanes = place(gains)
    chart = Chart("narrowing", "Kernels compiled for the scene's types alone, against for all types",
                  len(gains.kernels), len(gains.backends), (4.0, 0.7 + LANE * lanes))
    ends = [*list(tops.values())[1:], lanes]
    for panels, backend in zip(chart.panels, gains.backends):
        for panel, kernel in zip(panels, gains.kernels):
            panel.axvline(1, color="black", linewidth=0.8, linestyle="--", zorder=1)
            for i, (workload, top) in enumerate(tops.items()):
                found, types = gains.of(workload, backend, kernel), gains.lines_of_types(workload, kernel)
                ground = "white" if i % 2 else "#F2F2F2"
                panel.axhspan(top, ends[i], color=ground, linewidth=0, zorder=0)
                draw_workload(panel, top, types, found, gains.strategies[kernel], looks, ground)
                said = [f"{strategy} {with_interval(*gain)}" for strategy, gain in found.items()]
                if said:
                    chart.words.append(f"{gains.titles[workload]}, {backend}, {kernel}, "
                                       f"{gains.types[(workload, kernel)]}, gain: {'; '.join(said)}.")
            panel.set_title(f"{kernel}, {backend}")
            panel.set_xlabel("speed with the scene's types / with all")
            panel.set_ylim(lanes, 0)
            panel.set_yticks([(top + end) / 2 for top, end in zip(tops.values(), ends)],
                             [title.replace(" (", "\n(").replace("), ", "),\n") for title in gains.titles.values()],
                             fontsize=8)
            panel.tick_params(axis="y", length=0, labelleft=panel is panels[0])
            panel.locator_params(axis="x", nbins=6)
            panel.grid(axis="x", linewidth=0.4, color="#C8C8C8")
            panel.set_axisbelow(True)
    chart.line_legend(looks, linestyle="", markersize=5)
    chart.data = [{name: row[name] for name in NAMES + FIGURES} for row in gains.rows]
    return chart
