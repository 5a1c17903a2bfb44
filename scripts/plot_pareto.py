"""Speed against accuracy: which intersection methods nobody beats in both."""

import math

import matplotlib

from plot_chart import LINE_COLOURS, MARKERS, Chart, distinct, short, whisker, workload_title
from plot_inputs import InputError, measured, number, read_rows, require_once, truth
from plot_stability import compact

METHODS = ["methods", "triangle_test", "sphere_test", "box_test"]
FIGURES = ["median_mrays_s", "lo_mrays_s", "hi_mrays_s", "rays", "failures", "failures_per_million", "lo", "hi",
           "p99_scaled_error"]
PANEL = ["scene", "scene_source", "triangles", "spheres", "backend"]
SMALLEST_ERROR = 1e-2  # where the chart of errors ends; rounding alone makes about 1
PANEL_SIZE = (4.8, 3.6)
ARROW = {"marker": r"$\downarrow$", "markersize": 10, "fillstyle": "full", "markeredgewidth": 0}
LINE_OF_TEXT = 9  # points, at font size 7


class Point:
    """One contender: what it is, its figures, and where it lies in both panels."""

    def __init__(self, path, row):
        self.row = row
        self.speed = measured(path, row, "median_mrays_s")
        self.speed_lo, self.speed_hi = (number(path, row, name) for name in ("lo_mrays_s", "hi_mrays_s"))
        self.rays, self.failures = (measured(path, row, name) for name in ("rays", "failures"))
        if self.rays == 0:
            raise InputError(f"{path}:{row['line']}: rays is 0; who traced none has no place in the chart")
        self.rate, self.lo, self.hi = (number(path, row, name) for name in ("failures_per_million", "lo", "hi"))
        self.error = number(path, row, "p99_scaled_error")
        self.on_front = truth(path, row, "on_front")

    @property
    def height(self):
        """None failed of N: at most 3/N did, with a confidence of 95 %."""
        return self.rate if self.failures > 0 else 3e6 / self.rays


class Looks:
    """Colours for the first of the axes that vary, markers for the second; the fill tells a third apart."""

    FILLS = ["full", "none", "left", "top"]

    def __init__(self, rows):
        self.varying = [name for name in METHODS if len({row[name] for row in rows}) > 1]
        ranked = sorted(self.varying, key=lambda name: -len({row[name] for row in rows}))
        self.values = [(name, distinct(row[name] for row in rows)) for name in ranked[:3]]

    def name(self, row):
        parts = [row[name] for name in self.varying if row[name] != "bundle"]
        return " / ".join(parts) or row["methods"]

    def of(self, row):
        at = [values.index(row[name]) for name, values in self.values] + [0] * 3
        return self._look(*at[:3])

    @staticmethod
    def _look(colour, marker, fill):
        return {"color": LINE_COLOURS[colour % len(LINE_COLOURS)], "marker": MARKERS[marker % len(MARKERS)],
                "fillstyle": Looks.FILLS[fill % len(Looks.FILLS)], "markerfacecoloralt": "white", "markersize": 7}

    def legend(self, chart):
        handles = []
        for place, (axis, values) in enumerate(self.values):
            handles.append(matplotlib.lines.Line2D([], [], linestyle="", label=axis.replace("_", " ") + ":"))
            for i, value in enumerate(values):
                look = self._look(*(i if k == place else 0 for k in range(3)))
                if place > 0:
                    look["color"] = "black"
                handles.append(matplotlib.lines.Line2D([], [], linestyle="", label=value, **look))
        chart.figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), frameon=False, ncol=6)


def draw_failures(panel, points, looks):
    for p in points:
        look, bars = looks.of(p.row), {"linestyle": "", "elinewidth": 0.8, "capsize": 2}
        if p.failures == 0:
            look.update(ARROW)
        panel.errorbar(p.speed, p.height, xerr=whisker(p.speed, p.speed_lo, p.speed_hi),
                       yerr=whisker(p.height, p.lo, p.hi) if p.failures > 0 else None, **look, **bars)
    draw_front(panel, sorted((p for p in points if p.on_front), key=lambda p: (p.speed, p.height)), looks)
    panel.set_ylabel("failures per million")


