"""A copy of the tree that holds every planted fault at once, each behind its number."""
import collections
import json
import os
import pathlib
import re
import shutil
import subprocess

from sites import masked

HEADER = '#include "tools/mutants/mutant.h"\n#line 1\n'


def one_line(words):
    return " ".join(masked(words, also_strings=False).split())


def planted(source, faults):
    """A file's text with its faults, {number: Site}, each on the lines where it was."""
    for number, site in sorted(faults.items(), key=lambda one: -one[1].start):
        was = source[site.start:site.end]
        before, after = source[:site.start], "\n" * was.count("\n") + source[site.end:]
        begin = max(before.rfind(end) for end in ";{}") + 1
        # What is chosen when the program runs is no constant of the compiler's.
        statement, constants = re.subn(r"\b((static|inline)\s+)?constexpr\b(?=[^()]*=\s*$)", r"\1const", before[begin:])
        chosen = "on_now" if constants else "on"
        put = f"(mien::mutants::{chosen}({number}) ? ({one_line(site.changed)}) : ({one_line(was)}))"
        source = before[:begin] + statement + put + after
    return HEADER + source


def by_file(faults):
    files = collections.defaultdict(dict)
    for number, site in faults.items():
        files[site.file][number] = site
    return files


def write_file(root, tree, file, faults):
    text = (root / file).read_text()
    text = planted(text, faults) if faults else text
    copy = tree / file
    if not copy.is_file() or copy.read_text() != text:
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text)


def write_tree(root, tree, faults):
    """Files that are as they were keep their times, so that a second build is short."""
    files = by_file(faults)
    for name in subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root, capture_output=True, text=True, check=True).stdout.split("\n"):
        if not name or not (root / name).is_file():
            continue
        if name in files:
            write_file(root, tree, name, files[name])
            continue
        copy = tree / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        if not copy.is_file() or copy.read_bytes() != (root / name).read_bytes():
            shutil.copy(root / name, copy)


class Compiler:
    """Whether files with faults still compile, told without building them: as the release's build compiles its files."""

    def __init__(self, root, build):
        self.root, self.flags = root, set()
        for entry in json.loads((build / "compile_commands.json").read_text()):
            self.flags |= set(re.findall(r"(?:-I|-isystem |-D|-std=)\S+", entry["command"]))

    def compiles(self, tree, file):
        command = ["g++", "-fsyntax-only", "-w", "-x", "c++", *(re.sub(rf"{self.root}/(?!build/)", f"{tree}/", flag) for flag in " ".join(sorted(self.flags)).split()),
                   f"-I{tree}", "-mavx2", "-mfma", str(tree / file)]
        return subprocess.run(command, cwd=tree, capture_output=True).returncode == 0


def wrong_lines(printed):
    """{file: lines} a compiler names in errors and in the templates that led there."""
    lines = collections.defaultdict(set)
    for file, line in re.findall(r"([\w./-]+\.(?:h|cpp)):(\d+):\d+: +(?:error|required|in .constexpr)", printed):
        name = re.sub(r"^.*?/?(?=(lib|sdf|render|bind)/)", "", file)
        lines[name].add(int(line))
    return lines
