"""The laboratory of distances, for a solver in Python.

    import mien.lab
    print(mien.lab.check(my_distances))     # my_distances(points, x, y): 3 x 2 control points, arrays of coordinates

The cases are those of `mien-accuracy`: families of quadratic Bézier curves and points that solvers get wrong, with distances true
to 105 bits. The wheel has the program; else it is built with -DMIEN_BUILD_ACCURACY=ON, and found in PATH, in MIEN_ACCURACY, or as
`program`; or `cases` is a file that `mien-accuracy --export` wrote. docs/numerics.md says what the families are. A solver is asked
for one place at a time: x and y are arrays of length 1.

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

from ._errors import Error
from ._library import lib

__all__ = ["FeetRow", "FeetTable", "Row", "Table", "check", "check_feet"]

Reals = numpy.typing.NDArray[numpy.float64]
Solver = Callable[[Reals, Reals, Reals], Any]


class Row(NamedTuple):
    """What a solver did on one family."""

    family: str
    cases: int
    wrong: int    # by more than rounding in float32 explains: 1e-6 of the curve's size, and 2 units in the last place
    nan: int      # no number, or infinite
    worst: float  # error in 2**-52 of the largest distance from the point to a control point
    p999: float   # the same: all but one in a thousand are below
    worst_case: tuple[float, ...]  # x0, y0, x1, y1, x2, y2, x, y


class Table(tuple[Row, ...]):
    """One row a family."""

    def __str__(self) -> str:
        lines = [f"{'family':32}{'cases':>9}{'wrong':>9}{'nan':>7}{'worst':>12}{'p99.9':>12}"]
        lines += [f"{r.family:32}{r.cases:9}{r.wrong:9}{r.nan:7}{r.worst:12.3g}{r.p999:12.3g}" for r in self]
        total = sum(r.wrong + r.nan for r in self)
        return "\n".join([*lines, f"{total} of {sum(r.cases for r in self)} wrong: off by more than rounding in float32 explains, or no number;"
                          " worst and p99.9 in 2^-52 of the largest distance from the point to a control point"])

    __repr__ = __str__


def check(solver: Solver, *, count: int = 1000, seed: int = 1, program: Optional[str] = None,
          cases: "str | os.PathLike[str] | None" = None) -> Table:
    """Runs a solver on `count` cases of each family."""
    return Table(_row(solver, name, of) for name, of in _families(count, seed, program, cases, []).items())


class FeetRow(NamedTuple):
    """What a solver of feet did on one family."""

    family: str
    cases: int
    wrong: int       # the nearest foot is another one, or its distance off by 1e-6 of the curve's size
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
        return "\n".join([*lines, f"{total} of {sum(r.cases for r in self)} wrong; distances in units of 2^-52 S"])

    __repr__ = __str__


def check_feet(solver: Callable[[Reals, Reals, Reals], Any], *, count: int = 1000, seed: int = 1, program: Optional[str] = None,
               cases: "str | os.PathLike[str] | None" = None) -> FeetTable:
    """Runs a solver of feet, solver(points, x, y), on `count` cases of each family of one quadratic curve. Its two feet need `t`,
    `distance` and `normal`; a next foot that is not there has an infinite distance."""
    found = _families(count, seed, program, cases, ["--feet"])
    return FeetTable(_feet_row(solver, name, of) for name, of in found.items())


def _families(count: int, seed: int, program: Optional[str], cases: "str | os.PathLike[str] | None",
              more: list[str]) -> dict[str, Reals]:
    columns = 19 if more else 10
    if cases is not None:
        return _read(cases, columns)
    command = program or os.environ.get("MIEN_ACCURACY") or _own_program()
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


def _read(file: "str | os.PathLike[str]", columns: int) -> dict[str, Reals]:
    families: dict[str, list[list[float]]] = {}
    with open(file, encoding="utf-8", newline="") as lines:
        rows = csv.reader(line for line in lines if not line.startswith("#"))
        header: list[str] = next(rows, [])
        if header[:2] != ["family", "x0"] or len(header) != columns + 1:
            raise Error(os.fspath(file), f"is not a file of mien-accuracy {'--feet ' * (columns > 10)}--export")
        for name, *numbers in rows:
            families.setdefault(name, []).append([float.fromhex(one) for one in numbers])
    return {name: numpy.array(of) for name, of in families.items()}


def _feet_row(solver: Callable[[Reals, Reals, Reals], Any], family: str, cases: Reals) -> FeetRow:
    wrong, wrong_next, distance, normal, worst = 0, 0, 0.0, 0.0, 0
    for i, case in enumerate(cases):
        points, p = case[:6].reshape(3, 2), case[6:8]
        size = max(float(numpy.max(points.max(0) - points.min(0))), float(numpy.spacing(numpy.float32(case[9]))) * 2e6)
        largest = float(numpy.max(numpy.hypot(*(points - p).T)))
        feet = [_told(foot) for foot in solver(points, case[6:7], case[7:8])]
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


def _told(foot: Any) -> list[float]:
    t, away, normal = (numpy.asarray(one, float).ravel() for one in (foot.t, foot.distance, foot.normal))
    return [float(t[0]), float(away[0]), float(normal[0]), float(normal[1])]


def _is_level(points: Reals, p: Reals, t: float) -> bool:
    """Whether the curve is all but perpendicular to the way from p there."""
    way = (1 - t) ** 2 * points[0] + 2 * t * (1 - t) * points[1] + t * t * points[2] - p
    speed = (1 - t) * (points[1] - points[0]) + t * (points[2] - points[1])
    return bool(abs(way @ speed) <= 1e-6 * numpy.hypot(*way) * numpy.hypot(*speed))


def _is_foot(told: list[float], truth: Reals, size: float) -> bool:
    if not numpy.isfinite(truth[1]):
        return bool(numpy.isposinf(told[1]))
    return bool(abs(told[1] - truth[1]) <= 1e-6 * size and abs(told[0] - truth[0]) <= 1e-2)


def _distance(told: Any) -> float:
    """What a solver gave for one place."""
    distances = numpy.asarray(told, float).ravel()
    if distances.size != 1:
        raise Error("solver", f"expected one distance for one place, got {distances.size}")
    return float(distances[0])


def _row(solver: Solver, family: str, cases: Reals) -> Row:
    found = numpy.array([_distance(solver(case[:6].reshape(3, 2), case[6:7], case[7:8])) for case in cases])
    truth, rest = cases[:, 8], cases[:, 9]
    controls, point = cases[:, :6].reshape(-1, 3, 2), cases[:, None, 6:8]
    size = numpy.max(controls.max(1) - controls.min(1), axis=1)
    largest = numpy.max(numpy.hypot(*(controls - point).transpose(2, 0, 1)), axis=1)
    finite = numpy.isfinite(found)
    with numpy.errstate(all="ignore"):
        error = numpy.abs((found - truth) - rest)
        error[~finite] = numpy.inf
        ulp = numpy.spacing(truth.astype(numpy.float32)).astype(numpy.float64)
        wrong = finite & (error > 1e-6 * size) & (error > 2 * ulp)
        units = numpy.where(error == 0, 0, error / (2.0**-52 * largest))
    worst = int(numpy.argmax(units))
    p999 = numpy.sort(units)[int(0.999 * (len(units) - 1))]
    return Row(family, len(cases), int(wrong.sum()), int((~finite).sum()), float(units[worst]), float(p999),
               tuple(float(one) for one in cases[worst, :8]))
