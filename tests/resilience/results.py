"""What two folders of results must have in common whose runs measured the same: everything but times."""

import csv
import json
from collections import Counter

# What tells one run of the same cells from another.
VARY = {"run_id", "start_ms", "time_ms", "throughput_mrays_s"}


def rows_of(folder):
    """Rows without what varies, counted."""
    with open(folder / "rows.csv", newline="", encoding="utf-8") as file:
        return Counter(tuple((k, v) for k, v in row.items() if k not in VARY) for row in csv.DictReader(file))


def run_ids(folder):
    with open(folder / "rows.csv", newline="", encoding="utf-8") as file:
        return {row["run_id"] for row in csv.DictReader(file)}


def keys_of(table):
    """The fields of each line up to the one that names the strategy, or the tree: whom it is about."""
    with open(table, newline="", encoding="utf-8") as file:
        lines = list(csv.reader(file))
    last = max(lines[0].index(name) for name in ("strategy", "kernel", "tree") if name in lines[0])
    return [line[: last + 1] for line in lines]


def finished(folder):
    with open(folder / "finished.jsonl", encoding="utf-8") as file:
        return [json.loads(line)["hash"] for line in file]


def state(folder):
    return json.loads((folder / "meta.json").read_text(encoding="utf-8"))["state"]


def compare(folder, unbroken):
    """What is wrong with a folder that should have what the unbroken run's has, as lines of text."""
    wrong = []
    ours, theirs = rows_of(folder), rows_of(unbroken)
    if ours != theirs:
        wrong.append(f"rows: {sum((theirs - ours).values())} missing, {sum((ours - theirs).values())} too many")
    if finished(folder) != finished(unbroken):
        wrong.append("other workloads are finished, or in another order")
    for table in ("summary.csv", "trees.csv"):
        if keys_of(folder / table) != keys_of(unbroken / table):
            wrong.append(f"{table} has other lines")
    if state(folder) != "complete":
        wrong.append("meta.json does not say that the run is complete")
    return wrong
