"""Feet: where on curves the nearest point lies, in which direction, and the runner-up. In SIMD, with the same bytes everywhere.

>>> from mien import distance
>>> nearest, next = distance.feet.quad([[0, 0], [1, 2], [2, 0]], [1.0, 1.0], [2.0, -1.0])
>>> nearest.t, nearest.distance
(array([0.5, 0. ]), array([1.        , 1.41421356]))
>>> next.piece, next.distance
(array([-1,  0], dtype=int32), array([       inf, 1.41421356]))

A foot is a local minimum of the distance along the curve. `nearest` is the lowest, `next` the runner-up, which may be on another
curve of a list. x and y broadcast against each other to some shape S; all is float64, whatever they are.

    piece     int32 S, the curve's index in the list; -1: there is no such foot, and then
    t         0 to 1 along the curve; of an ellipse the parameter's angle [rad]                            0
    distance  as the functions of mien.distance have it                                                    infinity
    normal    S + (2,), its gradient, of length 1                                                          0, 0
    bend      the curvature of the level line there, positive where it bends away from the normal          0
    point     S + (2,), where the foot is on the outline: (x, y) - distance normal                          NaN

The normal points from the foot to the place; inside a stroke or an ellipse, where the distance is negative, from the place to the foot.

Curves in a list are joined where one begins exactly where the one before ends (with the same half-width). <mien/feet.h> has all
rules, docs/numerics.md the error bounds.
"""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple

import numpy
import numpy.typing

from . import distance as _distance
from ._errors import Error
from ._kinds import finite, real
from ._library import call, hinted, lib
from ._library import Feet as _Arrays

__all__ = ["Feet", "Foot", "ellipse", "line", "lines", "quad", "quads", "tapered", "tapereds"]

Reals = numpy.typing.NDArray[Any]
ArrayLike = numpy.typing.ArrayLike


class Foot(NamedTuple):
    """Arrays of the shape that x and y have together; `normal` and `point` have a last axis of 2 more."""

    piece: Any
    t: Any
    distance: Any
    normal: Any
    bend: Any
    point: Any

    def __repr__(self) -> str:
        shape = numpy.shape(self.distance)
        if shape == ():
            return f"<mien.distance.feet.Foot: piece {int(self.piece)}, t {float(self.t):.6g}, distance {float(self.distance):.6g}>"
        return f"<mien.distance.feet.Foot of {' x '.join(map(str, shape))} places: piece, t, distance, normal, bend, point>"


class Feet(NamedTuple):
    """The nearest foot and the next one."""

    nearest: Foot
    next: Foot

    def __repr__(self) -> str:
        return f"<mien.distance.feet.Feet: nearest={self.nearest!r}, next={self.next!r}>"


@hinted
def quad(points: ArrayLike, x: ArrayLike, y: ArrayLike) -> Feet:
    """On the quadratic Bézier curve of 3 points.

    >>> quad([(0, 0), (1, 0), (2, 0)], 3, 0).nearest.normal.tolist()
    [1.0, 0.0]
    """
    return _feet("quads", [_distance._points(points, 3)], 6, x, y)


@hinted
def quads(curves: ArrayLike, x: ArrayLike, y: ArrayLike) -> Feet:
    """On n quadratic Bézier curves, an array (n, 3, 2).

    >>> nearest, next = quads([[(0, 0), (1, 0), (2, 0)], [(0, 5), (1, 5), (2, 5)]], 1, 4)
    >>> int(nearest.piece), int(next.piece), float(next.distance)
    (1, 0, 4.0)
    """
    return _feet("quads", [_listed(curves, "curves", (3, 2))], 6, x, y)


@hinted
def line(a: ArrayLike, b: ArrayLike, x: ArrayLike, y: ArrayLike, *, half_width: float = 0.0) -> Feet:
    """On the line from a to b; with a half-width it has round caps and the distance is signed.

    >>> float(line((0, 0), (2, 0), 1, 1, half_width=0.25).nearest.distance)
    0.75
    """
    numbers = [_distance._numbers(a, "a", 2), _distance._numbers(b, "b", 2), numpy.array([finite(half_width, "half_width")])]
    return _feet("lines", numbers, 5, x, y)


