"""What a run of the command left behind, and whether that is what it promises.

A run ends with each of its files whole, the old one or the new one. It ends with 0 and in silence where all are new,
and otherwise with another code and one sentence. No signal ends it, and it leaves no other file.
"""
import dataclasses
import os
import pathlib
import re
import signal
import subprocess

OLD = b"an old file\n"
OTHERS = ("Error in GnuTLS initialization",)  # said by libraries that come with those that read and write pictures


@dataclasses.dataclass
class Ran:
    code: int         # -N: signal N ended it; None: it hung
    out: bytes
    err: str
    files: dict       # what each file of the folder holds, by its path in there


def environment():
    """Without the caller's search path for libraries, whose empty places would be searched at every start."""
    kept = {key: value for key, value in os.environ.items() if key not in ("LD_LIBRARY_PATH", "LD_PRELOAD")}
    return kept | {"LC_ALL": "C"}


def lay(folder, files, old):
    """The folder before a run: its files as old ones, or none of them."""
    for path in sorted(folder.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()
    for name in files:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        if old:
            (folder / name).write_bytes(OLD)


def held(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def run(words, folder, timeout=60, more={}):
    """Runs it to its end in a group of its own, which goes with it where it hangs."""
    process = subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               env=environment() | more, start_new_session=True)
    try:
        out, err = process.communicate(timeout=timeout)
        code = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate()
        code = None
    return Ran(code, out, err.decode(errors="replace"), held(folder))


def timeless(out):
    """Standard output without the times in it."""
    return re.sub(rb"[0-9.]+ s, \d+ %", b"", out)


def faults(ran, new, files, old, warns=False, told=True):
    """What is wrong with a run, in sentences. `new`: the undisturbed run. `told`: whether a sentence can be read at all."""
    wrong = []
    if ran.code is None:
        return ["hangs"]
    if ran.code < 0 or ran.code > 128:
        wrong.append(f"is ended by signal {-ran.code if ran.code < 0 else ran.code - 128}")
    for name, bytes_ in ran.files.items():
        if name not in files:
            wrong.append(f"leaves {re.sub('[0-9a-f]{16}', 'X', name)}")
        elif bytes_ != new.files[name] and not (old and bytes_ == OLD):
            wrong.append(f"leaves neither the old nor the new {name}, but {len(bytes_)} bytes")
    for name in files:
        if old and name not in ran.files:
            wrong.append(f"loses the old {name}")
    complete = timeless(ran.out) == timeless(new.out) and all(ran.files.get(name) == new.files[name] for name in files)
    if ran.code == 0 and not complete:
        wrong.append("succeeds without all of what it was to write")
    if ran.code != 0 and complete:
        wrong.append(f"fails with all of what it was to write: {ran.err.strip()}")
    lines = [line for line in ran.err.splitlines() if not line.startswith(OTHERS)]
    if ran.code == 0 and lines and not warns:
        wrong.append(f"succeeds and complains: {ran.err.strip()}")
    if ran.code != 0 and told and (len(lines) != 1 or not re.match(r"mien: .+", lines[0])):
        wrong.append(f"tells its failure in {len(lines)} lines: {ran.err[:300]!r}")
    return wrong
