"""A sweep as a Slurm job array, end to end: a real munged, slurmctld and slurmd of its own, in a temporary folder.

Usage: check_slurm.py SANDSIM. Exits 77 (skipped) where Slurm is not installed or does not start, or this is not root,
since slurmd has to be root. Nothing of a Slurm that may run on the machine is touched.
"""

import csv
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENE = """grid: {cells: [40, 1], spacing: 1 cm}
sand:
  friction_angle: 30 deg
  hbar: {policy: full}
  initial: {type: box, from: [0 m, 0 m], to: [10 cm, 1 cm], depth: 5 cm}
time: {end: 2 s, frame_interval: 20 ms, stop_at_rest: true}
"""
VALUES = "20,95,25,30 deg"     # 95 deg is no friction angle: that case fails
CASES, FAILING = 4, 2
ENDLESS = ("--set", "time={end: 1000 s, frame_interval: 20 ms, courant: 0.01}", "--set",
           "sand.sources=[{center: [20 cm, 0 m], radius: 2 cm, rate: 1 cm^3/s, end: 1000 s}]")
PATIENCE = 60                  # [s] for a daemon to come up

CONFIGURATION = """ClusterName=sandsim
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser=root
SlurmdUser=root
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
PrologFlags=NoHold
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def program(name):
    found = shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")
    if found is None:
        skip(f"there is no {name} (Debian: munge, slurmctld, slurmd, slurm-client)")
    return found


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Cluster:
    """One node with its controller. Everything ends with the `with` block."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        for name in ("state", "spool"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        (folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=folder, host=socket.gethostname().split(".")[0], controller_port=free_port(),
            node_port=free_port()))

    def __enter__(self):
        try:
            self.start("munged", "--foreground", "--force", f"--key-file={self.folder}/munge.key",
                       f"--socket={self.folder}/munge.socket", f"--pid-file={self.folder}/munged.pid",
                       f"--log-file={self.folder}/munged.log", f"--seed-file={self.folder}/munged.seed")
            self.wait_for("munge's socket", lambda: (self.folder / "munge.socket").exists())
            self.start("slurmctld", "-D", "-c")
            self.start("slurmd", "-D")
            self.wait_for("an idle node", lambda: "idle" in self.call("sinfo", "-h", "-o", "%T").stdout)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start(self, name, *options):
        with open(self.folder / f"{name}.out", "w") as output:
            self.daemons.append(subprocess.Popen([program(name), *options], env=self.environment, stdout=output,
                                                 stderr=output, stdin=subprocess.DEVNULL))

    def call(self, name, *options):
        return subprocess.run([program(name), *map(str, options)], env=self.environment, capture_output=True, text=True,
                              timeout=120)

    def wait_for(self, what, condition):
        end = time.monotonic() + PATIENCE
        while not condition():
            if any(daemon.poll() is not None for daemon in self.daemons) or time.monotonic() > end:
                for log in sorted(self.folder.glob("*.out")) + sorted(self.folder.glob("*.log")):
                    print(f"== {log.name}", log.read_text()[-2000:], sep="\n")
                skip(f"Slurm does not start here: no {what}")
            time.sleep(0.1)


def rows(results):
    with open(results / "summary.csv", newline="") as file:
        return list(csv.DictReader(file))


def expect(what, value, expected):
    if value != expected:
        sys.exit(f"{what}: {value!r} instead of {expected!r}")


def expand(sandsim, work, name, *options):
    """Writes the scene and the job script; returns the results folder."""
    results = work / name
    subprocess.run([sandsim, "sweep", work / "scene.yaml", *options, "--expand", "-o", results], check=True,
                   capture_output=True)
    return results


def sandsim_sweep(sandsim, *options):
    return subprocess.run([sandsim, "sweep", *options], capture_output=True, text=True)


def check_array(sandsim, cluster, work):
    """An array in which one case fails: the others are done, and what came of it is collected."""
    results = expand(sandsim, work, "array", "--vary", f"sand.friction_angle={VALUES}", "--skip-invalid")
    submitted = cluster.call("sbatch", "--wait", f"--array=1-{CASES}%2", results / "sweep.sbatch")
    expect("exit code of sbatch, which is the failing case's", submitted.returncode, 2)
    collected = sandsim_sweep(sandsim, results, "--collect")
    expect("exit code of --collect", collected.returncode, 2)
    expect("exit codes", [row["exit_code"] for row in rows(results)],
           ["2" if number == FAILING else "0" for number in range(1, CASES + 1)])
    log = (results / "slurm" / f"{FAILING}.log").read_text()
    expect("whether the failing case's log says why", "95 deg: out of range" in log, True)
    expect("what is left to do", "3 of 4 cases are done already" in sandsim_sweep(sandsim, results).stderr, True)
    print(collected.stdout)


def check_limit(sandsim, cluster, work):
    """What Slurm sends before a time limit makes a case write its checkpoint, from which it goes on."""
    results = expand(sandsim, work, "limit", "--vary", "gravity=9,10 m/s^2", *ENDLESS)
    job = cluster.call("sbatch", "--parsable", "--array=1", results / "sweep.sbatch").stdout.strip()
    cluster.wait_for("frames of a job", lambda: any(results.glob("cases/*/series.h5.partial")))
    cluster.call("scancel", "--signal=TERM", "--batch", f"{job}_1")
    cluster.wait_for("end of a job", lambda: not cluster.call("squeue", "-h").stdout.strip())
    expect("exit code of --collect", sandsim_sweep(sandsim, results, "--collect").returncode, 130)
    expect("states", [row["status"] for row in rows(results)], ["interrupted", "not run"])
    expect("checkpoints", len(list(results.glob("cases/*/checkpoint.h5"))), 1)
    again = sandsim_sweep(sandsim, results, "--case", "1", "--max-wall", "00:00:01", "-q")
    expect("exit code at the wall-clock limit", again.returncode, 7)
    log = next(results.glob("cases/*/log.txt")).read_text()
    expect("whether the case went on", "going on from" in log, True)


def check(sandsim, folder):
    work = folder / "work with spaces"
    work.mkdir()
    (work / "scene.yaml").write_text(SCENE)
    with Cluster(folder) as cluster:
        check_array(sandsim, cluster, work)
        check_limit(sandsim, cluster, work)


def main():
    if os.geteuid() != 0:
        skip("slurmd has to be root")
    for name in ("munged", "slurmctld", "slurmd", "sbatch", "sinfo"):
        program(name)
    # Not the folder of $TMPDIR: the path of a socket has to be short.
    with tempfile.TemporaryDirectory(prefix="sandsim_slurm_", dir="/tmp") as folder:
        os.chmod(folder, 0o755)      # munged refuses to put its socket where clients could not reach it
        check(sys.argv[1], Path(folder))


if __name__ == "__main__":
    main()
