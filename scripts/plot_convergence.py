"""The error of rendered images against the seconds spent on them."""

from plot_chart import LINE_COLOURS, MARKERS, Chart, distinct, workload_title
from plot_inputs import InputError, measured, number, read_rows, require_once, truth

WORKLOAD = ["scene", "scene_source", "triangles", "spheres", "backend"]
CONTENDER = ["strategy", "shade", "methods", "offset", "bounces", "roulette"]
FIGURES = ["seeds", "samples", "seconds", "lo_seconds", "hi_seconds", "relmse", "lo_relmse", "hi_relmse", "rmse"]
FITTED = ["slope", "lo_slope", "hi_slope", "bias_relmse", "lo_bias", "hi_bias"]

# A panel for each question, and which columns may differ from the first contender's there.
GROUPS = {"strategies": ["strategy", "shade", "methods"], "offsets": ["offset"],
          "bounce limits and roulette": ["bounces", "roulette"]}
OTHERS = "several at once"


class Curve:
    """One contender on one workload: its points by samples, and what was fitted to them."""

    def __init__(self, path, rows):
        self.row = rows[0]
        self.points = sorted((measured(path, row, "samples"), measured(path, row, "seconds"),
                              measured(path, row, "relmse", signed=True),
                              *(number(path, row, name, signed=True) for name in FIGURES[3:5] + FIGURES[6:8]))
                             for row in rows)
        self.fit = dict.fromkeys(FITTED)

    def read_fit(self, path, row):
        self.fit = {name: number(path, row, name, signed=True) for name in FITTED}

    @property
    def plateau(self):
        """The height below which the error does not fall, where it is told from none."""
        return self.fit["bias_relmse"] if (self.fit["lo_bias"] or 0) > 0 else None

    def said(self):
        parts = []
        if self.fit["slope"] is not None:
            parts.append(f"slope {signed(self.fit['slope'])}"
                         + interval(self.fit["lo_slope"], self.fit["hi_slope"], signed))
        if self.plateau is not None:
            parts.append(f"plateau {height_of(self.plateau)}" + interval(self.fit["lo_bias"], self.fit["hi_bias"], brief))
        return parts


def signed(value):
    return f"{value:.3f}".replace("-", "\N{MINUS SIGN}")


def brief(value):
    return f"{value:.2g}"


def height_of(plateau):
    """As relMSE, and as the share by which pixels are off."""
    return f"{plateau:.2g} ({100 * plateau ** 0.5:.2g} %)"


def interval(lo, hi, text):
    return "" if lo is None or hi is None else f" [{text(lo)}, {text(hi)}]"


def key_of(row, names):
    return tuple(row[name] for name in names)


def read_curves(folder):
    """By workload, the contenders in the order of the file."""
    path, fits = folder / "convergence.csv", folder / "convergence_fits.csv"
    rows = read_rows(path, WORKLOAD + CONTENDER + FIGURES)
    require_once(path, rows, ["scene", "spheres", "backend"] + CONTENDER + ["samples"])
    grouped, titles = {}, {}
    for row in rows:
        truth(path, row, "roulette")
        titles[key_of(row, WORKLOAD)] = f"{workload_title(path, row)}\n{row['backend']}"
        grouped.setdefault(key_of(row, WORKLOAD + CONTENDER), []).append(row)
    curves = {key: Curve(path, of) for key, of in grouped.items()}
    if fits.exists():
        for row in read_rows(fits, WORKLOAD + CONTENDER + FITTED):
            key = key_of(row, WORKLOAD + CONTENDER)
            if key not in curves:
                raise InputError(f"{fits}:{row['line']}: no such contender in {path.name}; run the experiment again")
            curves[key].read_fit(fits, row)
    workloads = {}
    for key, curve in curves.items():
        workloads.setdefault(key[:len(WORKLOAD)], []).append(curve)
    return rows, titles, workloads


def group(curves):
    """The first contender belongs to each group, as what the others are compared with."""
    first, groups = curves[0], {name: [curves[0]] for name in [*GROUPS, OTHERS]}
    for curve in curves[1:]:
        differs = [name for name in CONTENDER if curve.row[name] != first.row[name]]
        home = next((name for name, may in GROUPS.items() if set(differs) <= set(may)), OTHERS)
        groups[home].append(curve)
    return {name: members for name, members in groups.items() if len(members) > 1}


def names_in(members):
    """What tells the members apart."""
    varying = [name for name in CONTENDER if len({curve.row[name] for curve in members}) > 1]
    if {"strategy", "shade"} & set(varying):  # both, as the program's own names have it
        varying = ["strategy", *(name for name in varying if name not in ("strategy", "shade"))]

    def part(row, name):
        if name == "strategy":
            return f"{row['strategy']}+{row['shade']}"
        if name == "bounces":
            return f"{row[name]} bounces"
        if name == "roulette":
            return "roulette" if row[name] == "true" else ""
        return row[name].replace("_", " ")
    return [", ".join(filter(None, (part(curve.row, name) for name in varying))) for curve in members]


