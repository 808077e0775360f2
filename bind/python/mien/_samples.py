"""The faces that come with mien."""
from __future__ import annotations

import pathlib

from ._errors import Error
from ._face import Face, read_face
from ._library import hinted, unknown_name

_ENDING = ".face.json"


def _folder() -> pathlib.Path:
    """In a wheel, in PREFIX/share/mien of an installed package, or in the source."""
    here = pathlib.Path(__file__).resolve()
    for place in (here.parent / "share/mien/faces", *(here.parents[i] / "share/mien/faces" for i in (4, 3) if i < len(here.parents)),
                  here.parents[3] / "faces"):
        if place.is_dir():
            return place
    raise Error("samples", "are not installed: Debian has them in the package mien, a wheel inside")


@hinted
def samples() -> "tuple[str, ...]":
    """The names of the faces that come with mien."""
    return tuple(sorted(file.name[:-len(_ENDING)] for file in _folder().glob("*" + _ENDING)))


@hinted
def sample(name: str) -> Face:
    """One of them: `mien.sample("toon")` is what the command calls toon."""
    if name not in samples():
        raise Error("name", unknown_name("sample face", name, samples()))
    return read_face(_folder() / (name + _ENDING))
