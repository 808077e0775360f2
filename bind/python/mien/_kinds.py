"""Arguments of wrong kinds, each told in a sentence with the argument's name."""
from __future__ import annotations

import inspect
import math
import operator
import os
import re
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy
import numpy.typing

from ._errors import Error, Path

Word = Union[str, int]  # a whole number is its text: 42 is "42"
Text = Union[str, bytes]


def said(value: Any) -> str:
    """A value in an error, cut short, without the address that Python gives objects."""
    try:
        shown = re.sub(r" at 0x[0-9a-f]+", "", repr(value))
    except ValueError:  # of a whole number with thousands of digits
        shown = "a number of very many digits"
    return shown if len(shown) <= 60 else shown[:57] + "..."


def table(value: Any, name: str, like: str) -> Mapping[Any, Any]:
    """A mapping, or a sentence that tells what is one."""
    if not isinstance(value, Mapping):
        raise TypeError(f"{name}: expected {like}, got {said(value)}")
    return value


def listed(value: Any, name: str, like: str) -> Sequence[Any]:
    """A list, or a sentence: a text is none, although Python takes its letters for one."""
    if isinstance(value, (str, bytes, Mapping)) or not hasattr(value, "__iter__"):
        raise TypeError(f"{name}: expected a list, such as {like}, got {said(value)}")
    return list(value)


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a text, got {said(value)}")
    encoded(value, name)
    return value


def encoded(value: str, name: str) -> bytes:
    """A text in UTF-8. Bytes that the system gave in names of files come back as they were; other lone surrogates are no signs."""
    try:
        return value.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise Error(name, f"expected a text of signs that Unicode has, got {said(value)}") from None


def raw(value: Any, name: str) -> bytes:
    """A file's text, as bytes."""
    if not isinstance(value, (str, bytes)):
        raise TypeError(f"{name}: expected a text or bytes, got {said(value)}")
    return value if isinstance(value, bytes) else encoded(value, name)


def word(value: Any, name: str) -> str:
    """A word, or a whole number as its text."""
    if isinstance(value, str):
        return text(value, name)
    try:
        return str(index(value, name, "a word or a whole number"))
    except Error:
        raise
    except ValueError:
        raise Error(name, "has too many digits") from None


def index(value: Any, name: str, like: str) -> int:
    """A whole number, and no truth or array that could be one."""
    if not isinstance(value, (bool, numpy.bool_, numpy.ndarray)):
        try:
            return operator.index(value)
        except TypeError:
            pass
    raise TypeError(f"{name}: expected {like}, got {said(value)}")


def path(value: Any, name: str) -> str:
    """A path's text. Bytes and numbers of open files are none."""
    where = value if isinstance(value, str) else os.fspath(value) if isinstance(value, os.PathLike) else None
    if not isinstance(where, str):
        raise TypeError(f"{name}: expected a path, got {said(value)}")
    if "\0" in where:
        raise Error(name, f"a path has no NUL, got {said(where)}")
    encoded(where, name)
    return where


def file(value: Any, name: str) -> None:
    """A path, or a file object that takes bytes."""
    if not hasattr(value, "write"):
        if not isinstance(value, (str, os.PathLike)):
            raise TypeError(f"{name}: expected a path or a file object, got {said(value)}")
        path(value, name)


def whole(value: Any, name: str) -> int:
    try:
        found = int(value.__index__())
    except (AttributeError, TypeError):
        raise TypeError(f"{name}: expected a whole number, got {said(value)}") from None
    if not -2**31 <= found < 2**31:
        raise Error(name, f"is out of range: {said(found)}")
    return found


def number(value: Any, name: str) -> float:
    """A number; texts are none, although float() reads them. It may be NaN or infinite."""
    found: Optional[float] = None
    if not isinstance(value, (str, bytes)):
        try:
            found = float(value)
        except (TypeError, ValueError):
            pass
        except OverflowError:
            raise Error(name, f"is out of range: {said(value)}") from None
    if found is None:
        raise TypeError(f"{name}: expected a number, got {said(value)}")
    return found


def finite(value: Any, name: str) -> float:
    """The same where the library would take NaN and infinity."""
    found = number(value, name)
    if not math.isfinite(found):
        raise Error(name, f"expected a finite number, got {found}")
    return found


def truth(value: Any, name: str) -> bool:
    """True or False; 1 and 0 are, too."""
    if not isinstance(value, (bool, numpy.bool_)) and not (isinstance(value, int) and value in (0, 1)):
        raise TypeError(f"{name}: expected True or False, got {said(value)}")
    return bool(value)


def watch(value: Any, name: str) -> None:
    if not callable(value):
        raise TypeError(f"{name}: expected a function, got {said(value)}")


def real(of: Any, name: str) -> numpy.typing.NDArray[Any]:
    """An array of real numbers, or a sentence: no texts, no complex numbers, no rows of several lengths."""
    try:
        array = numpy.asarray(of)
    except (ValueError, TypeError) as failure:
        raise TypeError(f"{name}: expected numbers, got {said(of)}: {failure}") from None
    if isinstance(of, numpy.ma.MaskedArray) and bool(numpy.any(of.mask)):
        raise TypeError(f"{name}: expected numbers, got a masked array in which some are missing")
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name}: expected real numbers, got {array.dtype if array.dtype.kind != 'O' else said(of)}")
    return array


# What stands in annotations, and what looks at such an argument before its function does. Functions look at all others themselves.
Check = Callable[[Any, str], object]
_CHECKS: "dict[str, Check]" = {"str": text, "int": whole, "float": number, "bool": truth, "Path": path, "File": file, "Word": word, "Text": raw, "Watch": watch}


def check_of(parameter: inspect.Parameter) -> Optional[Check]:
    """What looks at an argument, by its annotation; None is well where the annotation says so."""
    said_there = str(parameter.annotation)
    optional = re.fullmatch(r"Optional\[(.*)\]", said_there)
    check = _CHECKS.get(optional[1] if optional else said_there)
    if check is None or not optional:
        return check
    known = check  # which is there
    return lambda value, name: None if value is None else known(value, name)
