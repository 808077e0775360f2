"""Distances from points to curves, in SIMD, without copies where arrays allow it.

>>> import numpy, mien
>>> mien.distance.quad([[0, 0], [0.5, 0], [1, 0]], 3.0, [0.0, 0.5])
array([2.        , 2.06155281])

x and y broadcast against each other, as in NumPy. Where both are float32 the distances are, too; everything else is float64.
`out` takes the distances; it may be x or y. A NaN or infinite coordinate gives infinity. Error bounds: docs/numerics.md.
`mien.distance.feet` has the nearest points, their normals and the runners-up.
"""
from __future__ import annotations

from typing import Any, Optional, Sequence, Union

import numpy
import numpy.typing

from ._errors import Error
from ._kinds import finite, listed, real
from ._library import call, hinted, lib

__all__ = ["cubic", "ellipse", "feet", "parabola", "quad", "quad_on_grid", "quads", "tapered"]

Reals = numpy.typing.NDArray[Any]
Points = Union[Sequence[Sequence[float]], Reals]  # control points


@hinted
def quad(points: Points, x: numpy.typing.ArrayLike, y: numpy.typing.ArrayLike, *,
         out: Optional[Reals] = None, accurate: bool = False) -> Any:
    """To the quadratic Bézier curve of 3 points. `accurate`: float32 as if computed in float64 and rounded once.

    >>> float(quad([(0, 0), (1, 2), (2, 0)], 1, 1))
    0.0
    """
    return _measure("quad", [_points(points, 3)], x, y, out, "quad_accurate" if accurate else None)


