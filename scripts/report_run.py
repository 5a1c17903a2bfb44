"""One folder that a run left, read and checked before anything of the page is made."""

import json
import re

from plot_charts import CHARTS
from plot_inputs import InputError, read_lines

# Each of these shows something by itself.
SHOWN = [*CHARTS, "table2.csv", "summary.csv"]
KNOWN = ["rows.csv", *SHOWN, "trees.csv", "convergence_fits.csv"]
SCHEMA_VERSION = 1


def read_meta(path):
    try:
        meta = json.loads(path.read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        raise InputError(f"{path}:{error.lineno}:{error.colno}: is not JSON: {error.msg}; run the experiment again, or "
                         "remove the file and do without machine, build and command") from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    if not isinstance(meta, dict):
        raise InputError(f"{path}:1: is not a JSON object; run the experiment again, or remove the file")
    return meta


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
        value = self.meta
        for name in names:
            value = value.get(name) if isinstance(value, dict) else None
        return value

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
            if isinstance(scene, dict) and "name" in scene:
                found.setdefault((scene["name"], scene.get("spheres", 0)), scene)
        return list(found.values())
