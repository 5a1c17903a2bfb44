"""Our traversals beside Embree's ways to trace, by the number of threads."""

import matplotlib

from plot_chart import Chart, distinct, line_looks, short, whisker, with_interval
from plot_inputs import InputError, Summary, measured, number, read_rows, require_once

NAMES = ["scene", "rays", "contender", "threads"]
FIGURES = ["median_mrays_s", "ratio_to_rtcintersect1", "ratio_lo", "ratio_hi", "mismatch_rate"]
RATIO = FIGURES[1:4]
INTERSECT1, ROBUST = "embree_default", "_robust"
SPREAD = 0.7  # of the way from one number of threads to the next, for those who would lie on one another
TICKS = [0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 3, 4, 5, 7, 10]


def family(contender):
    """Those that differ in Embree's flag alone look alike but for their fill."""
    base = contender.removesuffix(ROBUST)
    return INTERSECT1 if base == "embree" else base


def is_robust(contender):
    return contender.startswith("embree") and contender.endswith(ROBUST)


def looks_of(contenders):
    looks = line_looks(distinct(family(c) for c in contenders))
    return {c: {**looks[family(c)], "fillstyle": "none" if is_robust(c) else "full",
                "linestyle": (0, (3, 2)) if is_robust(c) else "-"} for c in contenders}


class Peers:
    """The rows by panel, and within one by contender: (threads, ratio, lo, hi, mismatch rate)."""

    def __init__(self, path):
        self.rows = read_rows(path, NAMES + FIGURES)
        require_once(path, self.rows, NAMES)
        self.threads, self.points = set(), {}
        for row in self.rows:
            threads = measured(path, row, "threads")
            if threads < 1 or threads != int(threads):
                raise InputError(f"{path}:{row['line']}: threads is \"{row['threads']}\"; expected a number of "
                                 "threads, 1 or more")
            measured(path, row, "median_mrays_s")
            rate = number(path, row, "mismatch_rate")
            ratio = [number(path, row, name) for name in RATIO]
            if ratio[0] is None:
                continue
            if ratio[0] == 0:
                raise InputError(f"{path}:{row['line']}: {RATIO[0]} is \"{row[RATIO[0]]}\"; expected more than 0")
            self.threads.add(int(threads))
            panel = self.points.setdefault((row["scene"], row["rays"]), {})
            panel.setdefault(row["contender"], []).append((int(threads), *ratio, rate))
        if not self.points:
            raise InputError(f"{path}: no ratio to rtcIntersect1; measure {INTERSECT1} too, or remove the file")
        self.scenes = distinct(scene for scene, _ in self.points)
        self.rays = distinct(rays for _, rays in self.points)
        self.contenders = [c for c in distinct(row["contender"] for row in self.rows)
                           if any(c in panel for panel in self.points.values())]


def draw_panel(panel, of, peers, looks):
    places = {threads: i for i, threads in enumerate(sorted(peers.threads))}
    panel.axhline(1, color="black", linewidth=0.8, linestyle="--", zorder=1)
    for i, contender in enumerate(peers.contenders):
        if contender not in of:
            continue
        points = sorted(of[contender])
        aside = SPREAD * ((i + 0.5) / len(peers.contenders) - 0.5)
        bars = [whisker(*point[1:4]) or [[0], [0]] for point in points]
        panel.errorbar([places[point[0]] + aside for point in points], [point[1] for point in points],
                       yerr=[[b[0][0] for b in bars], [b[1][0] for b in bars]], **looks[contender], markersize=5,
                       linewidth=0.7, elinewidth=0.9, capsize=1.8)
    panel.set_xticks(list(places.values()), list(places))
    panel.set_xlim(-0.5, len(places) - 0.5)
    for place in range(1, len(places)):
        panel.axvline(place - 0.5, color="#C8C8C8", linewidth=0.8)
    panel.set_yscale("log")
    panel.yaxis.set_major_locator(matplotlib.ticker.FixedLocator(TICKS))
    panel.yaxis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda y, _: f"{y:g}"))
    panel.yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    panel.grid(axis="y", linewidth=0.4, color="#D8D8D8")
    panel.set_axisbelow(True)


def say(of, contenders):
    def one(contender):
        by_threads = [f"{with_interval(*point[1:4])} ({point[0]})" for point in sorted(of[contender])]
        rate = max(point[4] or 0 for point in of[contender])
        return f"{contender} {', '.join(by_threads)}" + (f", {short(1e6 * rate)} mismatches per million" if rate else "")
    return "; ".join(one(c) for c in contenders if c in of)


def peers(folder):
    """A row of panels for each scene, which have one scale, a column for each class of rays."""
    found, summary = Peers(folder / "peers.csv"), Summary(folder)
    looks = looks_of(found.contenders)
    chart = Chart("peers", "Our traversals beside Embree's, on the same rays", len(found.rays), len(found.scenes),
                  (1.2 + 1.5 * len(found.threads), 3.0))
    for panels, scene in zip(chart.panels, found.scenes):
        name = scene.split("/")[0]
        title = summary.title(name).replace(name, scene, 1)
        of_scene = [found.points.get((scene, rays), {}) for rays in found.rays]
        ends = [y for of in of_scene for points in of.values() for p in points for y in p[1:4] if y]
        for panel, rays, of in zip(panels, found.rays, of_scene):
            if not of:
                panel.set_axis_off()
                continue
            draw_panel(panel, of, found, looks)
            panel.set_ylim(min(ends + [1]) / 1.15, max(ends + [1]) * 1.15)
            panel.set_title(f"{scene}, {rays}")
            panel.set_xlabel("threads")
            chart.words.append(f"{title}, {rays}, ratio to rtcIntersect1, by threads: {say(of, found.contenders)}.")
        panels[0].set_ylabel(title.replace(" (", "\n(") + "\nspeed / rtcIntersect1")
    chart.line_legend(looks, markersize=6)
    chart.data = [{name: row[name] for name in NAMES + FIGURES} for row in found.rows]
    return chart
