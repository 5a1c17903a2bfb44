"""What all charts share: their look, and how they are saved."""

import csv
import io

import matplotlib
from matplotlib import pyplot

from plot_inputs import count, number, scene_title

# Okabe and Ito's colours, with grey and white for their black, told apart by eyes of every kind; the hatch (of
# bars) and the marker (of points) tell them apart in print.
COLOURS = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00", "#F0E442", "#999999", "#FFFFFF"]
HATCHES = ["", "///", "..", "xxx", "\\\\\\", "---", "oo", "|||", "+++"]  # circles are most of an SVG's bytes
# Of lines and points on white, where neither yellow nor white would do; the last is Tol's wine, dark beside all
# but black.
LINE_COLOURS = [*COLOURS[:6], "#000000", "#999999", "#882255"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">"]

STYLE = {"font.size": 10, "axes.titlesize": 10, "axes.spines.top": False, "axes.spines.right": False,
         "hatch.linewidth": 0.5, "svg.hashsalt": "ctpbench"}


def distinct(values):
    return list(dict.fromkeys(values))


def short(value):
    return f"{value:,.0f}" if value >= 99.95 else f"{value:#.3g}"


def second_of(values, i):
    """What goes with the i-th colour: moved on by one whenever the colours begin again, so that no pair returns."""
    return values[(i + i // len(COLOURS)) % len(values)]


def style_of(names):
    """The look of each name, by its place in the list."""
    return {name: {"facecolor": COLOURS[i % len(COLOURS)], "hatch": second_of(HATCHES, i),
                   "edgecolor": "black", "linewidth": 0.5} for i, name in enumerate(names)}


def line_looks(names):
    """The same for points and lines."""
    return {name: {"color": LINE_COLOURS[i % len(LINE_COLOURS)], "marker": second_of(MARKERS, i)}
            for i, name in enumerate(names)}


def workload_title(path, row):
    """Of a row that names a scene and its spheres."""
    spheres = number(path, row, "spheres")
    return scene_title(path, row) + (f", {count(spheres)} spheres" if spheres else "")


class Chart:
    """A grid of panels, the figures that they show, and the same in words. `heights` are shares of the rows,
    `widths` of the columns."""

    def __init__(self, name, title, across, down, panel_size, heights=None, widths=None):
        self.name, self.title, self.data, self.words = name, title, [], []
        self.tables = {}  # further files beside the chart: names, and rows as dictionaries
        self.figure, self.panels = pyplot.subplots(down, across, squeeze=False, layout="constrained",
                                                   gridspec_kw={"height_ratios": heights, "width_ratios": widths},
                                                   figsize=(across * panel_size[0], down * panel_size[1] + 0.6))
        self.figure.suptitle(title)

    def legend(self, names, looks):
        self._legend([matplotlib.patches.Patch(label=name, **looks[name]) for name in names])

    def line_legend(self, looks, **more):
        self._legend([matplotlib.lines.Line2D([], [], label=name, **look, **more) for name, look in looks.items()])

    def _legend(self, handles):
        self.figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), frameon=False,
                           ncol=min(len(handles), 5), handlelength=2.5, handleheight=1.2)

    def _described(self):
        return {"Title": self.title, "Description": self.title + ". " + " ".join(self.words)}

    def svg(self):
        """The text of the picture."""
        picture = io.StringIO()
        self.figure.savefig(picture, format="svg", bbox_inches="tight", metadata=dict(self._described(), Date=None))
        return picture.getvalue()

    def close(self):
        pyplot.close(self.figure)

    def save(self, folder):
        svg, png = (folder / (self.name + end) for end in (".svg", ".png"))
        svg.write_text(self.svg(), encoding="utf-8")
        self.figure.savefig(png, bbox_inches="tight", dpi=150, metadata=self._described())
        self.close()
        tables = {folder / f"{name}.csv": rows for name, rows in {f"{self.name}_data": self.data,
                                                                  **self.tables}.items()}
        for path, rows in tables.items():
            with open(path, "w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
                writer.writeheader()
                writer.writerows(rows)
        return [svg, png, *tables]


def whisker(value, lo, hi):
    """Lengths below and above; an interval of medians holds its median but for rounding."""
    return None if lo is None or hi is None else [[max(value - lo, 0)], [max(hi - value, 0)]]


WHISKER = {"ecolor": "black", "capsize": 2.5, "error_kw": {"elinewidth": 1}}


def with_interval(value, lo, hi):
    """In words."""
    return short(value) + ("" if lo is None or hi is None else f" [{short(lo)}, {short(hi)}]")