def draw_curve(panel, curve, name, colour, marker):
    shown = [p for p in curve.points if p[2] > 0]
    x, y = [p[1] for p in shown], [p[2] for p in shown]
    x_bars = [[max(v - (v if p[3] is None else p[3]), 0) for v, p in zip(x, shown)],
              [max((v if p[4] is None else p[4]) - v, 0) for v, p in zip(x, shown)]]
    y_bars = [[v - max(v if p[5] is None else min(p[5], v), v / 10) for v, p in zip(y, shown)],
              [max((v if p[6] is None else p[6]) - v, 0) for v, p in zip(y, shown)]]
    panel.errorbar(x, y, xerr=x_bars, yerr=y_bars, color=colour, marker=marker, markersize=4, linewidth=1.1,
                   elinewidth=0.7, capsize=1.5, label="\n    ".join([name, *curve.said()]))
    if curve.plateau is not None:
        panel.axhline(curve.plateau, color=colour, linestyle=(0, (6, 3)), linewidth=0.9)
        panel.axhspan(max(curve.fit["lo_bias"], curve.plateau / 10), curve.fit["hi_bias"] or curve.plateau,
                      color=colour, alpha=0.12, linewidth=0)
        panel.annotate(height_of(curve.plateau), (0.01, curve.plateau), xytext=(0, 2.5), fontsize=7,
                       xycoords=("axes fraction", "data"), textcoords="offset points", color=colour)
    return x, y


def draw_guide(panel, x, y):
    """What an unbiased estimator does, beside the first curve: the error of n samples falls as 1 / sqrt(n)."""
    start, end = x[0], x[-1]
    height = 2.2 * y[0]
    panel.plot([start, end], [height, height * start / end], color="black", linewidth=1, linestyle=":")
    middle = (start * end) ** 0.5
    panel.annotate("RMSE slope \N{MINUS SIGN}1/2\n(relMSE \N{MINUS SIGN}1)", (middle, height * start / middle),
                   xytext=(4, 2), textcoords="offset points", fontsize=7)


def draw_panel(panel, members, title):
    panel.set_xscale("log")
    panel.set_yscale("log")
    guide = None
    for i, (curve, name) in enumerate(zip(members, names_in(members))):
        drawn = draw_curve(panel, curve, name, LINE_COLOURS[i % len(LINE_COLOURS)], MARKERS[i % len(MARKERS)])
        guide = guide or (drawn if len(drawn[0]) > 1 else None)
    if guide:
        draw_guide(panel, *guide)
    panel.set_title(title)
    panel.set_xlabel("seconds")
    panel.set_ylabel("relMSE")
    panel.legend(loc="upper left", bbox_to_anchor=(1, 1.02), fontsize=7, frameon=False)


def convergence(folder):
    """A row of panels for each workload, a column for each question; slopes are of RMSE, the root of relMSE."""
    rows, titles, workloads = read_curves(folder)
    grouped = {workload: group(curves) or {"": curves} for workload, curves in workloads.items()}
    questions = [name for name in ["", *GROUPS, OTHERS] if any(name in groups for groups in grouped.values())]
    chart = Chart("convergence", "Error of images against time; slopes are of RMSE, the root of relMSE",
                  len(questions), len(workloads), (5.6, 3.6))
    for panels, (workload, groups) in zip(chart.panels, grouped.items()):
        for panel, question in zip(panels, questions):
            if question not in groups:
                panel.set_axis_off()
                continue
            draw_panel(panel, groups[question], "\n".join(filter(None, [titles[workload], question])))
        for curve in workloads[workload]:
            row, last = curve.row, curve.points[-1]
            chart.words.append(
                f"{row['scene']}, {row['backend']}, " + ", ".join(row[name] for name in CONTENDER[:4])
                + f", {row['bounces']} bounces" + (", roulette" if row["roulette"] == "true" else "")
                + f": relMSE {last[2]:.2g} after {last[0]:.0f} samples; {'; '.join(curve.said()) or 'no fit'}.")
    fits = {key_of(c.row, WORKLOAD + CONTENDER): c.fit for curves in workloads.values() for c in curves}
    for row in rows:
        fit = fits[key_of(row, WORKLOAD + CONTENDER)]
        chart.data.append({**{name: row[name] for name in WORKLOAD + CONTENDER + FIGURES},
                           **{name: "" if fit[name] is None else fit[name] for name in FITTED}})
    return chart
