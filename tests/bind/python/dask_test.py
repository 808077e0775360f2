#!/usr/bin/env python3
"""A plan by workers of a Dask cluster on this machine, one of which is killed: dask_test.py MIEN SOURCE [SIZE FRAMES]    exit 77 without Dask"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

try:
    import numpy  # noqa: F401
    from distributed import Client, LocalCluster
except ImportError:
    print("needs python3-distributed and python3-numpy: tools/setup")
    sys.exit(77)

MIEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SIZE, FRAMES = (int(word) for word in (sys.argv[3:5] or ("1600", "64")))
os.environ["MIEN_COMMAND"] = MIEN

import mien
import mien.dask


def plan_file(folder):
    plan = json.loads((SOURCE / "examples/dask/large_picture.json").read_text())
    plan["jobs"][0]["run"][plan["jobs"][0]["run"].index("16384")] = str(SIZE)
    plan["jobs"].append({"run": ["animate", "toon", "--size", "128", "--fps", "24", "--threads", "1"], "each": {"frame": {"frames": f"0-{FRAMES - 1}"}},
                         "output": "film/{frame}.png", "join": "film.apng"})
    path = folder / "plan.json"
    path.write_text(json.dumps(plan))
    return path


def kill_one(client, stop):
    """A worker, as a node that fails would end it, once the first files are there."""
    workers = client.run(os.getpid)
    while not stop.is_set() and not any(pathlib.Path(stop.folder).rglob("*.tif")):
        time.sleep(0.05)
    time.sleep(0.2)
    os.kill(next(iter(workers.values())), signal.SIGKILL)


def same(one, other):
    with open(one, "rb") as a, open(other, "rb") as b:
        while True:
            left, right = a.read(1 << 20), b.read(1 << 20)
            if left != right:
                return False
            if not left:
                return True


def main(folder):
    plan, out = plan_file(folder), folder / "out"
    began = time.monotonic()
    with LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None, local_directory=str(folder)) as cluster, Client(cluster) as client:
        stop = threading.Event()
        stop.folder = out
        parts = mien.dask.submit(plan, client, out, parts=8)
        killer = threading.Thread(target=kill_one, args=(client, stop), daemon=True)
        killer.start()
        said = client.gather(parts)
        stop.set()
        killer.join()
        drawn = time.monotonic() - began
        # An error of mien's comes back as what it is.
        wrong = folder / "wrong.json"
        wrong.write_text('{"format": "mien-batch", "format_version": 1, "jobs": []}')
        try:
            client.gather(mien.dask.submit(wrong, client, out, parts=1, retries=0))
            raise SystemExit("a wrong plan was drawn")
        except mien.Error as error:
            assert "expected 1 to 10000 jobs" in str(error), error
    began = time.monotonic()
    joined = mien.dask.join(plan, out)
    took = time.monotonic() - began
    print(*said, joined, sep="\n")
    assert joined == f"{16 + FRAMES} items, all whole; 2 joined", joined
    began = time.monotonic()
    subprocess.run([MIEN, "render", "toon", "--size", str(SIZE), "-o", folder / "whole.tif"], check=True)
    picture = time.monotonic() - began
    subprocess.run([MIEN, "animate", "toon", "--size", "128", "--fps", "24", "--frames", f"0-{FRAMES - 1}", "-o", folder / "whole.apng"], check=True,
                   stdout=subprocess.DEVNULL)
    film = time.monotonic() - began - picture
    assert same(out / "toon.tif", folder / "whole.tif"), "the joined picture is not the whole one"
    assert same(out / "film.apng", folder / "whole.apng"), "the joined film is not the whole one"
    print(f"16 regions of {SIZE} px and {FRAMES} frames by two workers, one killed, {drawn:.1f} s, joined in {took:.1f} s; one process {picture:.1f} s and "
          f"{film:.1f} s: the same bytes")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(prefix="mien-dask-") as scratch:
        main(pathlib.Path(scratch))
