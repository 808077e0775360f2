"""The laboratory of distances, for a solver in Python.

    import mien.lab
    print(mien.lab.check(my_distances))     # my_distances(points, x, y): 3 x 2 control points, arrays of coordinates

The cases are those of `mien-accuracy`: families of quadratic Bézier curves and points that solvers get wrong, with distances true
to 105 bits. The wheel has the program; else it is built with -DMIEN_BUILD_ACCURACY=ON, and found in PATH, in MIEN_ACCURACY, or as
`program`; or `cases` is a file that `mien-accuracy --export` wrote. docs/numerics.md says what the families are. A solver is asked
for one place at a time: x and y are arrays of length 1. It gives one distance, a number or an array of one.

    print(mien.lab.check_feet(my_feet))     # gives (nearest, next), as mien.distance.feet.quad does
"""
from __future__ import annotations

import csv
import os
import pathlib
import subprocess
import tempfile
from typing import Any, Callable, NamedTuple, Optional

import numpy
import numpy.typing

from ._errors import Error, Path, reading
from ._kinds import path, real, said
from ._library import hinted, lib

__all__ = ["FeetRow", "FeetTable", "Row", "Table", "check", "check_feet"]

Reals = numpy.typing.NDArray[numpy.float64]
Solver = Callable[[Reals, Reals, Reals], Any]
BAR = 4  # of a solver in float64 [2^-52 S]: docs/numerics.md, "What is promised"
FEET_BAR = 8  # of the distances of its feet


class Row(NamedTuple):
    """What a solver did on one family."""

    family: str
    cases: int
    wrong: int    # bad, by over 1e-6 of the curve's size and 2 units in the last place of float32; or no number
    nan: int      # of them no number, or infinite
    worst: float  # error in 2**-52 of the largest distance from the point to a control point
    p999: float   # the same: all but one in a thousand are below
    worst_case: tuple[float, ...]  # x0, y0, x1, y1, x2, y2, x, y


class Table(tuple[Row, ...]):
    """One row a family."""

    def __str__(self) -> str:
        lines = [f"{'family':32}{'cases':>9}{'wrong':>9}{'NaN':>7}{'worst':>12}{'p99.9':>12}"]
        lines += [f"{r.family:32}{r.cases:9}{r.wrong:9}{r.nan:7}{r.worst:12.3g}{r.p999:12.3g}" for r in self]
        wrong, nan = sum(r.wrong for r in self), sum(r.nan for r in self)
        bars = f"off by over 1e-6 of the curve's size and over 2 ulp of float32, or NaN ({nan})"
        return "\n".join([*lines, f"{wrong} of {sum(r.cases for r in self)} wrong: {bars}; worst and p99.9 in 2^-52 S, S the largest distance from the"
                          f" point to a control point: the bar of a solver in float64 is {BAR}"])

    __repr__ = __str__


@hinted
def check(solver: Solver, *, count: int = 1000, seed: int = 1, program: Optional[Path] = None, cases: Optional[Path] = None) -> Table:
    """Runs a solver on `count` cases of each family of quadratic curves, and gives a `Table`: a `Row` for each family.

    solver   solver(points, x, y), of 3 x 2 control points and of x and y of length 1, gives one distance
    count    cases of each family
    seed     a whole number: others are other cases, the same number the same ones
    program  the path of mien-accuracy, where it is not found by itself
    cases    a file that `mien-accuracy --export` wrote; count, seed and program then say nothing
    """
    _expect_function(solver)
    return Table(_row(solver, name, of) for name, of in _families(count, seed, program, cases, []).items())


def _expect_function(solver: Any) -> None:
    if not callable(solver):
        raise TypeError(f"solver: expected a function, solver(points, x, y), got {said(solver)}")


class FeetRow(NamedTuple):
    """What a solver of feet did on one family."""

    family: str
    cases: int
    wrong: int       # the nearest foot is another one, no number, or its distance off by 1e-6 of the curve's size
    wrong_next: int  # the same of the next foot, or it is missing or invented
    distance: float  # worst error of the right ones, in 2**-52 of the largest distance from the point to a control point
    normal: float    # worst error of their normals, where 1e-6 of the size turns them by less than 1e-3
    worst_case: tuple[float, ...]  # x0, y0, x1, y1, x2, y2, x, y


