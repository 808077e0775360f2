"""People by codes: twelve signs that are a face. Who has something held, or is a child of two, has a longer one.

Where a word is asked for, a whole number is its text: `crowd(42, 3)` is `crowd("42", 3)`. `code` and `recipe` alone take the number that
`seed` gives.

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
from typing import Any, Iterator, Mapping, NamedTuple, Union

from . import _kinds
from ._errors import Error
from ._kinds import Word, number, said, table, whole
from ._library import call, hinted, lib, texts, utf8

__all__ = ["between", "child", "code", "crowd", "difference", "hold", "in_full", "near", "neutral", "numbers", "parts", "recipe", "seed", "styles"]


@hinted
def seed(word: Word) -> int:
    """The seed that a word stands for: the same word, the same seed, below 2**50."""
    found = ctypes.c_uint64()
    call(lib.mien_seed_from_word, *utf8(_kinds.word(word, "word")), ctypes.byref(found))
    return found.value


@hinted
def code(of: Union[str, int]) -> str:
    """The code of a word, or of a seed: `code(seed("ada"))` is `code("ada")`."""
    return texts(lib.mien_code_from_seed, seed(_kinds.text(of, "of")) if isinstance(of, str) else _seed(of, "a word or a seed"))[0]


@hinted
def recipe(of: Union[str, int]) -> str:
    """The recipe of a code, or of a seed: a face file of a few lines."""
    if isinstance(of, str):
        return texts(lib.mien_recipe_from_code, *utf8(of, "of"))[0]
    return texts(lib.mien_recipe_from_seed, _seed(of, "a code or a seed"))[0]


@hinted
def in_full(words: str, name: str = "face") -> str:
    """A recipe's face in full: a file in which every feature stands and nothing is of parts.

    >>> in_full(recipe("A66CB-AA5S0-14")).count('"format_version": 1')
    1
    """
    return texts(lib.mien_recipe_in_full, *utf8(words), *utf8(name))[0]


@hinted
def crowd(word: Word, count: int) -> list[str]:
    """The codes of people no two of whom look alike. The first n are the same in every crowd of the word. A whole number is its text: 42 is
    "42".

    >>> crowd("chorus", 3) == crowd("chorus", 5)[:3]
    True
    """
    return texts(lib.mien_crowd, *utf8(_kinds.word(word, "word")), whole(count, "count"))


@hinted
def hold(person: str, *held: Union[str, Mapping[str, Any]], clamp: bool = False) -> str:
    """The code with things held whatever its seed says: "hair=bob", "eye.size=1.05", or {"hair": "bob", "glasses": None}."""
    for one in held:
        for words in [one] if isinstance(one, str) else _held(table(one, "held", '"hair=bob" or {"hair": "bob"}')):
            person = texts(lib.mien_code_hold, *utf8(person, "person"), *utf8(words, "held"), bool(clamp))[0]
    return person


def _held(values: Mapping[Any, Any]) -> Iterator[str]:
    """Parts' names, none of a family as "none" or None, and numbers."""
    for name, value in values.items():
        if value is not None and not isinstance(value, str):
            number(value, f"hold[{name!r}]")
        yield f"{name}={'none' if value is None else value}"


@hinted
def neutral(person: str) -> str:
    """The code of the same person without an expression: no smile, no mood, lips closed."""
    return texts(lib.mien_code_neutral, *utf8(person, "person"))[0]


@hinted
def near(person: str, by: float = 0.3, seed: Word = 0) -> str:
    """Somebody like that person; `by`, 0 to 1, is how far and how likely things change."""
    return texts(lib.mien_code_near, *utf8(person), number(by, "by"), _seed_of_word(seed))[0]


@hinted
def between(one: str, other: str, at: float = 0.5) -> str:
    """Somebody between two: 0 is the one, 1 the other."""
    return texts(lib.mien_code_between, *utf8(one), *utf8(other), number(at, "at"))[0]


@hinted
def child(one: str, other: str, seed: Word = 0) -> str:
    """A child of two."""
    return texts(lib.mien_code_of_child, *utf8(one), *utf8(other), _seed_of_word(seed))[0]


@hinted
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


@hinted
def styles() -> tuple[str, ...]:
    """How people can be painted.

    >>> "ink" in styles()
    True
    """
    return tuple(texts(lib.mien_part_styles))


@hinted
def parts() -> dict[str, tuple[str, ...]]:
    """What `hold` takes by family: {"hair": ("crop", …), …}. The first is "none" where a face may do without."""
    return {family: tuple(texts(lib.mien_part_names, *utf8(family))) for family in texts(lib.mien_part_families)}


@hinted
def numbers() -> dict[str, Number]:
    """The numbers that `hold` takes, by name."""
    found, held = {}, (ctypes.c_double * 3)()
    for name in texts(lib.mien_part_numbers):
        call(lib.mien_part_number, *utf8(name), held)
        found[name] = Number(*held)
    return found


_seed_of_word = seed


def _seed(of: Any, like: str) -> int:
    number = _kinds.index(of, "of", like)
    if not 0 <= number < 2**50:
        raise Error("of", f"expected a seed, 0 to below 2^50, got {said(number)}")
    return number
