"""The charts of the paper's tables and of its Figure 4."""

from plot_chart import WHISKER, Chart, distinct, short, style_of, whisker, workload_title
from plot_inputs import CannotDraw, InputError, Summary, count, number, read_rows, read_table

KERNELS = ["intersect", "sort", "shade", "compact"]  # in the order of the pipeline


def figure4(folder):
    """Accumulated seconds; a row of panels for each backend, whose times are too far apart for one axis."""
    path = folder / "figure4.csv"
    columns = ["scene", "scene_source", "triangles", "spheres", "backend", "strategy", "kernel", "seconds",
               "lo_seconds", "hi_seconds"]
    rows = read_rows(path, columns)
    seconds, titles = {}, {}
    for row in rows:
        if row["kernel"] not in KERNELS:
            raise InputError(f"{path}:{row['line']}: unknown kernel \"{row['kernel']}\"; known are "
                             f"{', '.join(KERNELS)}")
        workload = (row["scene"], number(path, row, "spheres"))
        titles[workload] = workload_title(path, row)
        key = (workload, row["backend"], row["strategy"], row["kernel"])
        if key in seconds:
            raise CannotDraw(f"{path}:{row['line']}: a second row for {row['scene']}, {row['backend']}, "
                             f"{row['strategy']}, {row['kernel']}; a chart needs one")
        seconds[key] = number(path, row, "seconds")
    backends, strategies = (distinct(row[name] for row in rows) for name in ("backend", "strategy"))
    looks = style_of(KERNELS)
    chart = Chart("figure4", "Figure 4: accumulated time of the kernels", len(titles), len(backends),
                  (4.6, 0.6 + 0.42 * len(strategies)))
    chart.data = [{name: row[name] for name in columns} for row in rows]
    for i, backend in enumerate(backends):
        for panel, (workload, title) in zip(chart.panels[i], titles.items()):
            shown = [s for s in strategies if any((workload, backend, s, k) in seconds for k in KERNELS)]
            said = []
            for strategy in shown:
                total = 0
                for kernel in KERNELS:
                    width = seconds.get((workload, backend, strategy, kernel)) or 0
                    panel.barh(strategy, width, left=total, **looks[kernel])
                    total += width
                shade = seconds.get((workload, backend, strategy, "shade")) or 0
                panel.text(total, strategy, f" {short(total)} s\n shade {short(shade)}", va="center", fontsize=8,
                           linespacing=1.05)
                said.append(f"{strategy} {short(total)} s, of which shade {short(shade)}")
            panel.set_title(f"{title}\n{backend}")
            panel.set_xlabel("seconds")
            panel.use_sticky_edges = False  # a bar of width 0 at the end would take the margin away
            panel.margins(x=0.28)
            panel.set_xlim(left=0)
            panel.locator_params(axis="x", nbins=4)  # numbers of four digits must not touch
            panel.invert_yaxis()
            chart.words.append(f"{title}, {backend}: {'; '.join(said)}." if said else "")
    chart.legend(KERNELS, looks)
    return chart


def table1(folder):
    """A panel for each kernel and each scene and backend: their speeds are far apart."""
    path = folder / "table1.csv"
    rows, columns = read_table(path, "kernel")
    summary = Summary(folder)
    groups = distinct((scene, backend) for _, scene, backend, _ in columns)
    strategies = distinct(column[3] for column in columns)
    looks = style_of(strategies)
    chart = Chart("table1", "Table 1: speed of the kernels", len(rows), len(groups),
                  (2.7, 0.8 + 0.27 * len(strategies)))
    for panels, group in zip(chart.panels, groups):
        for panel, row in zip(panels, rows):
            said = []
            shown = [(name, strategy) for name, *of, strategy in columns if tuple(of) == group]
            for name, strategy in shown:
                value, kernel = number(path, row, name), row["kernel"]
                lo, hi = summary.interval(value or 0, scene=group[0], backend=group[1], shade=strategy,
                                          kernel=kernel)
                panel.barh(strategy, value or 0, xerr=whisker(value, lo, hi), **WHISKER, **looks[strategy])
                text = "n/a" if value is None else short(value)
                panel.text(max(value or 0, hi or 0), strategy, f"  {text}", va="center", fontsize=8)
                said.append(f"{strategy} {text}")
                chart.data.append({"scene": group[0], "backend": group[1], "strategy": strategy, "kernel": kernel,
                                   "mrays_s": "n/a" if value is None else value, "lo_mrays_s": lo,
                                   "hi_mrays_s": hi})
            panel.set_title(row["kernel"])
            panel.margins(x=0.3)
            panel.set_xlim(left=0)
            panel.invert_yaxis()
            panel.tick_params(labelleft=panel is panels[0])
            panel.locator_params(axis="x", nbins=4)
            if not any(number(path, row, name) for name, _ in shown):
                panel.set_xticks([])
            panel.set_xlabel("Mrays/s")
            chart.words.append(f"{group[0]}, {group[1]}, {row['kernel']}, Mrays/s: {'; '.join(said)}.")
        panels[0].set_ylabel(f"{summary.title(group[0]).replace(' (', chr(10) + '(')}\n{group[1]}")
    return chart


def table3(folder):
    """Groups of bars for the sphere counts; a row of panels for each backend, a column for each scene."""
    path = folder / "table3.csv"
    rows, columns = read_table(path, "spheres")
    summary = Summary(folder)
    scenes, backends, strategies = (distinct(column[i] for column in columns) for i in (1, 2, 3))
    looks = style_of(strategies)
    chart = Chart("table3", "Table 3: speed of intersect", len(scenes), len(backends), (5.4, 3.4))
    for panels, backend in zip(chart.panels, backends):
        for panel, scene in zip(panels, scenes):
            shown = [(name, strategy) for name, *of, strategy in columns if of == [scene, backend]]
            width = 0.85 / max(len(shown), 1)
            for i, row in enumerate(rows):
                said = []
                for j, (name, strategy) in enumerate(shown):
                    value = number(path, row, name)
                    text = "n/a" if value is None else short(value)
                    lo, hi = summary.interval(value or 0, scene=scene, backend=backend, spheres=row["spheres"],
                                              strategy=strategy.split("/")[0], kernel="intersect")
                    panel.bar(i + (j + 0.5 - len(shown) / 2) * width, value or 0, width,
                              yerr=whisker(value, lo, hi), **WHISKER, **looks[strategy])
                    said.append(f"{strategy} {text}")
                    chart.data.append({"scene": scene, "backend": backend, "spheres": row["spheres"],
                                       "strategy": strategy, "mrays_s": "n/a" if value is None else value,
                                       "lo_mrays_s": lo, "hi_mrays_s": hi})
                chart.words.append(f"{scene}, {backend}, {row['spheres']} spheres, Mrays/s: {'; '.join(said)}.")
            panel.set_xticks(range(len(rows)), [count(number(path, row, "spheres") or 0) for row in rows])
            panel.set_title(f"{summary.title(scene)}\n{backend}")
            panel.set_xlabel("spheres")
            panel.set_ylabel("Mrays/s")
    chart.legend(strategies, looks)
    return chart