@hinted
def quads(curves: numpy.typing.ArrayLike, x: numpy.typing.ArrayLike, y: numpy.typing.ArrayLike, *,
          out: Optional[Reals] = None) -> Any:
    """To the nearest of n quadratic Bézier curves, an array (n, 3, 2). In float32, whatever x and y are; infinity if n is 0.

    >>> float(quads([[(0, 0), (1, 0), (2, 0)], [(0, 5), (1, 5), (2, 5)]], 1, 4))
    1.0
    """
    numbers = real(curves, "curves").astype(numpy.float64)
    if numbers.size % 6 or numbers.size and numbers.shape[-2:] != (3, 2):
        raise Error("curves", f"expected an array (n, 3, 2), got {numbers.shape}")
    xs, ys = real(x, "x").astype(numpy.float32), real(y, "y").astype(numpy.float32)
    return _measure("quads", [numbers.ravel()], xs, ys, out, "quads", numbers.size // 6)


@hinted
def quad_on_grid(points: Points, origin: tuple[float, float], step: float, columns: int, rows: int) -> Reals:
    """To the quadratic Bézier curve of 3 points, from a grid: an array (rows, columns) of float32, [j, i] from the point origin +
    step (i, j). Quickest where the grid is fine compared with the curve.

    >>> quad_on_grid([(0, 0), (1, 0), (2, 0)], (0, 1), 0.5, 2, 2).tolist()
    [[1.0, 1.0], [1.5, 1.5]]
    """
    if columns < 0 or rows < 0:
        raise Error("columns, rows", f"expected no negative numbers, got {columns} and {rows}")
    corner = _numbers(listed(origin, "origin", "(0, 0)"), "origin", 2)
    curve, found = _points(points, 3), numpy.empty((rows, columns), numpy.float32)
    call(lib.mien_distances_quad_on_grid_f32, curve.ctypes.data, float(corner[0]), float(corner[1]), finite(step, "step"), columns, rows,
         found.ctypes.data)
    return found


@hinted
def cubic(points: Points, x: numpy.typing.ArrayLike, y: numpy.typing.ArrayLike, *,
          out: Optional[Reals] = None) -> Any:
    """To the cubic Bézier curve of 4 points.

    >>> float(cubic([(0, 0), (1, 0), (2, 0), (3, 0)], 1, -2))
    2.0
    """
    return _measure("cubic", [_points(points, 4)], x, y, out)


@hinted
def ellipse(center: numpy.typing.ArrayLike, radii: numpy.typing.ArrayLike, x: numpy.typing.ArrayLike,
            y: numpy.typing.ArrayLike, *, axis: numpy.typing.ArrayLike = (1, 0), out: Optional[Reals] = None) -> Any:
    """To an ellipse, negative inside. `axis` is the direction of the first radius.

    >>> float(ellipse((0, 0), (2, 1), 0, 3))
    2.0
    >>> float(ellipse((0, 0), (2, 1), 0, 3, axis=(0, 1)))
    1.0
    """
    figure = [_numbers(center, "center", 2), _numbers(radii, "radii", 2), _numbers(axis, "axis", 2)]
    return _measure("ellipse", figure, x, y, out)


@hinted
def parabola(vertex: numpy.typing.ArrayLike, axis: numpy.typing.ArrayLike, bend: float, x: numpy.typing.ArrayLike,
             y: numpy.typing.ArrayLike, *, out: Optional[Reals] = None) -> Any:
    """To the parabola vertex + u (axis turned left) + bend u² axis, negative on the side that the axis points to.

    >>> float(parabola((0, 0), (0, 1), 1, 0, -2))
    2.0
    >>> float(parabola((0, 0), (0, 1), 1, 0, 0.25))
    -0.25
    """
    return _measure("parabola", [_numbers(vertex, "vertex", 2), _numbers(axis, "axis", 2), numpy.array([finite(bend, "bend")])], x, y, out)


@hinted
def tapered(points: Points, half_widths: numpy.typing.ArrayLike, x: numpy.typing.ArrayLike,
            y: numpy.typing.ArrayLike, *, out: Optional[Reals] = None) -> Any:
    """To a stroke along the quadratic Bézier curve of 3 points, negative inside. Its half-width goes by 3 Bernstein
    coefficients, `half_widths`.

    >>> float(tapered([(0, 0), (1, 0), (2, 0)], (0.5, 0.5, 0.5), 1, 2))
    1.5
    """
    return _measure("tapered", [_points(points, 3), _numbers(half_widths, "half_widths", 3)], x, y, out)


def _points(of: numpy.typing.ArrayLike, count: int) -> Reals:
    points = real(of, "points").astype(numpy.float64)
    if points.shape not in ((count, 2), (2 * count,)):
        raise Error("points", f"expected {count} points, an array ({count}, 2) or ({2 * count},), got {points.shape}")
    return points.ravel()


def _numbers(of: numpy.typing.ArrayLike, name: str, count: int) -> Reals:
    numbers = real(of, name).astype(numpy.float64).ravel()
    if numbers.size != count:
        raise Error(name, f"expected {count} numbers, got {numbers.size}")
    return numbers


def _measure(figure: str, numbers: list[Reals], x: numpy.typing.ArrayLike, y: numpy.typing.ArrayLike,
             out: Optional[Reals], single_kernel: Optional[str] = None, count: Optional[int] = None) -> Any:
    xs, ys = real(x, "x"), real(y, "y")
    # A Python number beside an array takes the array's type.
    kinds = [one.dtype for one, given in ((xs, x), (ys, y)) if not isinstance(given, (int, float))]
    single = bool(kinds) and all(kind in (numpy.dtype("f4"), numpy.dtype("f2")) for kind in kinds)
    dtype = numpy.dtype(numpy.float32 if single else numpy.float64)
    try:
        shape = numpy.broadcast_shapes(xs.shape, ys.shape)
    except ValueError:
        raise Error("x, y", f"shapes {xs.shape} and {ys.shape} do not broadcast") from None
    place = _place(out, shape, dtype, xs, ys)
    ready = [numpy.ascontiguousarray(numpy.broadcast_to(one, shape), dtype=dtype) for one in (xs, ys)]
    curve = numpy.concatenate(numbers)
    kernel = getattr(lib, f"mien_distances_{(single_kernel or figure) if single else figure}_{'f32' if single else 'f64'}")
    call(kernel, curve.ctypes.data, *([] if count is None else [count]), ready[0].ctypes.data, ready[1].ctypes.data,
         place.ctypes.data, place.size)
    if out is None:
        return place[()] if shape == () else place
    if place is not out:
        out[...] = place
    return out


def _place(out: Optional[Reals], shape: tuple[int, ...], dtype: "numpy.dtype[Any]", xs: Reals, ys: Reals) -> Reals:
    """Where the kernel writes: `out` itself if it can."""
    if out is None:
        return numpy.empty(shape, dtype)
    if not isinstance(out, numpy.ndarray):
        raise TypeError(f"out: expected an array, got {type(out).__name__}")
    if out.shape != shape:
        raise Error("out", f"its shape is {out.shape}, and the distances' {shape}")
    if not out.flags.writeable:
        raise Error("out", "is read-only")
    if not numpy.can_cast(dtype, out.dtype, "same_kind"):
        raise TypeError(f"out: cannot hold {dtype} as {out.dtype}")
    if out.dtype == dtype and out.flags.c_contiguous and out.flags.aligned and out.dtype.isnative:
        # In the same place as x or y is well; any other overlap is not.
        if all(one.ctypes.data == out.ctypes.data and one.shape == shape or not numpy.may_share_memory(one, out)
               for one in (xs, ys)):
            return out
    return numpy.empty(shape, dtype)


from . import _feet as feet  # noqa: E402  (it stands on what is above)
