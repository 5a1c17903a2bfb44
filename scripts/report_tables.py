"""The paper's tables of a run: what its Markdown says, in columns of the paper's, ours, and ratios."""

import re

from plot_chart import with_interval
from plot_inputs import InputError, number
from report_html import Html, caption_of, heading, join, plain_table, scrolling, tag, text

PAPER = ": paper"


def inline(line):
    """Of Markdown, the program's tables use backticks alone."""
    return Html(re.sub(r"`([^`]*)`", r"<code>\1</code>", text(line)))


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def read_blocks(path):
    """(heading, paragraphs and tables as lists of lines) of each section; the first heading is the file's own."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    sections, open_block = [], None
    for number, line in enumerate(lines, 1):
        if line.startswith("#"):
            sections.append((line.lstrip("# "), []))
            open_block = None
        elif not line.strip():
            open_block = None
        elif not sections:
            raise InputError(f"{path}:{number}: text before the first heading; run the experiment again")
        else:
            if open_block is None:
                open_block = []
                sections[-1][1].append(open_block)
            open_block.append((number, line))
    return sections


def ordered(header):
    """(group, columns as (index, name)) of a table that has figures of the paper: theirs, ours, ratios."""
    groups = {"Paper": [], "Measured": [], "Ratios": []}
    for i, name in enumerate(header[1:], 1):
        is_paper, bare = name.endswith(PAPER), name.removesuffix(PAPER)
        if "/" in bare:
            groups["Ratios"].append((i, bare + (", paper" if is_paper else ", ours" if bare + PAPER in header else "")))
        else:
            groups["Paper" if is_paper else "Measured"].append((i, bare))
    return groups


def grouped_table(caption, header, rows):
    known = [i for i, name in enumerate(header) if not name.endswith(PAPER) or any(row[i] != "n/a" for row in rows)]
    if not any(header[i].endswith(PAPER) for i in known):
        caption += "; the paper has no figures for it"
    groups = {name: [(i, said) for i, said in columns if i in known] for name, columns in ordered(header).items()}
    groups = {name: columns for name, columns in groups.items() if columns}
    first_of = {columns[0][0] for columns in groups.values()}

    def first(i):
        return "first" if i in first_of else None
    top = [tag("th", header[0], scope="col", rowspan="2")]
    top += [tag("th", name, scope="colgroup", colspan=len(columns), class_="first") for name, columns in groups.items()]
    below = [heading(said, scope="col", class_=first(i)) for columns in groups.values() for i, said in columns]
    body = [tag("tr", tag("th", row[0], scope="row"),
                *(tag("td", row[i], class_=first(i)) for columns in groups.values() for i, _ in columns))
            for row in rows]
    return scrolling(tag("table", caption_of(inline(caption)), tag("thead", tag("tr", *top), tag("tr", *below)),
                         tag("tbody", *body)), caption)


def markdown_table(path, heading, block):
    header, rows = cells_of(block[0][1]), [cells_of(line) for _, line in block[2:]]
    for (number, _), row in zip(block[2:], rows):
        if len(row) != len(header):
            raise InputError(f"{path}:{number}: {len(row)} cells under {len(header)} headings; run the experiment again")
    caption = f"{heading}, by {header[0]}"
    if any(name.endswith(PAPER) for name in header):
        return grouped_table(caption, header, rows)
    return plain_table(caption, header, rows)


def from_markdown(path):
    content = []
    for heading, blocks in read_blocks(path):
        for block in blocks:
            if block[0][1].startswith("|"):
                content.append(markdown_table(path, heading, block))
            else:
                content.append(tag("p", inline(" ".join(line for _, line in block))))
    return join(content)


def from_csv(caption, rows):
    names = [name for name in rows[0] if name != "line"]
    return plain_table(caption, names, [[row[name] for name in names] for row in rows])


def paper_tables(run):
    """(short name, title, content) of each that the run has."""
    for number, what in ((1, "speed of a bounce's kernels"), (2, "nodes of the trees"), (3, "speed of intersect")):
        name, title = f"table{number}", f"Table {number} of the paper: {what}"
        markdown = run.folder / f"{name}.md"
        if markdown.exists():
            yield name, title, from_markdown(markdown)
        elif run.lines.get(f"{name}.csv"):
            yield name, title, from_csv(f"{name}.csv as the run wrote it", run.lines[f"{name}.csv"])


SUMMARY = {"median_mrays_s": ("Mrays/s", "lo_mrays_s", "hi_mrays_s"),
           "ratio_to_reference": ("ratio to the reference", "ratio_lo", "ratio_hi"),
           "ratio_to_yardstick": ("ratio to the yardstick", "yardstick_lo", "yardstick_hi")}


def summary_table(run):
    """For runs that made no table and no chart."""
    path, names = run.folder / "summary.csv", ["scene", "spheres", "backend", "strategy", "kernel", "rounds", "valid"]

    def figure(row, *columns):
        values = [number(path, row, column) if column in row else None for column in columns]
        return "n/a" if values[0] is None else with_interval(*values)
    rows = [[row.get(name, "") for name in names]
            + [figure(row, name, lo, hi) for name, (_, lo, hi) in SUMMARY.items()] for row in run.lines["summary.csv"]]
    return plain_table("Median speed of each contender and paired ratios, with 95 % intervals",
                       names + [said for said, *_ in SUMMARY.values()], rows)
