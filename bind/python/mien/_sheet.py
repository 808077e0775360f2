"""Several faces in one picture."""
from __future__ import annotations

from typing import Any, Iterable, Optional, Union

import numpy
import numpy.typing

from ._errors import Error
from ._face import Face, from_code
from ._kinds import said, whole
from ._library import hinted_with
from ._picture import Color, Renderer, Size, color, sides
from ._posed import HOW, Posed
from ._saved import Picture

Shown = Union[Face, Posed, str, numpy.typing.NDArray[Any]]


@hinted_with(HOW)
def sheet(faces: Iterable[Shown], *, columns: Optional[int] = None, cell: Size = 160, gap: int = 0, gap_color: Color = "white",
          **how: Any) -> Picture:
    """A picture of faces in rows: faces, posed faces, codes, or pictures of `render` that are as large as the first cell.

    columns  in a row; default as many as make it nearly square
    cell     the size of each face [px]: the longer side, or (width, height)
    gap      pixels between faces, of `gap_color`
    how      as for `Posed.render`: background, fit, light, effects …
    """
    if isinstance(faces, (str, bytes, Face, Posed)) or not hasattr(faces, "__iter__"):
        raise TypeError(f"faces: expected a list of faces, got {said(faces)}")
    sides(cell, 1, "cell")
    renderer = Renderer()
    cells = [_drawn(one, cell, renderer, how) for one in faces]
    if not cells:
        raise Error("faces", "expected one face or more, got none")
    across = whole(columns, "columns") if columns is not None else int(numpy.ceil(numpy.sqrt(len(cells))))
    space = whole(gap, "gap")
    if across < 1 or space < 0:
        raise Error("columns" if across < 1 else "gap", f"expected {'1' if across < 1 else '0'} or more, got {across if across < 1 else space}")
    across = min(across, len(cells))
    height, width = (max(one.shape[axis] for one in cells) for axis in (0, 1))
    rows = -(-len(cells) // across)
    pixels = numpy.empty((rows * (height + space) - space, across * (width + space) - space, 4), numpy.uint8)
    pixels[...] = _encoded(gap_color)
    for i, one in enumerate(cells):
        y, x = i // across * (height + space), i % across * (width + space)
        pixels[y:y + one.shape[0], x:x + one.shape[1]] = one
    return Picture(pixels)


def _drawn(one: Shown, cell: Size, renderer: Renderer, how: "dict[str, Any]") -> numpy.typing.NDArray[numpy.uint8]:
    if isinstance(one, numpy.ndarray):
        if one.ndim != 3 or one.shape[2] != 4 or one.dtype != numpy.uint8:
            raise TypeError(f"faces: expected pictures (height, width, 4) of uint8, got {one.shape} of {one.dtype}")
        return one
    face = from_code(one) if isinstance(one, str) else one
    if not isinstance(face, (Face, Posed)):
        raise TypeError(f"faces: expected faces, posed faces or codes, got {said(one)}")
    return (face.pose() if isinstance(face, Face) else face).render(cell, renderer=renderer, **how)


def _encoded(of: Color) -> "list[int]":
    """A colour as bytes of sRGB."""
    linear = numpy.clip(color(of, "gap_color"), 0, 1)
    srgb = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return [*(int(255 * one + 0.5) for one in srgb[:3]), int(255 * linear[3] + 0.5)]
