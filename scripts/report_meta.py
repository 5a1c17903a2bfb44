"""meta.json of a run, checked: what is there has its type, and anything may be missing, as programs of other days wrote
less or more."""

import json

from plot_inputs import InputError

SCHEMA_VERSION = 1
NUMBER = (int, float)
NAMES = {str: "a string", list: "a list", dict: "an object", bool: "true or false", NUMBER: "a number"}

# Of what the page looks into; all else is shown as it is.
TYPES = {
    ("run_id",): str, ("command",): str, ("notices",): list, ("oracle",): dict, ("scenes",): list,
    ("machine", "isa_flags"): str, ("machine", "load_1min"): NUMBER, ("machine", "steal_share_since_boot"): NUMBER,
    ("machine", "flush_denormals"): bool, ("build", "flags"): str, ("build", "git_commit"): str,
}
SCENE_TYPES = {"name": str, "source": str, "spheres": NUMBER}


def look_up(value, names):
    """None where there is no such place."""
    for name in names:
        value = value.get(name) if isinstance(value, dict) else None
    return value


def faults(meta):
    for names, expected in TYPES.items():
        value = look_up(meta, names)
        if value is not None and not isinstance(value, expected):
            yield f"/{'/'.join(names)} is not {NAMES[expected]}"
    scenes = look_up(meta, ["scenes"])
    for i, scene in enumerate(scenes if isinstance(scenes, list) else []):
        if not isinstance(scene, dict):
            yield f"/scenes/{i} is not {NAMES[dict]}"
            continue
        for name, expected in SCENE_TYPES.items():
            if scene.get(name) is not None and not isinstance(scene[name], expected):
                yield f"/scenes/{i}/{name} is not {NAMES[expected]}"


def read_meta(path):
    try:
        meta = json.loads(path.read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        raise InputError(f"{path}:{error.lineno}:{error.colno}: is not JSON: {error.msg}; run the experiment again, or "
                         "remove the file and do without machine, build and command") from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    found = list(faults(meta)) if isinstance(meta, dict) else ["is not a JSON object"]
    if found:
        raise InputError(f"{path}: {'; '.join(found)}; run the experiment again, or remove the file")
    return meta
