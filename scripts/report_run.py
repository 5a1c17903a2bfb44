"""One folder that a run left, read and checked before anything of the page is made."""

import re

from plot_charts import CHARTS
from plot_inputs import InputError, read_lines
from report_meta import look_up, read_meta

# Each of these shows something by itself.
SHOWN = [*CHARTS, "table2.csv", "summary.csv"]
KNOWN = ["rows.csv", *SHOWN, "trees.csv", "convergence_fits.csv"]


class Run:
    """`lines` holds each CSV file that is there; `meta` is empty where there is no meta.json."""

    def __init__(self, folder):
        if not folder.is_dir():
            raise InputError(f"{folder}: no such folder; name the folder that a run left")
        self.folder, self.name = folder, folder.resolve().name
        there = [name for name in KNOWN if (folder / name).exists()]
        if not any(name in SHOWN or name == "rows.csv" for name in there):
            raise InputError(f"{folder}: holds neither rows.csv nor {', '.join(SHOWN[:-1])} or {SHOWN[-1]}; name the "
                             "folder that a run left")
        self.lines = {name: read_lines(folder / name) for name in there}
        self.has_meta = (folder / "meta.json").exists()
        self.meta = read_meta(folder / "meta.json") if self.has_meta else {}

    def of(self, *names):
        """What meta.json holds there, or None: older programs wrote less."""
        return look_up(self.meta, names)

    @property
    def title(self):
        said = self.of("config", "description")
        return f"{self.name}: {said}" if said else self.name

    @property
    def when(self):
        found = re.search(r"(\d{4})(\d\d)(\d\d)T(\d\d)(\d\d)\d\dZ$", self.of("run_id") or "")
        return "{}-{}-{} {}:{} UTC".format(*found.groups()) if found else None

    @property
    def scenes(self):
        """Those of meta.json, each once."""
        found = {}
        for scene in self.of("scenes") or []:
            if scene.get("name") is not None:
                found.setdefault((scene["name"], scene.get("spheres")), scene)
        return list(found.values())
