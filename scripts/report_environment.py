"""Where a run took place and how to repeat it."""

import json
import re

from report_html import facts, join, more, plain_table, tag


def gibibytes(value):
    return f"{value / 2 ** 30:.1f} GiB" if isinstance(value, (int, float)) else None


def vector_instructions(flags):
    return ", ".join(flag for flag in (flags or "").split() if re.match(r"(avx|sse4|fma$|bmi|f16c|amx)", flag))


def gpu_facts(run):
    gpu = run.of("gpu")
    if not isinstance(gpu, dict):
        return []
    return [("GPU", gpu.get("name")), ("GPU memory", gibibytes(gpu.get("memory_bytes"))),
            ("CUDA driver, runtime", f"{gpu.get('driver')}, {gpu.get('runtime')}")]


def machine_facts(run):
    def machine(name):
        return run.of("machine", name)
    load, steal = machine("load_1min"), machine("steal_share_since_boot")
    return [("Processor", machine("cpu")), ("Cores, threads used", f"{machine('cores')}, {run.of('threads')}"),
            ("Instruction set of the kernels", run.of("isa")),
            ("Vector instructions it has", vector_instructions(machine("isa_flags"))), *gpu_facts(run),
            ("Memory", gibibytes(machine("memory_bytes"))),
            ("Most memory used", gibibytes(run.of("peak_memory_bytes"))),
            ("System", machine("system")), ("Frequency governor", machine("governor") or "not known"),
            ("Limit of a control group", machine("cgroup_cpu_max")),
            ("Load when it ended", None if load is None else f"{load:.2f}"),
            ("Time taken by the hypervisor since boot", None if steal is None else f"{100 * steal:.2g} %"),
            ("Denormal numbers", {True: "flushed to zero", False: "kept"}.get(machine("flush_denormals")))]


def build_facts(run):
    def build(name):
        return run.of("build", name)
    commit = build("git_commit")
    return [("Program", f"ctpbench {build('version') or ''}"),
            ("Commit", commit and commit + (", and changes that were not committed" if build("git_dirty") else "")),
            ("Compiler", build("compiler")), ("Build type", build("build_type")),
            ("Flags", (build("flags") or "").strip()), ("Embree", build("embree")), ("oneTBB", build("onetbb")),
            ("nlohmann/json", build("nlohmann_json")), ("Run", run.of("run_id")),
            ("Hash of the settings", run.of("config_hash"))]


def scene_table(run):
    names = ["name", "spheres", "source", "triangles", "dropped_triangles", "hash"]
    rows = [[str(scene.get(name, "")) for name in names] for scene in run.scenes]
    return plain_table("Scenes", ["scene", *(name.replace("_", " ") for name in names[1:])], rows) if rows else ""


def environment(run):
    if not run.has_meta:
        return tag("p", "Not known, since there is no meta.json.")
    verdicts = run.of("oracle") or {}
    oracle = plain_table("What the oracle said of each contender's hits", ["contender", "verdict"],
                         [[name, str(said)] for name, said in verdicts.items()]) if verdicts else ""
    return join([facts("Machine", machine_facts(run)), facts("Build", build_facts(run)), scene_table(run),
                 more(f"The oracle's verdicts on {len(verdicts)} contenders", oracle) if verdicts else ""])


def command(run):
    said = run.of("command")
    if not said:
        return tag("p", "Not known: meta.json does not say how the program was run.")
    commit = run.of("build", "git_commit")
    before = f"git checkout {commit}\n" if commit else ""
    content, settings = [tag("pre", tag("code", before + said))], run.of("config")
    if settings:
        content += [tag("p", "If the config file has changed since, the settings below are a config of their own."),
                    more("Settings in effect", tag("pre", tag("code", json.dumps(settings, indent=2))))]
    return join(content)