@hinted
def lines(segments: ArrayLike, x: ArrayLike, y: ArrayLike, *, half_width: float = 0.0) -> Feet:
    """On n lines, an array (n, 2, 2).

    >>> square = [[(0, 0), (2, 0)], [(2, 0), (2, 2)], [(2, 2), (0, 2)], [(0, 2), (0, 0)]]
    >>> nearest, next = lines(square, 0.5, 0.75)
    >>> nearest.normal.tolist(), next.normal.tolist()
    ([1.0, 0.0], [0.0, 1.0])
    """
    ends = _listed(segments, "segments", (2, 2)).reshape(-1, 4)
    width = finite(half_width, "half_width")
    return _feet("lines", [numpy.column_stack([ends, numpy.repeat(width, len(ends))]).ravel()], 5, x, y)


@hinted
def tapered(points: ArrayLike, half_widths: ArrayLike, x: ArrayLike, y: ArrayLike) -> Feet:
    """On a stroke along the quadratic Bézier curve of 3 points, whose half-width goes by 3 Bernstein coefficients; signed.

    >>> float(tapered([(0, 0), (1, 0), (2, 0)], (0.5, 0.5, 0.5), 1, 2).nearest.distance)
    1.5
    """
    return _feet("tapered", [_distance._points(points, 3), _distance._numbers(half_widths, "half_widths", 3)], 9, x, y)


@hinted
def tapereds(strokes: ArrayLike, half_widths: ArrayLike, x: ArrayLike, y: ArrayLike) -> Feet:
    """On n strokes, arrays (n, 3, 2) and (n, 3)."""
    points, widths = _listed(strokes, "strokes", (3, 2)).reshape(-1, 6), _listed(half_widths, "half_widths", (3,)).reshape(-1, 3)
    if len(points) != len(widths):
        raise Error("half_widths", f"expected {len(points)} times 3 numbers, as many as strokes, got {len(widths)} times")
    return _feet("tapered", [numpy.column_stack([points, widths]).ravel()], 9, x, y)


@hinted
def ellipse(center: ArrayLike, radii: ArrayLike, x: ArrayLike, y: ArrayLike, *, axis: ArrayLike = (1, 0)) -> Feet:
    """On an ellipse, negative inside. `axis` is the direction of the first radius.

    >>> nearest, next = ellipse((0, 0), (2, 1), 0, 0.25)
    >>> nearest.distance.round(9).tolist(), next.distance.round(9).tolist()
    (-0.75, -1.25)
    """
    numbers = [_distance._numbers(center, "center", 2), _distance._numbers(radii, "radii", 2), _distance._numbers(axis, "axis", 2)]
    return _feet("ellipse", numbers, None, x, y)


def _listed(of: ArrayLike, name: str, shape: tuple[int, ...]) -> Reals:
    numbers = real(of, name).astype(numpy.float64)
    if numbers.size and numbers.shape[-len(shape):] != shape:
        raise Error(name, f"expected an array (n, {', '.join(map(str, shape))}), got {numbers.shape}")
    return numbers.ravel()


def _feet(figures: str, numbers: list[Reals], each: Any, x: ArrayLike, y: ArrayLike) -> Feet:
    xs, ys = real(x, "x"), real(y, "y")
    try:
        shape = numpy.broadcast_shapes(xs.shape, ys.shape)
    except ValueError:
        raise Error("x, y", f"shapes {xs.shape} and {ys.shape} do not broadcast") from None
    ready = [numpy.ascontiguousarray(numpy.broadcast_to(one, shape), dtype=numpy.float64) for one in (xs, ys)]
    figure = numpy.ascontiguousarray(numpy.concatenate(numbers))
    count = ready[0].size
    rows, pieces = numpy.empty((2, 5, count)), numpy.empty((2, count), numpy.int32)
    arrays = [_Arrays(ctypes.sizeof(_Arrays), 0, pieces[i].ctypes.data, *(row.ctypes.data for row in rows[i])) for i in (0, 1)]
    call(getattr(lib, f"mien_feet_{figures}_f64"), figure.ctypes.data, *([] if each is None else [figure.size // each]),
         ready[0].ctypes.data, ready[1].ctypes.data, count, *map(ctypes.byref, arrays))
    places = numpy.stack(ready, -1).reshape(*shape, 2)
    return Feet(*(_foot(pieces[i], rows[i], shape, places) for i in (0, 1)))


def _foot(piece: Reals, rows: Reals, shape: tuple[int, ...], places: Reals) -> Foot:
    t, away, normal_x, normal_y, bend = rows
    normal = numpy.stack([normal_x, normal_y], -1).reshape(*shape, 2)
    plain = [one.reshape(shape)[()] for one in (piece, t, away, bend)]
    with numpy.errstate(invalid="ignore"):  # no foot: infinity times 0
        point = places - rows[1].reshape(*shape, 1) * normal
    return Foot(plain[0], plain[1], plain[2], normal, plain[3], point)