class FeetTable(tuple[FeetRow, ...]):
    """One row a family."""

    def __str__(self) -> str:
        lines = [f"{'family':32}{'cases':>9}{'wrong':>9}{'next':>9}{'distance':>12}{'normal':>12}"]
        lines += [f"{r.family:32}{r.cases:9}{r.wrong:9}{r.wrong_next:9}{r.distance:12.3g}{r.normal:12.3g}" for r in self]
        total = sum(r.wrong + r.wrong_next for r in self)
        return "\n".join([*lines, f"{total} of {sum(r.cases for r in self)} wrong, nearest and next feet: another foot, NaN, or off by over 1e-6 of the curve's size;"
                          f" distances in 2^-52 S, S the largest distance from the point to a control point: the bar of a solver in float64 is {FEET_BAR}"])

    __repr__ = __str__


@hinted
def check_feet(solver: Callable[[Reals, Reals, Reals], Any], *, count: int = 1000, seed: int = 1, program: Optional[Path] = None,
               cases: Optional[Path] = None) -> FeetTable:
    """Runs a solver of feet on `count` cases of each family of one quadratic curve, and gives a `FeetTable`: a `FeetRow` for each family.

    solver   solver(points, x, y), as of `check`, gives two feet, the nearest and the next, with `t`, `distance` and `normal`; a next foot
             that is not there has an infinite distance
    count, seed, program, cases   as of `check`; cases are of `mien-accuracy --feet --export`
    """
    _expect_function(solver)
    found = _families(count, seed, program, cases, ["--feet"])
    return FeetTable(_feet_row(solver, name, of) for name, of in found.items())


def _families(count: int, seed: int, program: Optional[Path], cases: Optional[Path],
              more: list[str]) -> dict[str, Reals]:
    columns = 19 if more else 10
    if cases is not None:
        return _read(cases, columns)
    command = os.fspath(program or "") or os.environ.get("MIEN_ACCURACY") or _own_program()
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "cases.csv")
        try:
            ran = subprocess.run([command, "--export", file, "--count", str(count), "--seed", str(seed), *more],
                                 capture_output=True, text=True)
        except OSError as failure:
            raise Error(command, f"cannot be run: {failure.strerror}; it is in the package mien-accuracy, or built with "
                        "-DMIEN_BUILD_ACCURACY=ON; MIEN_ACCURACY or program= may say where it is") from None
        if ran.returncode:
            raise Error(command, ran.stderr.strip() or f"exit code {ran.returncode}")
        return _read(file, columns)


def _own_program() -> str:
    """The wheel's, the build's, or the system's."""
    places = [pathlib.Path(__file__).resolve().parent / "native"]
    library = pathlib.Path(lib._name)
    if library.parent != pathlib.Path():  # else the system found it, and a folder of that name is wherever the program runs
        places.append(library.parent / "tools/accuracy")
    return next((str(place / "mien-accuracy") for place in places if (place / "mien-accuracy").is_file()), "mien-accuracy")


def _read(file: Path, columns: int) -> dict[str, Reals]:
    families: dict[str, list[list[float]]] = {}
    with reading(file), open(path(file, "cases"), encoding="utf-8", errors="replace", newline="") as lines:
        rows = csv.reader(line for line in lines if not line.startswith("#"))
        header: list[str] = next(rows, [])
        if header[:2] != ["family", "x0"] or len(header) != columns + 1:
            raise Error(os.fspath(file), f"is not a file of mien-accuracy {'--feet ' * (columns > 10)}--export")
        for number, row in enumerate(rows, 1):
            families.setdefault(row[0] if row else "", []).append(_case(row, columns, f"{os.fspath(file)}: case {number}"))
    if not families:
        raise Error(os.fspath(file), "has no cases")
    return {name: numpy.array(of) for name, of in families.items()}


def _case(row: list[str], columns: int, where: str) -> list[float]:
    if len(row) != columns + 1:
        raise Error(where, f"expected {columns + 1} cells, got {len(row)}")
    try:
        return [float.fromhex(one) for one in row[1:]]
    except ValueError:
        raise Error(where, "expected numbers in hexadecimal") from None


