#!/usr/bin/env python3
"""A plan by job arrays of a real Slurm on this machine alone: slurm_test.py MIEN SOURCE [PEOPLE SIZE]    exit 77 where there is none"""
import contextlib
import hashlib
import json
import os
import pathlib
import pwd
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

MIEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
PEOPLE, SIZE = (int(word) for word in (sys.argv[3:5] or ("240", "64")))
PARTS, KILLED = 4, 2


def skip(why):
    print(why)
    sys.exit(77)


if os.geteuid() != 0:
    skip("only root may start slurmctld, slurmd and munged")
PROGRAMS = {name: shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin") for name in ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scontrol", "sinfo")}
if None in PROGRAMS.values():
    skip("needs slurm-wlm and munge: tools/setup")


def free_ports(count):
    open_ = [socket.socket() for _ in range(count)]
    for one in open_:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in open_]
    for one in open_:
        one.close()
    return ports


class Cluster:
    """slurmctld, slurmd and munged with keys, ports and files of their own. Nothing of the machine's own configuration is read."""

    def __init__(self, folder):
        self.folder = folder
        self.started = []
        for name in ("state", "spool", "run"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        ctld, d = free_ports(2)
        host = socket.gethostname().split(".")[0]
        self.conf = folder / "slurm.conf"
        self.conf.write_text(f"""ClusterName=loop
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/run/munge.sock
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/run/ctld.pid
SlurmdPidFile={folder}/run/d.pid
SlurmctldPort={ctld}
SlurmdPort={d}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
KillWait=2
JobRequeue=1
SlurmdParameters=config_overrides
SlurmctldLogFile={folder}/ctld.log
SlurmdLogFile={folder}/d.log
NodeName={host} NodeAddr=127.0.0.1 CPUs={PARTS} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:{PARTS}
""")
        self.environment = dict(os.environ, SLURM_CONF=str(self.conf), MIEN=MIEN)

    def start(self):
        run = self.folder / "run"
        self.daemon("munged", "--foreground", "--force", "--key-file", self.folder / "munge.key", "--socket", run / "munge.sock", "--pid-file", run / "munge.pid",
                    "--log-file", self.folder / "munge.log", "--seed-file", run / "munge.seed")
        self.until(lambda: (run / "munge.sock").exists(), "munged")
        self.daemon("slurmctld", "-D", "-f", self.conf)
        self.daemon("slurmd", "-D", "-f", self.conf)
        self.until(lambda: "idle" in self.run("sinfo", "-h", "-o", "%T", check=False), "a node that is idle")

    def daemon(self, name, *words):
        log = open(self.folder / f"{name}.out", "wb")
        self.started.append(subprocess.Popen([PROGRAMS[name], *map(str, words)], stdout=log, stderr=log, stdin=subprocess.DEVNULL, env=self.environment))

    def run(self, name, *words, check=True):
        return subprocess.run([PROGRAMS[name], *map(str, words)], check=check, capture_output=True, text=True, env=self.environment).stdout.strip()

    def until(self, true, what, seconds=90):
        end = time.monotonic() + seconds
        while not true():
            if time.monotonic() > end:
                logs = "\n".join(f"{log.name}: {log.read_text(errors='replace')[-2000:]}" for log in self.folder.glob("*.log"))
                raise SystemExit(f"no {what} after {seconds} s\n{logs}")
            time.sleep(0.1)

    def tasks(self, job):
        """The states of a job's tasks that have not ended, by their number."""
        lines = self.run("squeue", "-h", "-r", "-j", job, "-o", "%K %T", check=False).splitlines()
        return {number: state for number, state in (line.split() for line in lines if line)}

    def state(self, job):
        return re.findall(r"JobState=(\w+)", self.run("scontrol", "show", "job", job, check=False))

    def stop(self):
        for process in reversed(self.started):
            process.terminate()
        for process in reversed(self.started):
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def hashes(folder):
    return {path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.rglob("*.png"))}


def processes_of(part, folder):
    """mien batch on a part of that folder."""
    found = []
    for line in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = line.read_bytes().split(b"\0")
        except OSError:
            continue
        if f"{part}/{PARTS}".encode() in words and str(folder).encode() in words and b"batch" in words and words[0] == MIEN.encode():
            found.append(int(line.parent.name))
    return found


def main(folder):
    plan = json.loads((SOURCE / "examples/slurm/crowd.json").read_text())
    plan["jobs"][0]["each"]["who"]["people"] = PEOPLE
    plan["jobs"][0]["run"][plan["jobs"][0]["run"].index("256")] = str(SIZE)
    (folder / "plan.json").write_text(json.dumps(plan))
    began = time.monotonic()
    subprocess.run([MIEN, "batch", folder / "plan.json", "-o", folder / "alone"], check=True)
    alone = time.monotonic() - began

    cluster = Cluster(folder)
    out = folder / "out"
    try:
        cluster.start()
        began = time.monotonic()
        words = SOURCE / "examples/slurm/batch.sbatch", folder / "plan.json", out
        job = cluster.run("sbatch", "--parsable", f"--array=1-{PARTS}", f"--output={folder}/task-%a.log", *words)
        after = cluster.run("sbatch", "--parsable", f"--dependency=afterok:{job}", f"--output={folder}/join.log", SOURCE / "examples/slurm/join.sbatch",
                            folder / "plan.json", out)
        kills = 0
        for kill in range(2):  # as a node that fails would end it; Slurm starts it again
            cluster.until(lambda: processes_of(KILLED, out), "process of the part to be killed")
            time.sleep(0.3 + alone / PARTS / 8)
            victims = processes_of(KILLED, out)
            if not victims:
                break  # a fast machine was done with the rest of the part
            for process in victims:
                cluster.run("scontrol", "requeue", f"{job}_{KILLED}", check=False)
                with contextlib.suppress(ProcessLookupError):  # Slurm was faster
                    os.kill(process, signal.SIGKILL)
                kills += 1
                cluster.until(lambda: process not in processes_of(KILLED, out), "end of a killed process")
            # Slurm waits two minutes before it starts a task again, unless it is told; credentials count in whole seconds.
            cluster.until(lambda: "PENDING" in cluster.tasks(job).get(str(KILLED), ""), "task in the queue again")
            cluster.run("scontrol", "update", f"JobId={job}_{KILLED}", "StartTime=now+2seconds", check=False)
        cluster.until(lambda: not cluster.tasks(job), "end of all parts", 600 + 8 * alone)
        together = time.monotonic() - began
        cluster.until(lambda: cluster.state(after) and cluster.state(after)[0] not in ("PENDING", "RUNNING", "COMPLETING"), "end of the join")
        said = (folder / "join.log").read_text()
        logs = "".join(f"{log.name}:\n{log.read_text()}" for log in sorted(folder.glob("task-*.log")))
    finally:
        cluster.stop()
    print(logs + "join: " + said)
    print(f"{PEOPLE} people of {SIZE} px: one process {alone:.1f} s, {PEOPLE / alone:.1f} a second; {PARTS} tasks, one killed {kills} times, {together:.1f} s, "
          f"{PEOPLE / together:.1f} a second")
    assert kills >= 1, "nothing was killed"
    assert said == f"{PEOPLE} items, all whole; 0 joined\n", said
    assert hashes(out) == hashes(folder / "alone") and len(hashes(out)) == PEOPLE
    left = [path.name for path in out.rglob(".mien-*")]
    assert not left, left


with tempfile.TemporaryDirectory(prefix="mien-slurm-") as scratch:
    main(pathlib.Path(scratch))
