"""The command `mien`, for what is written once and stands there: films, tables as faces, experiments."""
from __future__ import annotations

import functools
import os
import pathlib
import shutil
import subprocess
import warnings
from types import MappingProxyType
from typing import Iterator, Mapping, Optional

from ._errors import Error, Warned
from ._library import lib, text


# Where MIEN_COMMAND is seen from: the program may go elsewhere before it needs the command.
_BEGAN_IN = os.path.abspath(os.curdir) if os.path.isdir(os.curdir) else ""


def candidates() -> Iterator[str]:
    """Where it may be: MIEN_COMMAND, the package, beside the library, PATH."""
    if os.environ.get("MIEN_COMMAND"):
        yield os.path.join(_BEGAN_IN, os.environ["MIEN_COMMAND"])
        return
    here = pathlib.Path(__file__).resolve()
    yield str(here.parent / "native/mien")
    library = pathlib.Path(lib._name)
    if library.parent != pathlib.Path():
        yield str(library.parent / "mien")
        yield str(library.parent.parent / "bin/mien")
    if len(here.parents) > 4:
        yield str(here.parents[4] / "bin/mien")  # of PREFIX/lib/python3/dist-packages
    found = shutil.which("mien")
    if found:
        yield found


def _is_program(path: str) -> bool:
    """Whether it is a program, and not this package's own script, which would look for one again."""
    try:
        with open(path, "rb") as file:
            return os.access(path, os.X_OK) and not file.read(2) == b"#!"
    except OSError:
        return False


@functools.lru_cache(maxsize=8)
def _version(path: str) -> str:
    try:
        said = subprocess.run([path, "--version"], capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return said.stdout.strip()


def found() -> Optional[str]:
    """The command of this version; another one would draw other faces."""
    wanted = f"mien {text(lib.mien_version_text())}"
    return next((one for one in candidates() if _is_program(one) and _version(one) == wanted), None)


def needed(what: str, instead: str = "") -> str:
    """The command, or a sentence that tells what needs it."""
    command = found()
    if command is None:
        version = text(lib.mien_version_text())
        raise Error(what, f"needs the command mien {version}, which is neither in the package, nor beside libmien_c, nor in PATH{instead}; "
                          "MIEN_COMMAND may say where it is")
    return command


def ran(what: str, *words: "str | os.PathLike[str]", instead: Mapping[str, str] = MappingProxyType({})) -> "tuple[str, list[str]]":
    """What the command prints, and what it warns of. What it refuses is an Error in its words. `instead` of addresses of files that stand for
    something else, users read its name."""
    command = needed(what)
    done = subprocess.run([command, *(os.fspath(word) for word in words), "--progress", "none"], capture_output=True, text=True, encoding="utf-8", errors="replace")
    told = done.stderr
    for path, name in instead.items():
        told = told.replace(path, name)
    lines = [line.removeprefix("mien: ").removeprefix("warning: ") for line in told.splitlines() if line.strip()]
    if done.returncode:
        where, _, sentence = (lines[-1] if lines else f"{what}: ended with {done.returncode}").partition(": ")
        raise Error(where, sentence)
    return done.stdout, lines


def run(what: str, *words: "str | os.PathLike[str]", instead: Mapping[str, str] = MappingProxyType({})) -> str:
    """What the command prints. What it warns of is a `mien.Warned`."""
    printed, lines = ran(what, *words, instead=instead)
    for line in lines:
        warnings.warn(line, Warned, stacklevel=4)  # who called mien.chernoff or mien.stimuli
    return printed
