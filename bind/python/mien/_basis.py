"""Bases of animations: principal components, and faces that are posed by them."""
from __future__ import annotations

import ctypes
import pathlib
import tempfile
from typing import Any, Optional, Sequence, Union

import numpy
import numpy.typing

from . import _library
from ._errors import Error, Path, reading
from ._kinds import number, real, whole
from ._library import Handle, call, hinted, lib, made_by, path_bytes
from ._saved import write_whole

Array = numpy.typing.NDArray[numpy.float64]
Numbers = Union[Sequence[Any], numpy.typing.NDArray[Any]]


class Basis:
    """The principal components of an animation: a frame is mean + weights @ components. It never changes."""

    def __init__(self, handle: Handle) -> None:
        self._handle = made_by(handle, "a basis", "mien.fit_basis, face.fit_basis or mien.read_basis")
        self._info = _library.BasisInfo(size=ctypes.sizeof(_library.BasisInfo))
        call(lib.mien_basis_about, handle.value, self._info)

    @property
    def of_face(self) -> bool:
        """Whether frames are a face's vectors: then `Face.pose` takes it."""
        return bool(self._info.of_face)

    @property
    def fps(self) -> float:
        """Frames per second of a face's."""
        return float(self._info.fps)

    @property
    def begin(self) -> float:
        """When a face's first frame is [s]."""
        return float(self._info.begin)

    @property
    def total_variance(self) -> float:
        """Of all components that there could be."""
        return float(self._info.total_variance)

    def __len__(self) -> int:
        """How many components were kept."""
        return int(self._info.components)

    @property
    def shape(self) -> tuple[int, int, int]:
        """Frames, vertices, dimensions of what it was fitted to; a face's numbers are vertices of one dimension."""
        return int(self._info.frames), int(self._info.vertices), int(self._info.dimensions)

    @property
    def mean(self) -> Array:
        """[vertices, dimensions]"""
        return self._numbers(0, *self.shape[1:])

    @property
    def components(self) -> Array:
        """[n, vertices, dimensions], orthonormal, the largest variance first"""
        return self._numbers(1, len(self), *self.shape[1:])

    @property
    def variances(self) -> Array:
        """[n]"""
        return self._numbers(2, len(self))

    @property
    def weights(self) -> Array:
        """[frames, n], of the frames that it was fitted to"""
        return self._numbers(3, self.shape[0], len(self))

    def _numbers(self, which: int, *shape: int) -> Array:
        values = numpy.empty(shape)
        call(lib.mien_basis_numbers, self._handle.value, which, values.ctypes.data, values.size)
        return values

    @hinted
    def decode(self, weights: Optional[Numbers] = None) -> Array:
        """Frames [F, vertices, dimensions] of weights [F, at most n]; without weights those it was fitted to."""
        rows = numpy.ascontiguousarray(real(self.weights if weights is None else weights, "weights"), numpy.float64)
        if rows.ndim != 2:
            raise Error("weights", f"expected [frames, components], got {rows.ndim} dimensions")
        frames = numpy.empty((len(rows), *self.shape[1:]))
        for row, frame in zip(rows, frames):
            call(lib.mien_basis_decode, self._handle.value, row.ctypes.data, row.size, frame.ctypes.data, frame.size)
        return frames

    @hinted
    def encode(self, frames: Numbers) -> Array:
        """The weights [F, n] of frames [F, vertices, dimensions] or [F, numbers]."""
        rows = numpy.ascontiguousarray(real(frames, "frames"), numpy.float64)
        numbers = self.shape[1] * self.shape[2]
        if rows.ndim < 2 or rows[0:1].size != (numbers if len(rows) else 0):
            raise Error("frames", f"expected frames of {numbers} numbers, got the shape {rows.shape}")
        weights = numpy.empty((len(rows), len(self)))
        call(lib.mien_basis_encode, self._handle.value, rows.ctypes.data, len(rows), weights.ctypes.data, weights.size)
        return weights

    @hinted
    def save(self, path: Path) -> None:
        """Writes a basis file, as `mien pca` and `read_basis` take it."""
        write_whole(path, self._file())

    def _file(self) -> bytes:
        raw = ctypes.create_string_buffer(max(int(lib.mien_basis_file_size(self._handle.value)), 1))
        call(lib.mien_basis_file, self._handle.value, raw, len(raw))
        return raw.raw

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Basis) and self._file() == other._file()

    def __hash__(self) -> int:
        return hash((self.shape, len(self), self.total_variance))

    def __copy__(self) -> Basis:
        return self

    def __deepcopy__(self, memo: object) -> Basis:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _basis_again, (self._file(),)

    def __repr__(self) -> str:
        return f"<mien.Basis: {len(self)} components of {' x '.join(map(str, self.shape))}>"


def _basis_again(raw: bytes) -> Basis:
    with tempfile.TemporaryDirectory(prefix="mien-") as folder:
        file = pathlib.Path(folder, "pickled.basis")
        file.write_bytes(raw)
        return read_basis(file)


@hinted
def read_basis(path: Path) -> Basis:
    """Reads a basis file, of `mien pca fit` or `Basis.save`."""
    with reading(path):
        return Basis(Handle(lib.mien_basis_free, lib.mien_basis_read, *path_bytes(path)))


@hinted
def fit_basis(frames: Numbers, *, components: Optional[int] = None, variance: Optional[float] = None,
              max_error: Optional[float] = None) -> Basis:
    """A basis of frames [F, vertices, dimensions] or [F, numbers]: see `wish` for how many components it has."""
    rows = numpy.ascontiguousarray(real(frames, "frames"), numpy.float64)
    if rows.ndim not in (2, 3):
        raise Error("frames", f"expected [frames, vertices, dimensions] or [frames, numbers], got the shape {rows.shape}")
    count, vertices, dimensions = (*rows.shape, 1)[:3]
    return Basis(Handle(lib.mien_basis_free, lib.mien_basis_of_frames, rows.ctypes.data, count, vertices, dimensions,
                        *wish(components, variance, max_error)))


def wish(components: Optional[int], variance: Optional[float], max_error: Optional[float]) -> tuple[int, float]:
    """One of: so many components; the fewest that hold this share of the variance; the fewest with no larger error."""
    asked = [None if components is None else float(whole(components, "components")), None if variance is None else number(variance, "variance"),
             None if max_error is None else number(max_error, "max_error")]
    given = [(kind, value) for kind, value in enumerate(asked) if value is not None]
    if len(given) != 1:
        raise Error("fit", "expected components, variance or max_error, one of them")
    return given[0]
