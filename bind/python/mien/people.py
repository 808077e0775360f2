"""People by codes: twelve signs that are a face. Who has something held, or is a child of two, has a longer one.

>>> from mien import people
>>> ada = people.code("ada")
>>> len(ada), people.difference(ada, ada)
(14, 0.0)
>>> twin = people.near(ada, 0.1, seed=3)
>>> people.difference(ada, twin) > 0
True
"""
from __future__ import annotations

import ctypes
from typing import NamedTuple

from ._library import call, lib, texts, utf8
from ._picture import whole

__all__ = ["between", "child", "code", "crowd", "difference", "hold", "in_full", "near", "numbers", "parts", "recipe", "seed", "styles"]


def seed(word: str) -> int:
    """The seed that a word stands for: the same word, the same seed, below 2**50."""
    found = ctypes.c_uint64()
    call(lib.mien_seed_from_word, *utf8(word), ctypes.byref(found))
    return found.value


def code(of: str | int) -> str:
    """The code of a word or a seed."""
    return texts(lib.mien_code_from_seed, _seed(of))[0]


def recipe(of: str | int) -> str:
    """The recipe of a code or a seed: a face file of a few lines."""
    if isinstance(of, str):
        return texts(lib.mien_recipe_from_code, *utf8(of))[0]
    return texts(lib.mien_recipe_from_seed, _seed(of))[0]


def in_full(words: str, name: str = "face") -> str:
    """A recipe's face in full: a file in which every feature stands and nothing is of parts.

    >>> in_full(recipe("A66CB-AA5S0-14")).count('"format_version": 1')
    1
    """
    return texts(lib.mien_recipe_in_full, *utf8(words), *utf8(name))[0]


def crowd(word: str, count: int) -> list[str]:
    """The codes of people no two of whom look alike. The first n are the same in every crowd of the word.

    >>> crowd("chorus", 3) == crowd("chorus", 5)[:3]
    True
    """
    return texts(lib.mien_crowd, *utf8(word), whole(count, "count"))


def hold(person: str, *held: str, clamp: bool = False) -> str:
    """The code with things held whatever its seed says: "hair=bob", "eye.size=1.05"."""
    for one in held:
        person = texts(lib.mien_code_hold, *utf8(person), *utf8(one), clamp)[0]
    return person


def near(person: str, by: float = 0.3, seed: str | int = 0) -> str:
    """Somebody like that person; `by`, 0 to 1, is how far and how likely things change."""
    return texts(lib.mien_code_near, *utf8(person), float(by), _seed(seed))[0]


def between(one: str, other: str, at: float = 0.5) -> str:
    """Somebody between two: 0 is the one, 1 the other."""
    return texts(lib.mien_code_between, *utf8(one), *utf8(other), float(at))[0]


def child(one: str, other: str, seed: str | int = 0) -> str:
    """A child of two."""
    return texts(lib.mien_code_of_child, *utf8(one), *utf8(other), _seed(seed))[0]


def difference(one: str, other: str) -> float:
    """How different two people look: about 1 for other hair."""
    found = ctypes.c_double()
    call(lib.mien_code_difference, *utf8(one), *utf8(other), ctypes.byref(found))
    return found.value


class Number(NamedTuple):
    """A number that people have."""

    lo: float
    hi: float
    rest: float  # what it is where nothing is said


def styles() -> tuple[str, ...]:
    """How people can be painted.

    >>> "ink" in styles()
    True
    """
    return tuple(texts(lib.mien_part_styles))


def parts() -> dict[str, tuple[str, ...]]:
    """What `hold` takes by family: {"hair": ("crop", …), …}. The first is "none" where a face may do without."""
    return {family: tuple(texts(lib.mien_part_names, *utf8(family))) for family in texts(lib.mien_part_families)}


def numbers() -> dict[str, Number]:
    """The numbers that `hold` takes, by name."""
    found, held = {}, (ctypes.c_double * 3)()
    for name in texts(lib.mien_part_numbers):
        call(lib.mien_part_number, *utf8(name), held)
        found[name] = Number(*held)
    return found


_seed_of_word = seed


def _seed(of: str | int) -> int:
    if isinstance(of, str):
        return _seed_of_word(of)
    if not 0 <= of < 2**64:
        return 2**64 - 1  # which the library refuses in its own words
    return of
