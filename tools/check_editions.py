#!/usr/bin/env python3
"""Frozen editions of the parts stay as they are: each file of parts/A is what parts/A.lock says, and so on for every edition but Z.

    tools/check_editions.py [ROOT]     names each breach as FILE:1: SENTENCE; exit 1 if there is one

The lock's other lines are hashes of faces and pictures, which tests/golden/frozen_editions_test.cpp draws anew.
"""
import hashlib
import pathlib
import re
import sys

TRIAL = "Z"
FILE = re.compile(r"([0-9a-f]{64})  (\S.*)")
HASHES = ("faces", "pictures fused", "pictures unfused")


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def files_below(folder):
    return {path.relative_to(folder).as_posix(): path for path in sorted(folder.rglob("*")) if path.is_file()}


def frozen(parts):
    """The signs of the editions that are to be locked."""
    return sorted({path.name[0] for path in parts.iterdir()
                   if re.fullmatch(r"[A-Z](\.lock)?", path.name) and path.name[0] != TRIAL})


def breaches(parts, sign):
    folder, lock = parts / sign, parts / f"{sign}.lock"
    if not lock.is_file():
        return [(folder, f"edition {sign} is not locked; tools/freeze_edition makes editions")]
    if not folder.is_dir():
        return [(lock, f"edition {sign} is gone; editions stay for ever")]
    text = lock.read_text(encoding="utf-8")
    locked = {name: value for value, name in FILE.findall(text)}
    there, found = files_below(folder), []
    for name in sorted(locked.keys() | there.keys()):
        if name not in there:
            found.append((folder / name, f"edition {sign} is frozen, and this file of it is gone"))
        elif name not in locked:
            found.append((folder / name, f"edition {sign} is frozen: a new part is of the next edition"))
        elif digest(there[name]) != locked[name]:
            found.append((folder / name, f"edition {sign} is frozen, and this file was changed: a better part is a new one, "
                                         "with its own name and number, of the next edition"))
    for kind in HASHES:
        if not re.search(rf"^{kind} \d+ 0x[0-9a-f]+$", text, re.M):
            found.append((lock, f"there is no hash of {kind}"))
    return found


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
    signs = frozen(root / "parts")
    found = [breach for sign in signs for breach in breaches(root / "parts", sign)]
    for path, sentence in found:
        print(f"{path.relative_to(root)}:1: {sentence}")
    if not found:
        print(f"{len(signs)} frozen editions, each as it was frozen")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
