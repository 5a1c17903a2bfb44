#!/usr/bin/python3
"""Runs a job array on a Slurm of its own, kills one element, submits it again, merges, and compares.

    slurm_array.py PROGRAM SWEEP.sbatch

Starts slurmctld and slurmd for this machine alone, without authentication, in a folder that goes with the
test. The merged results must have the rows of one process that measured everything. Exit code 77: Slurm is
not installed.
"""

import ctypes
import json
import os
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from results import compare, finished, state

SKIPPED = 77
SHARDS = 3
KILLED = 2
CONFIG = {
    "schema_version": 1,
    "experiment": "sweep",
    "matrix": {"scene": "smoke", "spheres": [0, 20, 60, 200], "builder": ["paper", "quality"],
               "strategy": ["ctp", "restart"]},
    "include": [{"scene": "smoke", "spheres": [0, 20, 60, 200], "builder": ["paper", "quality"], "shade": "ctp"}],
    # Rounds enough that the kill meets an element that has finished some of its workloads.
    "width": 64, "height": 32, "bounces": 3, "rounds": 40, "threads": 1, "batch_rays": 0, "oracle_rays": 200,
    "tables": ["table1", "table3"],
}

PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
libc = ctypes.CDLL(None)


def free_ports(n):
    sockets = [socket.socket() for _ in range(n)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def wait_until(what, seconds, condition):
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise TimeoutError(f"waited {seconds} s for {what}")
        time.sleep(0.02)


class Slurm:
    """Controller and one node, until the end of the `with` block, whatever happens in it."""

    def __init__(self, folder):
        self.folder = folder
        controller, node = free_ports(2)
        user, host = pwd.getpwuid(os.getuid()).pw_name, socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "cgroup.conf").write_text("IgnoreSystemd=yes\n")  # of which there is none in a container
        (folder / "slurm.conf").write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
KillWait=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=10 State=UP
""")
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        self.daemons = []

    def start(self, *command):
        log = open(self.folder / f"{command[0]}.log", "wb")
        self.daemons.append(subprocess.Popen(
            command, env=self.environment, stdout=log, stderr=log, stdin=subprocess.DEVNULL,
            preexec_fn=lambda: libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)))
        log.close()

    def call(self, *command, **more):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=True,
                              timeout=30, **more).stdout.strip()

    def __enter__(self):
        libc.prctl(PR_SET_CHILD_SUBREAPER, 1)  # what daemons leave behind becomes ours to end
        try:
            self.start("slurmctld", "-D", "-i")
            self.start("slurmd", "-D")
            wait_until("the node to be idle", 20, self.is_idle)
        except BaseException:
            self.__exit__()
            raise
        return self

    def is_idle(self):
        for daemon in self.daemons:
            if daemon.poll() is not None:
                raise RuntimeError(f"{daemon.args[0]} ended with {daemon.returncode}")
        try:
            return self.call("sinfo", "-h", "-o", "%T") == "idle"
        except subprocess.SubprocessError:
            return False

    def is_empty(self):
        return self.call("squeue", "-h") == ""

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.kill()
            daemon.wait()
        # Steps and what they run are in process groups of their own, and by now children of this process.
        while True:
            for child in Path(f"/proc/self/task/{os.getpid()}/children").read_text().split():
                os.kill(int(child), signal.SIGKILL)
            try:
                os.wait()
            except ChildProcessError:
                return


def test(program, sweep, scratch):
    (scratch / "c.json").write_text(json.dumps(CONFIG))
    experiment = ["--config", str(scratch / "c.json"), "--quiet"]
    out = scratch / "out"
    with Slurm(scratch / "slurm") as slurm:
        slurm.environment["CTPBENCH"] = str(program)

        def submit(array):
            return slurm.call("sbatch", "--parsable", f"--array={array}", f"--output={scratch}/job-%a.log",
                              str(sweep), str(SHARDS), str(out), *experiment)

        def lines(shard):
            log = out / f"shard-{shard}" / "finished.jsonl"
            return log.read_bytes().count(b"\n") if log.exists() else 0

        def merge(into):
            folders = [out / f"shard-{i}" for i in range(1, SHARDS + 1)]
            return subprocess.run([program, "merge", *folders, "--out", into], capture_output=True, text=True,
                                  check=False)

        job = submit(f"1-{SHARDS}")
        wait_until("the element that is to be killed", 60, lambda: lines(KILLED) > 0)
        number = slurm.call("squeue", "-h", "-o", "%A", "-j", f"{job}_{KILLED}")
        for line in slurm.call("scontrol", "listpids", number).splitlines()[1:]:
            os.kill(int(line.split()[0]), signal.SIGKILL)  # scancel would let it end by itself
        wait_until("the array to end", 60, slurm.is_empty)
        states = [state(out / f"shard-{i}") for i in range(1, SHARDS + 1)]
        before = lines(KILLED)
        print(f"killed element {KILLED} with {before} workloads finished: {', '.join(states)}")
        assert states == ["running" if i == KILLED else "complete" for i in range(1, SHARDS + 1)], states
        early = merge(scratch / "early")
        assert early.returncode == 2 and "finished in none of the folders" in early.stderr, early
        assert not (scratch / "early").exists()

        submit(KILLED)
        wait_until("the resumed element", 60, slurm.is_empty)
        assert state(out / f"shard-{KILLED}") == "complete", (scratch / f"job-{KILLED}.log").read_text()
        resumed = json.loads((out / f"shard-{KILLED}" / "meta.json").read_text())["resumed"]
        assert [r["workloads_kept"] for r in resumed] == [before], resumed
        merged = merge(scratch / "merged")
        assert merged.returncode == 0, merged

    subprocess.run([program, *experiment, "--out", scratch / "single"], check=True)
    wrong = compare(scratch / "merged", scratch / "single")
    print(f"{len(finished(scratch / 'merged'))} workloads of {SHARDS} shards: {'; '.join(wrong) or 'equal'}")
    return 1 if wrong else 0


def main():
    program, sweep = (Path(argument).resolve() for argument in sys.argv[1:3])
    missing = [name for name in ("slurmctld", "slurmd", "sbatch") if shutil.which(name) is None]
    if missing:
        print(f"skipped: no {', '.join(missing)} here; install Debian's slurm-wlm")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="ctpbench_slurm_") as name:
        scratch = Path(name)
        (scratch / "slurm").mkdir()
        try:
            return test(program, sweep, scratch)
        except BaseException:
            for log in sorted(scratch.glob("slurm/*.log")) + sorted(scratch.glob("job-*.log")):
                print(f"== {log.name}\n" + "\n".join(log.read_text(errors="replace").splitlines()[-15:]))
            raise


if __name__ == "__main__":
    sys.exit(main())
