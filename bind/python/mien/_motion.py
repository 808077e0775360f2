"""Motions: takes of actors and tracks of speech."""
from __future__ import annotations

import os
import warnings
from typing import Any

from ._errors import Error, Path, Warned, reading
from ._kinds import Text, finite, number
from ._kinds import raw as raw_of
from ._library import Handle, hinted, lib, made_by, text, texts, unknown_name, utf8


class Motion:
    """What an actor's face did, or a track of speech as the shapes of a mouth: numbers by name over time."""

    def __init__(self, handle: Handle, raw: bytes, name: str) -> None:
        self._handle = made_by(handle, "a motion", "mien.read_motion or mien.read_motion_text")
        self._made_of = raw, name
        count = lib.mien_motion_channel_count(handle.value)
        self._index = {text(lib.mien_motion_channel_name(handle.value, i)): i for i in range(count)}

    @property
    def length(self) -> float:
        """[s] Until its last moment."""
        return float(lib.mien_motion_length(self._handle.value))

    @property
    def channels(self) -> tuple[str, ...]:
        """The controls that it moves: "arkit.jawOpen", "viseme.aa", "yaw"."""
        return tuple(self._index)

    @property
    def told(self) -> tuple[str, ...]:
        """What was odd in its file: values that were clamped, rows without a face, names that mean nothing."""
        return tuple(texts(lib.mien_motion_told, self._handle.value))

    @hinted
    def value(self, channel: str, time: float) -> float:
        """The channel's value at a moment [s]."""
        if channel not in self._index:
            raise Error("channel", unknown_name("channel", channel, self.channels))
        return float(lib.mien_motion_value(self._handle.value, self._index[channel], finite(time, "time")))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Motion) and self._made_of == other._made_of

    def __hash__(self) -> int:
        return hash(self._made_of)

    def __copy__(self) -> Motion:
        return self

    def __deepcopy__(self, memo: object) -> Motion:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, self._made_of

    def __repr__(self) -> str:
        return f"<mien.Motion: {len(self._index)} channels, {self.length:.2f} s>"


class Steady:
    """Keeps a face quiet that follows frames as they come live: the 1€ filter of Casiez, Roussel and Vogel. One face each."""

    @hinted
    def __init__(self, cutoff: float = 1, beta: float = 2) -> None:
        """`cutoff` [Hz] is above 0, lower is quieter; `beta` is 0 or above, higher is less late where much moves."""
        self._handle = Handle(lib.mien_steadier_free, lib.mien_steadier_new, number(cutoff, "cutoff"), number(beta, "beta"))

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("a Steady remembers the frames that it saw, and cannot be copied or pickled; make another one")


@hinted
def read_motion(path: Path) -> Motion:
    """Reads a take or a track of speech, whatever program wrote it. What is wrong is an `Error` with file, line and column; what is
    odd, such as a sound of no known name, is warned of (`Warned`), and stays in `told`."""
    with reading(path), open(path, "rb") as file:
        return _told_of(_made_again(file.read(), os.fspath(path)))


@hinted
def read_motion_text(words: Text, name: str = "motion") -> Motion:
    """The same from memory; `name` stands for the file's name in errors."""
    return _told_of(_made_again(raw_of(words, "words"), name))


def _made_again(raw: bytes, name: str) -> Motion:
    return Motion(Handle(lib.mien_motion_free, lib.mien_motion_read_text, raw, len(raw), *utf8(name)), raw, name)


def _told_of(motion: Motion) -> Motion:
    for odd in motion.told:
        warnings.warn(odd, Warned, stacklevel=4)  # who called mien.read_motion or mien.read_motion_text
    return motion
