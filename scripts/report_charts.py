"""The charts of a run as SVG inside the page.

A picture that lies in a page shares its names with all others: ids are kept only where something refers to them and get
a prefix, and matplotlib's style sheet, which would hold for the whole page, is left to the page's own.
"""

import base64
import csv
import io
import re

import matplotlib

from plot_charts import CHARTS
from plot_inputs import CannotDraw
from report_html import Html, join, more, tag

FONTS = "'DejaVu Sans', Verdana, Arial, sans-serif"
LEAST_SCALE = 0.7  # smaller, letters of 8 points could not be read; then the chart scrolls

def without_unused_ids(svg, prefix):
    used = set(re.findall(r'(?:url\(#|href="#)([^")]+)', svg))

    def renamed(found):
        return f' id="{prefix}-{found[1]}"' if found[1] in used else ""
    svg = re.sub(r' id="([^"]*)"', renamed, svg)
    return re.sub(r'(url\(#|href="#)', rf"\g<1>{prefix}-", svg)


def shortened(svg):
    """Coordinates to a hundredth of a point: hatches alone are a megabyte otherwise."""
    def short_tag(found):
        return re.sub(r"(\d\.\d\d)\d+", r"\1", re.sub(r"\s*\n\s*", " ", found[0]))
    return re.sub(r">\s*\n\s*<", ">\n<", re.sub(r"<[^>]*>", short_tag, svg))


def inline_svg(chart, prefix):
    """With text as text, in the reader's fonts, which is smaller and can be searched."""
    with matplotlib.rc_context({"svg.fonttype": "none"}):
        svg = chart.svg()
    root = re.search(r"<svg\b[^>]*>", svg)
    size = dict(re.findall(r'\b(width|height|viewBox)="([^"]*)"', root[0]))
    width, height = (round(float(size[name].removesuffix("pt")) * 4 / 3) for name in ("width", "height"))
    body = svg[root.end():svg.rindex("</svg>")]
    body = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>|<!--.*?-->|<title>.*?</title>", "", body,
                  flags=re.DOTALL)
    body = body.replace("xlink:href", "href")
    body = re.sub(r"font: ([^;\"]*?)(?:'[^;\"]*|sans-serif)(?=[;\"])", rf"font: \1{FONTS}", body)
    body = without_unused_ids(shortened(body), prefix)
    return tag("svg", tag("title", chart.title, id=f"{prefix}-title"), Html(body), xmlns="http://www.w3.org/2000/svg",
               role="img", aria_labelledby=f"{prefix}-title", aria_describedby=f"{prefix}-read", width=width,
               height=height, viewBox=size["viewBox"], style=f"min-width: {round(LEAST_SCALE * width)}px")


def csv_link(name, rows):
    """The figures themselves, to be saved from the page."""
    text = io.StringIO()
    writer = csv.DictWriter(text, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    data = base64.b64encode(text.getvalue().encode()).decode()
    return tag("a", f"{name}.csv", download=f"{name}.csv", href=f"data:text/csv;charset=utf-8;base64,{data}")


def figure(chart, reading, prefix):
    files = {f"{chart.name}_data": chart.data, **chart.tables}
    links = join((csv_link(name, rows) for name, rows in files.items()), ", ")
    words = tag("ul", *(tag("li", said) for said in chart.words if said))
    card = tag("div", inline_svg(chart, prefix), class_="card scroll", role="group", tabindex="0",
               aria_label=chart.title)
    return join([tag("figure", card, tag("figcaption", reading, id=f"{prefix}-read")),
                 more("The same in words", words, tag("p", "All figures: ", links))])


def draw_charts(run, warnings):
    """(chart, how to read it) of the run; what none can be made of becomes a warning."""
    charts = []
    for name, (draw, reading) in CHARTS.items():
        if name not in run.lines:
            continue
        try:
            charts.append((draw(run.folder), reading))
        except CannotDraw as error:
            warnings.append(("Note", f"No chart of {name}: {error}"))
    return charts
