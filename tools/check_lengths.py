#!/usr/bin/env python3
"""How long the house's functions and files are.

    tools/check_lengths.py [ROOT] [--longest N]    prints median and 90th percentile, and the N longest functions;
                                                   names each breach as FILE:LINE: SENTENCE; exit 1 if there is one

A function's length is the lines from the first of its signature to its closing brace, all counted. Lambdas and local
types belong to the function they stand in. Half of all functions have at most MEDIAN lines, nine of ten at most P90. A
file has at most FILE lines, or says why in its first comment: "Longer than other files: …".

The code is formatted and compiles, so matching braces is enough to find the functions.
"""
import argparse
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from check_names import bare  # noqa: E402

MEDIAN, P90, FILE = 9, 25, 400
FUNCTIONS_IN = ("lib", "sdf", "render", "bind", "tools")
FILES_IN = FUNCTIONS_IN + ("tests", "bench", "fuzz", "examples")
EXCUSE = "Longer than other files"

SCOPE = re.compile(r"\b(namespace|struct|class|union|enum|extern)\b(?!.*\()", re.S)
# What may stand between a signature's last parenthesis and the body.
BODY = re.compile(r"\)\s*((const|noexcept|override|final|mutable|&&?|[A-Z][A-Z_]+)\s*)*(->[^=]*)?$", re.S)
MEMBERS = re.compile(r"\)\s*(noexcept\s*)?:(?!:).*[)}]\s*$", re.S)  # a constructor's initialisers


def without(text, opened, closed):
    """The text without what stands in such brackets; the outermost brackets stay."""
    kept, depth = [], 0
    for letter in text:
        depth -= letter == closed
        if depth == 0:
            kept.append(letter)
        depth += letter == opened
    return "".join(kept)


def kind_of(head):
    """What a brace opens, by what stands before it: "scope", "function" or "value"."""
    head = re.sub(r"^\s*template\s*<(?:[^<>]|<(?:[^<>]|<[^<>]*>)*>)*>", "", head)
    head = re.sub(r"\boperator\s*(\(\)|[^\s(\w]+)", "operator_", head)
    flat = without(head, "(", ")")
    if "=" in flat:
        return "value"
    if BODY.search(flat) or MEMBERS.search(flat):
        return "function"
    return "scope" if SCOPE.search(flat) else "value"


def functions(text):
    """(first line, last line, what it is called) of each function."""
    text = bare(text)
    opened = []       # kinds of the open braces
    starts = []       # of the open functions: (line, name)
    head_from, round_ = 0, 0
    for found in re.finditer(r"[(){};]|\b(?:public|private|protected):", text):
        token, at = found[0], found.start()
        inside = "function" in opened
        if token == "(":
            round_ += 1
        elif token == ")":
            round_ -= 1
        elif token == "{":
            kind = "value" if inside or round_ > 0 else kind_of(text[head_from:at])
            opened.append(kind)
            if kind == "function":
                first = head_from + len(text[head_from:at]) - len(text[head_from:at].lstrip())
                name = re.findall(r"([\w:~]+)\s*\(", text[first:at])
                starts.append((text.count("\n", 0, first) + 1, name[0] if name else "?", round_))
            if kind != "value":
                head_from = at + 1
        elif token == "}" and opened:
            kind = opened.pop()
            if kind == "function":
                first, name, round_ = starts.pop()
                yield first, text.count("\n", 0, at) + 1, name
            if kind != "value" and "function" not in opened:
                head_from = at + 1
        elif token == ";" and not inside and round_ == 0 or token.endswith(":") and not inside:
            head_from = found.end()


def percentile(sorted_lengths, share):
    return sorted_lengths[min(int(share * len(sorted_lengths)), len(sorted_lengths) - 1)] if sorted_lengths else 0


def sources(root, rooms):
    for room in rooms:
        for path in sorted((root / room).rglob("*")):
            if path.suffix in (".h", ".c", ".cpp"):
                yield path


def main():
    parser = argparse.ArgumentParser(add_help=True)
    parser.add_argument("root", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    parser.add_argument("--longest", type=int, default=0)
    asked = parser.parse_args()
    breaches, found = [], []
    for path in sources(asked.root, FILES_IN):
        name, text = path.relative_to(asked.root).as_posix(), path.read_text(encoding="utf-8")
        lines = text.count("\n")
        if lines > FILE and EXCUSE not in "\n".join(text.split("\n")[:10]):
            breaches.append(f"{name}:1: has {lines} lines and does not say why: more than {FILE} start with \"{EXCUSE}: …\"")
        if name.split("/")[0] in FUNCTIONS_IN:
            found += [(last - first + 1, name, first, called) for first, last, called in functions(text)]
    lengths = sorted(length for length, *_ in found)
    median, p90 = percentile(lengths, 0.5), percentile(lengths, 0.9)
    for share, length, most in (("half of all", median, MEDIAN), ("nine of ten", p90, P90)):
        if length > most:
            breaches.append(f"tools/check_lengths.py:1: {share} functions have at most {length} lines, where {most} are wanted")
    for length, name, line, called in sorted(found, reverse=True)[:asked.longest]:
        print(f"{name}:{line}: {called} has {length} lines")
    print("\n".join(breaches + [f"{len(lengths)} functions: median {median} lines, 90 % at most {p90}, the longest {lengths[-1] if lengths else 0}"]))
    return bool(breaches)


if __name__ == "__main__":
    sys.exit(main())
