"""The heat map of methods against workloads: how often a method fails on rays made to break it."""

import matplotlib

from plot_chart import Chart, distinct
from plot_inputs import measured, number, read_rows, require_once, truth

# Of failures per million. Lightness falls all the way, so that it prints; blue for none is far from all of it to
# eyes of every kind.
COLOURS = matplotlib.colormaps["YlOrBr"]
NONE_COLOUR, NOT_RUN_COLOUR = "#CFE3F2", "#E4E4E4"
SCALE = (1.0, 1e6)

COLUMNS = ["kind", "method", "is_default", "backend", "workload", "rays", "failures", "failures_per_million", "lo",
           "hi"]


def compact(value):
    """At most four characters up to a million: 0, 0.3, 72, 4.9k, 110k, 1M."""
    for limit, unit, letter in ((999.5e3, 1e6, "M"), (999.5, 1e3, "k"), (0, 1, "")):
        if value >= limit:
            scaled = value / unit
            return (f"{scaled:.0f}" if scaled >= 9.95 else f"{scaled:.1f}".removesuffix(".0")) + letter
    raise AssertionError("counts are not negative")


def colour_of(rate):
    if rate == 0:
        return NONE_COLOUR
    return COLOURS(matplotlib.colors.LogNorm(*SCALE, clip=True)(rate))


def ink_on(colour):
    red, green, blue = matplotlib.colors.to_rgb(colour)
    return "white" if 0.299 * red + 0.587 * green + 0.114 * blue < 0.5 else "black"


def draw_cell(panel, x, y, rate):
    if rate is None:
        panel.add_patch(matplotlib.patches.Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=NOT_RUN_COLOUR,
                                                     edgecolor="#B0B0B0", hatch="////", linewidth=0))
        return
    colour = colour_of(rate)
    panel.add_patch(matplotlib.patches.Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=colour, edgecolor="white",
                                                 linewidth=0.8))
    panel.text(x, y, compact(rate), ha="center", va="center", fontsize=7, color=ink_on(colour))


def draw_kind(panel, kind, methods, workloads, rates, width):
    """`methods` maps (method, backend) to the name of a line; `rates` lacks what was not run."""
    for y, key in enumerate(methods):
        for x, workload in enumerate(workloads):
            draw_cell(panel, x, y, rates.get((kind, *key, workload)))
    panel.set_xlim(-0.5, width - 0.5)
    panel.set_ylim(len(methods) - 0.5, -0.5)
    panel.set_xticks(range(len(workloads)), workloads, rotation=55, ha="left", rotation_mode="anchor", fontsize=8)
    panel.set_yticks(range(len(methods)), methods.values(), fontsize=8)
    for label, name in zip(panel.get_yticklabels(), methods.values()):
        label.set_fontweight("bold" if name.endswith("*") else "normal")
    panel.tick_params(length=0, top=True, labeltop=True, bottom=False, labelbottom=False)
    panel.spines[:].set_visible(False)
    panel.set_ylabel(kind, fontsize=10, fontweight="bold")


def add_key(chart):
    """What the colours mean, below the panels."""
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.LogNorm(*SCALE), COLOURS)
    bar = chart.figure.colorbar(scale, ax=chart.panels, location="bottom", fraction=0.05, shrink=0.4, aspect=30,
                                pad=0.02)
    bar.set_label("failures per million rays")
    handles = [matplotlib.patches.Patch(facecolor=NONE_COLOUR, edgecolor="grey", linewidth=0.5, label="none"),
               matplotlib.patches.Patch(facecolor=NOT_RUN_COLOUR, edgecolor="#B0B0B0", hatch="////", linewidth=0,
                                        label="never meets it"),
               matplotlib.lines.Line2D([], [], linestyle="", label="*, bold: the default")]
    chart.figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), frameon=False, ncol=3)


def stability(folder):
    """A panel for each kind of method, since each kind has workloads of its own; cells of one size throughout."""
    path = folder / "stability.csv"
    rows = read_rows(path, COLUMNS)
    require_once(path, rows, ["kind", "method", "backend", "workload"])
    kinds, backends = distinct(row["kind"] for row in rows), distinct(row["backend"] for row in rows)
    rates, methods, workloads = {}, {kind: {} for kind in kinds}, {kind: [] for kind in kinds}
    for row in rows:
        rays, key = measured(path, row, "rays"), (row["method"], row["backend"])
        measured(path, row, "failures")
        name = row["method"] + (f", {row['backend']}" if len(backends) > 1 else "")
        methods[row["kind"]][key] = name + (" *" if truth(path, row, "is_default") else "")
        if row["workload"] not in workloads[row["kind"]]:
            workloads[row["kind"]].append(row["workload"])
        rate = number(path, row, "failures_per_million")
        if rays > 0 and rate is not None:
            rates[(row["kind"], *key, row["workload"])] = rate

    width = max(len(names) for names in workloads.values())
    lines = [len(methods[kind]) for kind in kinds]
    labels = max(len(name) for names in workloads.values() for name in names)
    chart = Chart("stability", "Failures of each method on rays made to break it, per million", 1, len(kinds),
                  (2.2 + 0.38 * width, 0.25 * sum(lines) / len(kinds) + 0.35 + 0.05 * labels), lines)
    for panel, kind in zip(chart.panels[:, 0], kinds):
        draw_kind(panel, kind, methods[kind], workloads[kind], rates, width)
        for key, name in methods[kind].items():
            said = [f"{workload} {compact(rates[(kind, *key, workload)])}" for workload in workloads[kind]
                    if (kind, *key, workload) in rates]
            chart.words.append(f"{kind} {name}: {', '.join(said) or 'not run'}.")
    add_key(chart)
    chart.data = [{name: row[name] for name in COLUMNS} for row in rows]
    return chart
