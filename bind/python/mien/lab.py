"""The laboratory of distances, for a solver in Python.

    import mien.lab
    print(mien.lab.check(my_distances))     # my_distances(points, x, y): 3 x 2 control points, arrays of coordinates

The cases are those of `mien-accuracy`: families of quadratic Bézier curves and points that solvers get wrong, with distances true
to 105 bits. The program is built with -DMIEN_BUILD_ACCURACY=ON, and found in PATH, in MIEN_ACCURACY, or as `program`; or
`cases` is a file that `mien-accuracy --export` wrote. docs/numerics.md says what the families are.
"""
from __future__ import annotations

import csv
import os
import subprocess
import tempfile
from typing import Any, Callable, NamedTuple, Optional

import numpy
import numpy.typing

from ._library import Error

__all__ = ["Row", "Table", "check"]

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
        return "\n".join([*lines, f"{total} of {sum(r.cases for r in self)} wrong; worst in units of 2^-52 S"])

    __repr__ = __str__


def check(solver: Solver, *, count: int = 1000, seed: int = 1, program: Optional[str] = None,
          cases: "str | os.PathLike[str] | None" = None) -> Table:
    """Runs a solver on `count` cases of each family."""
    if cases is not None:
        return _judge(solver, cases)
    command = program or os.environ.get("MIEN_ACCURACY") or "mien-accuracy"
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "cases.csv")
        try:
            ran = subprocess.run([command, "--export", file, "--count", str(count), "--seed", str(seed)],
                                 capture_output=True, text=True)
        except OSError as failure:
            raise Error(command, f"cannot be run: {failure.strerror}") from None
        if ran.returncode:
            raise Error(command, ran.stderr.strip() or f"exit code {ran.returncode}")
        return _judge(solver, file)


def _judge(solver: Solver, file: "str | os.PathLike[str]") -> Table:
    families: dict[str, list[list[float]]] = {}
    with open(file, encoding="utf-8", newline="") as lines:
        rows = csv.reader(line for line in lines if not line.startswith("#"))
        if next(rows, [])[:2] != ["family", "x0"]:
            raise Error(os.fspath(file), "is not a file of mien-accuracy --export")
        for name, *numbers in rows:
            families.setdefault(name, []).append([float.fromhex(one) for one in numbers])
    return Table(_row(solver, name, numpy.array(of)) for name, of in families.items())


def _row(solver: Solver, family: str, cases: Reals) -> Row:
    found = numpy.array([float(numpy.asarray(solver(case[:6].reshape(3, 2), case[6:7], case[7:8])).reshape(1)[0])
                         for case in cases])
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
