#!/usr/bin/python3
"""Kills runs at random moments, resumes them, and compares what they leave with an unbroken run.

    kill_moments.py PROGRAM [--moments 20] [--seed 1]

The moments come from the seed and are spread over the time that an unbroken run takes; every second run is
killed again while it is being resumed. After that its rows must be those of the unbroken run, each once, in
all but times; its tables must have the same lines, and no workload may be finished twice.
"""

import argparse
import json
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from results import compare, rows_of, run_ids

CONFIG = {
    "schema_version": 1,
    "experiment": "kills",
    "matrix": {"scene": "smoke", "spheres": [0, 20, 60, 200], "builder": ["paper", "quality"],
               "strategy": ["ctp", "oop", "restart"]},
    "include": [{"scene": "smoke", "spheres": [0, 20, 60, 200], "builder": ["paper", "quality"],
                 "shade": ["ctp", "sort"]}],
    "width": 48, "height": 32, "bounces": 3, "rounds": 3, "batch_rays": 0, "oracle_rays": 200,
    "tables": ["table1", "table3", "figure4"],
}

def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--moments", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    moments = random.Random(options.seed)

    with tempfile.TemporaryDirectory(prefix="ctpbench_kills_") as name:
        scratch = Path(name)
        (scratch / "c.json").write_text(json.dumps(CONFIG))

        def command(folder):
            return [options.program, "--config", scratch / "c.json", "--quiet", "--out", folder, "--resume"]

        def run(folder):
            done = subprocess.run(command(folder), capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit(f"{folder.name}: exit code {done.returncode}: {done.stderr}")

        def killed_after(folder, seconds):
            """Whether the process was still there to be killed."""
            process = subprocess.Popen(command(folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                process.wait(seconds)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
            return process.wait() == -signal.SIGKILL

        unbroken = scratch / "unbroken"
        run(unbroken)  # warms up caches of files
        again = scratch / "again"
        began = time.monotonic()
        run(again)
        whole = time.monotonic() - began
        if wrong := compare(again, unbroken):
            sys.exit("two unbroken runs differ: " + "; ".join(wrong))

        failures = kills = 0
        for i in range(options.moments):
            folder = scratch / f"run{i}"
            at = [moments.uniform(0.0, whole) for _ in range(1 + i % 2)]
            states = []
            for moment in at:
                kills += killed_after(folder, moment)
                log, rows = folder / "finished.jsonl", folder / "rows.csv"
                whole_lines = log.read_bytes().count(b"\n") if log.exists() else 0
                size = rows.stat().st_size if rows.exists() else 0
                states.append(f"{moment:.3f} s: {whole_lines} finished, {size} bytes of rows")
            run(folder)
            wrong = compare(folder, unbroken)
            if len(run_ids(folder)) != 1:
                wrong.append("more than one id of a run")
            failures += bool(wrong)
            print(f"{i + 1}: killed at {', '.join(states)}: {'; '.join(wrong) or 'equal'}", flush=True)
        rows = sum(rows_of(unbroken).values())
        print(f"{options.moments} runs of {whole:.2f} s and {rows} rows, {kills} kills, {failures} that differ")
        if kills == 0:
            sys.exit("nothing was killed")
        sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
