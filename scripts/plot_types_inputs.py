"""What types.csv holds: ratios by the number of types, and from how many on a strategy overtakes ctp."""

from plot_inputs import InputError, measured, number, read_rows, require_once, scene_title

DRAWN = ["intersect", "sort+shade+compact"]
KERNELS = [*DRAWN, "shade", "frame"]
LARGE = ["none", "unused", "used"]
GROUP = ["scene", "scene_source", "triangles", "backend"]
NAMES = GROUP + ["kernel", "strategy", "listed", "used", "large"]
FIGURES = ["median_mrays_s", "lo_mrays_s", "hi_mrays_s", "ratio", "ratio_lo", "ratio_hi"]
REFERENCE = "ctp"


class Row:
    """One line of the file; y is (ratio, lo, hi), all relative to ctp with one type."""

    def __init__(self, path, row):
        self.kernel, self.strategy, self.large = row["kernel"], row["strategy"], row["large"]
        for name, known in (("kernel", KERNELS), ("large", LARGE)):
            if row[name] not in known:
                raise InputError(f"{path}:{row['line']}: unknown {name} \"{row[name]}\"; known are "
                                 f"{', '.join(known)}")
        self.listed, self.used = (count_of_types(path, row, name) for name in ("listed", "used"))
        if self.used > self.listed:
            raise InputError(f"{path}:{row['line']}: used is {self.used}, but only {self.listed} types are listed")
        for name in FIGURES:
            number(path, row, name)
        self.y = tuple(number(path, row, name) for name in ("ratio", "ratio_lo", "ratio_hi"))


def count_of_types(path, row, name):
    value = measured(path, row, name)
    if value < 1 or value != int(value):
        raise InputError(f"{path}:{row['line']}: {name} is \"{row[name]}\"; expected a number of types, 1 or more")
    return int(value)


def by_strategy(rows, x_of):
    series = {}
    for row in sorted(rows, key=x_of):
        series.setdefault(row.strategy, {})[x_of(row)] = row.y
    return series


def all_used(rows, kernel):
    """By strategy: ratios by the number of types, all of which the scene has."""
    return by_strategy([r for r in rows if r.kernel == kernel and r.large == "none" and r.listed == r.used],
                       lambda r: r.listed)


def some_used(rows, kernel):
    """Of the longest list of which a scene has only some: its length, and by strategy ratios by how many."""
    plain = [r for r in rows if r.kernel == kernel and r.large == "none"]
    longest = max((r.listed for r in plain if r.used < r.listed), default=None)
    return longest, by_strategy([r for r in plain if r.listed == longest], lambda r: r.used)


def one_large(rows, kernel):
    """By strategy: ratios by (listed, used, place in LARGE), where a large type was measured."""
    of = [r for r in rows if r.kernel == kernel]
    counts = {(r.listed, r.used) for r in of if r.large != "none"}
    return by_strategy([r for r in of if (r.listed, r.used) in counts],
                       lambda r: (r.listed, r.used, LARGE.index(r.large)))


def crossover(series, reference):
    """The smallest number of types from which on a strategy is faster, and whether the intervals part throughout."""
    start, clear = None, True
    for n in sorted(set(series) & set(reference), reverse=True):
        (ratio, lo, _), (other, _, other_hi) = series[n], reference[n]
        if ratio <= other:
            break
        start, clear = n, clear and None not in (lo, other_hi) and lo > other_hi
    return start, clear and start is not None


def crossovers(rows):
    """(kernel, strategy, from, clear) of all that were measured beside ctp."""
    for kernel in KERNELS:
        series = all_used(rows, kernel)
        for strategy in series:
            if strategy != REFERENCE and REFERENCE in series:
                yield kernel, strategy, *crossover(series[strategy], series[REFERENCE])


def read_groups(path):
    """The rows as they are, and by GROUP its title and those that have a ratio."""
    rows, groups = read_rows(path, NAMES + FIGURES), {}
    require_once(path, rows, ["scene", "backend", "kernel", "strategy", "listed", "used", "large"])
    for row in rows:
        title = f"{scene_title(path, row)}, {row['backend']}"
        group = groups.setdefault(tuple(row[name] for name in GROUP), (title, []))[1]
        drawn = Row(path, row)
        if drawn.y[0] is not None:
            group.append(drawn)
    return rows, groups
