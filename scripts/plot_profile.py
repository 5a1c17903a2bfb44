"""Where the cycles of rays in flight go, by what they are spent on."""

from plot_chart import Chart, distinct, short, style_of
from plot_inputs import count, measured, number, read_rows, require_once

BATCH = ["scene", "spheres", "bounce", "isa"]
FIGURES = ["rays", "per_ray", "cycles_each", "cycles_per_ray", "rays_per_loop"]


def batch_of(path, row):
    bounce = measured(path, row, "bounce")
    rays = "camera rays" if bounce == 0 else f"bounce {bounce:.0f}"
    spheres = measured(path, row, "spheres")
    return (count(spheres) + " spheres, " if spheres else "") + rays


def profile(folder):
    """A panel for each scene and instruction set, a bar for each batch of rays."""
    path = folder / "profile.csv"
    rows = read_rows(path, BATCH + ["phase"] + FIGURES)
    require_once(path, rows, BATCH + ["phase"])
    panels, phases = {}, distinct(row["phase"] for row in rows)
    for row in rows:
        batches = panels.setdefault((row["scene"], row["isa"]), {})
        cycles = number(path, row, "cycles_per_ray") or 0
        batches.setdefault(batch_of(path, row), {})[row["phase"]] = cycles
    looks, bars = style_of(phases), max(len(batches) for batches in panels.values())
    chart = Chart("profile", "Cycles of rays in flight", len(panels), 1, (4.6, 0.8 + 0.33 * bars))
    for panel, ((scene, isa), batches) in zip(chart.panels[0], panels.items()):
        for batch, cycles in batches.items():
            total = 0
            for phase in phases:
                panel.barh(batch, cycles.get(phase, 0), left=total, **looks[phase])
                total += cycles.get(phase, 0)
            panel.text(total, batch, f" {short(total)}", va="center", fontsize=8)
            said = ", ".join(f"{phase} {short(value)}" for phase, value in cycles.items())
            chart.words.append(f"{scene}, {isa}, {batch}: {short(total)} cycles a ray, of which {said}.")
        panel.set_title(f"{scene}, {isa}")
        panel.set_xlabel("cycles a ray, on one thread")
        panel.margins(x=0.15)
        panel.set_xlim(left=0)
        panel.invert_yaxis()
    chart.legend(phases, looks)
    chart.data = [{name: row[name] for name in BATCH + ["phase"] + FIGURES} for row in rows]
    return chart