def draw_front(panel, front, looks):
    """A staircase under which nobody is, from the slowest to the fastest; its right side is where names go."""
    if not front:
        return
    left, right = panel.get_xlim()
    top = panel.get_ylim()[1]
    x = [left] + [p.speed for p in front] + [front[-1].speed]
    y = [front[0].height] + [p.height for p in front] + [top]
    panel.step(x, y, where="pre", color="black", linewidth=1, linestyle="--", zorder=1)
    panel.set_xlim(left, right)
    decades = math.log10(top / panel.get_ylim()[0])
    points_of_decade = 72 * 0.75 * PANEL_SIZE[1] / decades
    lowest = math.inf  # so far, in points; names go down where they would lie on another
    for p in reversed(front):
        own = math.log10(p.height) * points_of_decade - LINE_OF_TEXT
        lowest = min(own, lowest - LINE_OF_TEXT)
        panel.annotate(looks.name(p.row), (p.speed, p.height), fontsize=7, textcoords="offset points",
                       xytext=(10 if lowest < own else 6, lowest - own - LINE_OF_TEXT),
                       arrowprops={"arrowstyle": "-", "linewidth": 0.4} if lowest < own else None)


def draw_errors(panel, points, looks):
    for p in points:
        if p.error is None:
            continue
        look = looks.of(p.row)
        if p.on_front:
            look["markeredgecolor"] = "black"
        if p.error <= SMALLEST_ERROR:
            look.update(ARROW)
        panel.plot(p.speed, max(p.error, SMALLEST_ERROR), linestyle="", **look)
    panel.set_ylabel("99th percentile of the error e of t")


def set_axes(panel, points, heights):
    """Room at the right and below for the names on the front."""
    speeds = [v for p in points for v in (p.speed, p.speed_lo, p.speed_hi) if v is not None]
    lowest = min(speeds)
    room = max(max(speeds) - lowest, 0.05 * max(speeds))
    panel.set_xlim(max(0, lowest - 0.1 * room), max(speeds) + 0.55 * room)
    panel.set_yscale("log")
    if heights:
        panel.set_ylim(min(heights) / 4, max(max(heights), 10 * min(heights)) * 3)
    panel.set_xlabel("Mrays/s")


def pareto(folder):
    """A column of two panels for each workload and backend: failures, and the error where nothing failed."""
    path = folder / "pareto.csv"
    rows = read_rows(path, PANEL + METHODS + FIGURES + ["on_front"])
    require_once(path, rows, ["scene", "spheres", "backend"] + METHODS)
    looks, groups = Looks(rows), {}
    for row in rows:
        groups.setdefault((workload_title(path, row), row["backend"]), []).append(Point(path, row))
    chart = Chart("pareto", "Speed and accuracy of intersection methods", len(groups), 2, PANEL_SIZE)
    for (upper, lower), ((title, backend), points) in zip(chart.panels.T, groups.items()):
        set_axes(upper, points, [p.height for p in points])
        set_axes(lower, points, [max(p.error, SMALLEST_ERROR) for p in points if p.error is not None])
        draw_failures(upper, points, looks)
        draw_errors(lower, points, looks)
        upper.set_title(f"{title}\n{backend}")
        said = [f"{looks.name(p.row)} {short(p.speed)} Mrays/s with {compact(p.rate or 0)}"
                for p in sorted(points, key=lambda p: p.speed) if p.on_front]
        chart.words.append(f"{title}, {backend}, on the front, with failures per million: {'; '.join(said)}.")
    looks.legend(chart)
    chart.data = [{name: row[name] for name in PANEL + METHODS + FIGURES + ["on_front"]} for row in rows]
    return chart
