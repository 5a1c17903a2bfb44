"""Speed of each dispatch strategy as the number of types in its list grows."""

import math

import matplotlib

from plot_chart import Chart, distinct, line_looks, short, whisker
from plot_inputs import InputError
from plot_types_inputs import (DRAWN, FIGURES, GROUP, LARGE, NAMES, REFERENCE, all_used, crossovers, one_large,
                               read_groups, some_used)


def draw_series(panel, series, looks, dodge):
    """`dodge` moves the x of the i-th of n strategies aside, so that their intervals can be told apart."""
    for i, (strategy, points) in enumerate(series.items()):
        bars = [whisker(*y) or [[0], [0]] for y in points.values()]
        panel.errorbar([dodge(x, i - (len(series) - 1) / 2) for x in points], [y[0] for y in points.values()],
                       yerr=[[b[0][0] for b in bars], [b[1][0] for b in bars]], **looks[strategy], markersize=4,
                       linewidth=1.1, elinewidth=0.8, capsize=1.5)


def draw_counts(panel, series, looks):
    panel.set_xscale("log", base=2)
    counts = sorted({x for points in series.values() for x in points})
    aside = 0.008 * max(math.log2(counts[-1] / counts[0]), 1)
    draw_series(panel, series, looks, lambda x, place: x * 2 ** (aside * place))
    if len(counts) > 8:
        counts = [n for n in counts if n & (n - 1) == 0]
    panel.set_xticks(counts, counts)
    panel.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())


def draw_large(panel, series, looks):
    """A line for each strategy and (listed, used), from no large type to one that is used."""
    keys = sorted({key for points in series.values() for key in points})
    counts = distinct(key[:2] for key in keys)
    at = {key: i + 0.7 * counts.index(key[:2]) for i, key in enumerate(keys)}
    for pair in counts:
        part = {s: {key: y for key, y in points.items() if key[:2] == pair} for s, points in series.items()}
        draw_series(panel, part, looks, lambda key, place: at[key] + 0.07 * place)
        middle = sum(at[key] for key in keys if key[:2] == pair) / sum(key[:2] == pair for key in keys)
        panel.text(middle, 0.99, f"{pair[0]} listed,\n{pair[1]} used", transform=panel.get_xaxis_transform(),
                   ha="center", va="top", fontsize=8)
        if pair != counts[0]:
            panel.axvline(min(at[key] for key in keys if key[:2] == pair) - 0.85, color="#C8C8C8", linewidth=0.8)
    panel.set_xticks(list(at.values()), [LARGE[key[2]] for key in keys], rotation=90 if len(keys) > 4 else 0)
    panel.set_xlim(-0.6, max(at.values()) + 0.6)


def panels_of(rows, kernel):
    """By column: the title, the label of x, the ratios and how to draw them; only of what was measured."""
    listed, used = some_used(rows, kernel)
    panels = {"all": ("all listed types used", "types listed", all_used(rows, kernel), draw_counts),
              "some": (f"{listed} types listed", "types used", used, draw_counts),
              "large": ("one type large", "large type in the list", one_large(rows, kernel), draw_large)}
    return {name: panel for name, panel in panels.items() if panel[2]}


def say(key):
    return f"{key[1]} of {key[0]}, {LARGE[key[2]]}" if isinstance(key, tuple) else str(key)


def types(folder):
    """A row of panels for each scene, backend and kernel; a kernel's panels have one scale."""
    path = folder / "types.csv"
    rows, groups = read_groups(path)
    lines = [(title, kernel, panels) for title, of in groups.values() for kernel in DRAWN
             if (panels := panels_of(of, kernel))]
    if not lines:
        raise InputError(f"{path}: no ratio of {' or '.join(DRAWN)}; run the experiment again, or remove the file")
    names = [name for name in ("all", "some", "large") if any(name in panels for *_, panels in lines)]
    looks = line_looks(distinct(row["strategy"] for row in rows if row["kernel"] in DRAWN))
    keys = {key for *_, panels in lines if "large" in panels for of in panels["large"][2].values() for key in of}
    widths = [max(1, len(keys) / 9) if name == "large" else 1 for name in names]
    chart = Chart("types", "Speed by the number of types", len(names), len(lines),
                  (3.5 * sum(widths) / len(widths), 3.2), widths=widths)
    chart.figure.get_layout_engine().set(h_pad=0.09)
    for axes, (title, kernel, panels) in zip(chart.panels, lines):
        top = max(v for _, _, series, _ in panels.values() for points in series.values() for y in points.values()
                  for v in y if v is not None)
        for panel, name in zip(axes, names):
            if name not in panels:
                panel.set_axis_off()
                continue
            what, x_label, series, draw = panels[name]
            panel.axhline(1, color="black", linewidth=0.8, linestyle="--", zorder=1)
            draw(panel, series, looks)
            panel.set_ylim(0, 1.2 * max(top, 1))
            panel.set_title(f"{kernel}, {what}")
            panel.set_xlabel(x_label)
            said = [f"{strategy} " + ", ".join(f"{short(y[0])} ({say(x)})" for x, y in points.items())
                    for strategy, points in series.items()]
            chart.words.append(f"{title}, {kernel}, {what}, by {x_label}: {'; '.join(said)}.")
        axes[0].set_ylabel(title.replace(" (", "\n(") + "\nspeed / ctp with one type")
    add_crossovers(chart, groups)
    chart.line_legend(looks, markersize=5)
    chart.data = [{name: row[name] for name in NAMES + FIGURES} for row in rows]
    return chart


def add_crossovers(chart, groups):
    table = chart.tables["types_crossovers"] = []
    for group, (title, rows) in groups.items():
        for kernel, strategy, start, clear in crossovers(rows):
            table.append({**dict(zip(GROUP, group)), "kernel": kernel, "strategy": strategy,
                          "from_types": "" if start is None else start, "clear": str(clear).lower()})
            said = f"from {start} types on" if start else "at no number of types"
            said += ", clearly" if clear else ""
            chart.words.append(f"{title}, {kernel}: {strategy} is faster than {REFERENCE} {said}.")
    if not table:
        del chart.tables["types_crossovers"]
