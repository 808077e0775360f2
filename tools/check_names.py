#!/usr/bin/env python3
"""One definition for one name: no two files of the house define a type, constant or inline function of the same full name.

    tools/check_names.py [ROOT]     names each breach as FILE:LINE: SENTENCE; exit 1 if there is one

A compiler sees one file at a time, so two definitions of one name pass it, and the program is then broken without a word
(C++'s one-definition rule). What stands in an unnamed namespace belongs to its file alone.
"""
import collections
import pathlib
import re
import sys

ROOTS = ("lib", "sdf", "render", "bind", "tools", "mien.h", "write.h", "version.h")

TOKENS = re.compile(
    r"""(?P<space>\bnamespace\b(?P<name>[\w:\s]*)\{)
      | (?P<type>\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\b(?:\s+MIEN_API|\s+\[\[\w+\]\])*\s+(?P<called>[\w:]*\w)
          (?:\s+final)?\s*(?::[^;{]*)?\{)
      | (?P<constant>\binline\s+constexpr\b[^;={(]*?\b(?P<value>\w+)\s*(?:=|\{))
      | (?P<inline>\b(?:inline|constexpr)\b[^;{}()=]*?\b(?P<function>\w+)\((?P<takes>[^()]*)\)[^;{}]*\{)
      | (?P<open>\{) | (?P<close>\})""", re.X)


def bare(text):
    """The text without comments, strings and preprocessor lines, each replaced by as many lines."""
    def blank(found):
        return re.sub(r"[^\n]", " ", found[0])
    text = re.sub(r'R"\((?:.|\n)*?\)"|//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', blank, text)
    return re.sub(r"^[ \t]*#(?:.*\\\n)*.*", blank, text, flags=re.M)


def definitions(text):
    """(full name, line) of each type, constant and inline function that stands in named namespaces."""
    text, scopes = bare(text), []  # of open braces: a namespace's name, or None for any other
    for token in TOKENS.finditer(text):
        line = text.count("\n", 0, token.start()) + 1
        outside = all(scope is not None and scope != "" for scope in scopes)
        full = "::".join(scopes) if outside else None
        if token["space"]:
            scopes.append(re.sub(r"\s", "", token["name"]))
        elif token["type"]:
            if outside:
                yield f"{full}::{token['called']}", line
            scopes.append(None)
        elif token["constant"]:
            if outside:
                yield f"{full}::{token['value']}", line
            if token[0].endswith("{"):
                scopes.append(None)
        elif token["inline"]:
            if outside:
                takes = [one.split("=")[0].strip() for one in token["takes"].split(",")]
                types = [re.sub(r"(?<=[\w>&*\s])\b\w+$", "", one).strip() for one in takes]
                yield f"{full}::{token['function']}({', '.join(types)})", line
            scopes.append(None)
        elif token["open"]:
            scopes.append(None)
        elif scopes:
            scopes.pop()


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
    found = collections.defaultdict(list)
    for part in ROOTS:
        place = root / part
        for path in sorted(place.rglob("*")) if place.is_dir() else [place] * place.is_file():
            if path.suffix in (".h", ".cpp"):
                for name, line in definitions(path.read_text(encoding="utf-8")):
                    found[name].append(f"{path.relative_to(root).as_posix()}:{line}")
    breaches = [f"{place}: {name} is defined at {places[0]} too"  # in one file it is a choice by #if
                for name, places in sorted(found.items()) for place in places[1:]
                if place.split(":")[0] != places[0].split(":")[0]]
    print("\n".join(breaches) if breaches else f"{len(found)} names, each defined once")
    return bool(breaches)


if __name__ == "__main__":
    sys.exit(main())