def _feet_row(solver: Callable[[Reals, Reals, Reals], Any], family: str, cases: Reals) -> FeetRow:
    wrong, wrong_next, distance, normal, worst = 0, 0, 0.0, 0.0, 0
    for i, case in enumerate(cases):
        points, p = case[:6].reshape(3, 2), case[6:8]
        size = max(float(numpy.max(points.max(0) - points.min(0))), float(numpy.spacing(numpy.float32(case[9]))) * 2e6)
        largest = float(numpy.max(numpy.hypot(*(points - p).T)))
        feet = _two_feet(solver(points, case[6:7], case[7:8]))
        true = [case[8:13], case[13:18]]
        gap = case[14] - case[9]
        is_tie = gap < 1e-6 * size
        is_best = _is_foot(feet[0], true[0], size) or is_tie and _is_foot(feet[0], true[1], size)
        is_next = _is_foot(feet[1], true[1], size) or is_tie and _is_foot(feet[1], true[0], size)
        if not numpy.isfinite(case[14]):  # else rounding may have made one
            is_next = is_next or abs(feet[0][0] - feet[1][0]) > 1e-4 and _is_level(points, p, feet[1][0])
        elif case[18] < 1e-6 * size:
            is_next = True
        wrong, wrong_next = wrong + (not is_best), wrong_next + (not is_next)
        for told, truth in zip(feet, true):
            if not _is_foot(told, truth, size) or not numpy.isfinite(truth[1]) or largest == 0:
                continue
            off = abs(told[1] - truth[1]) / (2.0**-52 * largest)
            if off > distance:
                distance, worst = off, i
            if 1e-6 * size * abs(truth[4]) < 1e-3 and truth[1] > 1e-3 * size:
                normal = max(normal, float(numpy.hypot(told[2] - truth[2], told[3] - truth[3])))
    return FeetRow(family, len(cases), wrong, wrong_next, float(distance), normal, tuple(float(one) for one in cases[worst, :8]))


def _two_feet(told: Any) -> list[list[float]]:
    """What a solver gave for one place."""
    feet = list(told) if isinstance(told, (tuple, list)) else []
    if len(feet) != 2:
        raise Error("solver", f"expected two feet, (nearest, next), for one place, got {_given(told)}")
    return [_told(foot) for foot in feet]


def _told(foot: Any) -> list[float]:
    found: list[float] = []
    for name, count in (("t", 1), ("distance", 1), ("normal", 2)):
        if not hasattr(foot, name):
            raise Error("solver", f"expected a foot with t, distance and normal, got {_given(foot)}")
        found += _numbers(getattr(foot, name), count, f"{name} of a foot" if count == 1 else f"{name} of a foot, 2 numbers,")
    return found


def _numbers(told: Any, count: int, what: str) -> list[float]:
    """Of a solver's answer so many numbers, which may be NaN."""
    try:
        numbers = real(told, "solver").ravel()
    except TypeError:
        numbers = numpy.empty(0, bool)
    if numbers.dtype.kind == "b":
        raise Error("solver", f"expected one {what} for one place, got {_given(told)}")
    if numbers.size != count:
        raise Error("solver", f"expected one {what} for one place, got {numbers.size}")
    return [float(one) for one in numbers]


def _given(told: Any) -> str:
    return "None: is a return missing?" if told is None else said(told)


def _is_level(points: Reals, p: Reals, t: float) -> bool:
    """Whether the curve is all but perpendicular to the way from p there."""
    way = (1 - t) ** 2 * points[0] + 2 * t * (1 - t) * points[1] + t * t * points[2] - p
    speed = (1 - t) * (points[1] - points[0]) + t * (points[2] - points[1])
    return bool(abs(way @ speed) <= 1e-6 * numpy.hypot(*way) * numpy.hypot(*speed))


def _is_foot(told: list[float], truth: Reals, size: float) -> bool:
    if not numpy.isfinite(truth[1]):
        return bool(numpy.isposinf(told[1]))
    return bool(abs(told[1] - truth[1]) <= 1e-6 * size and abs(told[0] - truth[0]) <= 1e-2)


def _row(solver: Solver, family: str, cases: Reals) -> Row:
    found = numpy.array([_numbers(solver(case[:6].reshape(3, 2), case[6:7], case[7:8]), 1, "distance")[0] for case in cases])
    truth, rest = cases[:, 8], cases[:, 9]
    controls, point = cases[:, :6].reshape(-1, 3, 2), cases[:, None, 6:8]
    size = numpy.max(controls.max(1) - controls.min(1), axis=1)
    largest = numpy.max(numpy.hypot(*(controls - point).transpose(2, 0, 1)), axis=1)
    finite = numpy.isfinite(found)
    with numpy.errstate(all="ignore"):
        error = numpy.abs((found - truth) - rest)
        error[~finite] = numpy.inf
        ulp = numpy.spacing(truth.astype(numpy.float32)).astype(numpy.float64)
        wrong = ~finite | (error > 1e-6 * size) & (error > 2 * ulp)
        units = numpy.where(error == 0, 0, error / (2.0**-52 * largest))
    worst = int(numpy.argmax(units))
    p999 = numpy.sort(units)[int(0.999 * (len(units) - 1))]
    return Row(family, len(cases), int(wrong.sum()), int((~finite).sum()), float(units[worst]), float(p999),
               tuple(float(one) for one in cases[worst, :8]))
