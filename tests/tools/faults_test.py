#!/usr/bin/env python3
"""The judge of tools/faults finds each fault that a program may have, and a short form of its three programs passes.

    faults_test.py judge                     stand-ins that do it wrong are found out
    faults_test.py calls MIEN                exit 77 without strace
    faults_test.py kills MIEN
    faults_test.py memory MIEN MALLOC
"""
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
TOOLS = SOURCE / "tools/faults"
sys.dont_write_bytecode = True
sys.path.insert(0, str(TOOLS))
import outcome

# What a stand-in does after it has been told to write `out`, and what is found; %: a line of its own.
STAND_INS = (
    ("echo new >out", True, []),
    ("echo 'mien: no' >&2; exit 1", True, []),
    ("echo new >out; exit 1", True, ["fails with all of what it was to write"]),
    ("exit 0", True, ["succeeds without all of what it was to write"]),
    ("exit 0", False, ["succeeds without all of what it was to write"]),
    ("exit 1", True, ["tells its failure in 0 lines"]),
    ("echo 'mien: no' >&2; echo 'mien: again' >&2; exit 1", True, ["tells its failure in 2 lines"]),
    ("echo 'no' >&2; exit 1", True, ["tells its failure in 1 lines"]),
    ("echo new >out; echo 'mien: no' >&2", True, ["succeeds and complains"]),
    ("printf ne >out; echo 'mien: no' >&2; exit 1", True, ["leaves neither the old nor the new out"]),
    ("printf ne >out", False, ["leaves neither the old nor the new out", "succeeds without"]),
    ("rm out; echo 'mien: no' >&2; exit 1", True, ["loses the old out"]),
    ("touch .mien-0123456789abcdef.part; echo 'mien: no' >&2; exit 1", True, ["leaves .mien-X.part"]),
    ("kill -SEGV $$", True, ["is ended by signal 11"]),
    ("sleep 9", True, ["hangs"]),
)


def judge():
    with tempfile.TemporaryDirectory(prefix="mien-test-") as own:
        folder = pathlib.Path(own)
        new = outcome.Ran(0, b"", "", {"out": b"new\n"})
        for does, old, found in STAND_INS:
            outcome.lay(folder, ["out"], old)
            ran = outcome.run(["bash", "-c", does], folder, timeout=2)
            faults = outcome.faults(ran, new, ["out"], old)
            for wanted in found:
                assert any(fault.startswith(wanted) for fault in faults), (does, old, faults)
            assert bool(faults) == bool(found), (does, old, faults)


def short(*words):
    ran = subprocess.run([TOOLS / words[0], *words[1:]])
    sys.exit(ran.returncode)


def main(what, *given):
    if what == "judge":
        judge()
    elif what == "calls":
        short("calls", *given, "--verbs", "png-face,tiff,set,gif,frames,basis,pca-npy,debug,new", "--errors", "1", "--every", "5")
    elif what == "kills":
        short("kills", *given, "--kills", "22", "--only", "kills,servers,streams,changed_targets,two_writers")
    else:
        short("memory", *given, "--verbs", "scene,png-face,set,gif", "--every", "61")


if __name__ == "__main__":
    main(*sys.argv[1:])
