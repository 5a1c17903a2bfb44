"""What a ray costs as its scene's triangles grow in number."""

import math

from plot_chart import Chart, distinct, line_looks, short, whisker
from plot_inputs import InputError, count, measured, number, read_rows, require_once

NAMES = ["scene", "triangles", "rays", "contender", "threads"]
COST = ["ns_per_ray", "lo_ns", "hi_ns"]


def growth(folder):
    """A panel for each class of rays."""
    path = folder / "growth.csv"
    rows = read_rows(path, NAMES + COST)
    require_once(path, rows, NAMES)
    points = {}  # by rays, then by contender: (triangles, nanoseconds, lo, hi)
    for row in rows:
        triangles, cost = measured(path, row, "triangles"), measured(path, row, COST[0])
        if not triangles or not cost:
            raise InputError(f"{path}:{row['line']}: triangles and {COST[0]} must be more than 0 on a chart with "
                             "logarithmic axes; remove the row")
        threads = int(measured(path, row, "threads"))
        who = f"{row['contender']}, {threads} thread{'s' if threads != 1 else ''}"
        points.setdefault(row["rays"], {}).setdefault(who, []).append(
            (triangles, cost, number(path, row, COST[1]), number(path, row, COST[2])))
    who = distinct(name for of in points.values() for name in of)
    looks = line_looks(who)
    chart = Chart("growth", "What a ray costs as triangles grow", len(points), 1, (3.6, 3.4))
    ends = [y for of in points.values() for line in of.values() for p in line for y in p[1:] if y]
    for panel, (rays, of) in zip(chart.panels[0], points.items()):
        for name, line in of.items():
            line.sort()
            bars = [whisker(*p[1:]) or [[0], [0]] for p in line]
            panel.errorbar([p[0] for p in line], [p[1] for p in line],
                           yerr=[[b[0][0] for b in bars], [b[1][0] for b in bars]], **looks[name], markersize=5,
                           linewidth=1, elinewidth=0.9, capsize=2)
            chart.words.append(f"{rays}, {name}, nanoseconds by triangles: " +
                               ", ".join(f"{short(p[1])} ({count(p[0])})" for p in line) + ".")
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.set_ylim(10 ** math.floor(math.log10(min(ends))), max(ends) * 1.3)
        panel.set_title(rays)
        panel.set_xlabel("triangles")
        panel.grid(axis="y", which="both", linewidth=0.4, color="#D8D8D8")
        panel.set_axisbelow(True)
    chart.panels[0][0].set_ylabel("nanoseconds per ray")
    chart.line_legend(looks, markersize=6)
    chart.data = [{name: row[name] for name in NAMES + COST} for row in rows]
    return chart
