"""What scripts/plot and scripts/report read: the CSV files of a run, checked line by line."""

import csv
import io
import math


class InputError(Exception):
    """A file of the run is not there or is not what it should be."""


class CannotDraw(InputError):
    """A file is whole, but no chart can be made of it: an older program wrote it, or rows are for one place."""


def read_lines(path, needed=()):
    """The lines of a CSV file as dictionaries, each with its "line"; a file that was cut off is an error."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            text = file.read()
        reader = csv.DictReader(io.StringIO(text, newline=""))
        missing = [name for name in needed if name not in (reader.fieldnames or [])]
        if missing:
            kind = CannotDraw if reader.fieldnames else InputError
            raise kind(f"{path}: no column {', '.join(missing)}; run the experiment again to write it")
        rows = [dict(row, line=reader.line_num) for row in reader]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    for row in rows:
        if None in row or None in row.values():
            fault = "more" if None in row else "fewer"
            raise InputError(f"{path}:{row['line']}: {fault} fields than columns; run the experiment again")
    if not text.endswith("\n"):
        raise InputError(f"{path}:{reader.line_num}: the file ends within this line; run the experiment again")
    return rows


def read_rows(path, needed):
    """The same of a file that must hold at least one line beside its header."""
    rows = read_lines(path, needed)
    if not rows:
        raise InputError(f"{path}: holds no rows; run the experiment again, or remove the file")
    return rows


def number(path, row, name, signed=False):
    """None stands for what was not measured."""
    text = row[name].strip()
    if text in ("", "n/a"):
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and (signed or value >= 0)):
        raise InputError(f"{path}:{row['line']}: {name} is \"{text}\"; expected a number"
                         + ("" if signed else " that is not negative"))
    return value


def measured(path, row, name, signed=False):
    """A number that must be there."""
    value = number(path, row, name, signed)
    if value is None:
        raise InputError(f"{path}:{row['line']}: {name} is empty; run the experiment again")
    return value


def truth(path, row, name):
    if row[name] not in ("true", "false"):
        raise InputError(f"{path}:{row['line']}: {name} is \"{row[name]}\"; expected true or false")
    return row[name] == "true"


def require_once(path, rows, names):
    """Each combination of these columns may be there once."""
    seen = set()
    for row in rows:
        key = tuple(row[name] for name in names)
        if key in seen:
            raise CannotDraw(f"{path}:{row['line']}: a second row for {', '.join(key)}; a chart needs one")
        seen.add(key)


def count(value):
    for unit, letter in ((1e6, "M"), (1e3, "K")):
        if value >= unit:
            return f"{value / unit:.3g}{letter}"
    return f"{value:.0f}"


def scene_title(path, row):
    """Of a row of figure4.csv or summary.csv."""
    source = "stand-in" if row["scene_source"] == "stand-in" else "mesh"
    return f"{row['scene']} ({source}, {count(number(path, row, 'triangles') or 0)} triangles)"


class Summary:
    """summary.csv, or nothing where the run left none."""

    def __init__(self, folder):
        self.path = folder / "summary.csv"
        columns = ["scene", "scene_source", "triangles", "backend", "strategy", "kernel", "median_mrays_s",
                   "lo_mrays_s", "hi_mrays_s"]
        self.rows = read_rows(self.path, columns) if self.path.exists() else []

    def title(self, scene):
        return next((scene_title(self.path, row) for row in self.rows if row["scene"] == scene), scene)

    def interval(self, value, **wanted):
        """Of the one row that a table's figure comes from; the table rounds it to four digits."""
        found = set()
        for row in self.rows:
            if all(row.get(name, "") == text for name, text in wanted.items()):
                median, lo, hi = (number(self.path, row, name + "_mrays_s") for name in ("median", "lo", "hi"))
                if None not in (median, lo, hi) and math.isclose(median, value, rel_tol=1e-3):
                    found.add((lo, hi))
        return found.pop() if len(found) == 1 else (None, None)


def read_table(path, first):
    """The rows of table1.csv or table3.csv, and its columns as (column, scene, backend, strategy)."""
    rows = read_rows(path, [first])
    columns = []
    for name in rows[0]:
        if name not in (first, "line"):
            parts = name.split("/", 2)
            if len(parts) != 3:
                raise InputError(f"{path}: column \"{name}\"; expected SCENE/BACKEND/STRATEGY")
            columns.append((name, *parts))
    if not columns:
        raise InputError(f"{path}: no column but \"{first}\"; run the experiment again, or remove the file")
    return rows, columns
