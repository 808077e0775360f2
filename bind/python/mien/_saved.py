"""Pictures that are written, and pictures that show themselves."""
from __future__ import annotations

import ctypes
import importlib
import os
import pathlib
import shutil
import tempfile
from typing import IO, Any, Callable, Optional, Union

import numpy
import numpy.typing

from . import _library
from ._errors import Error, Path, writing
from ._kinds import index, number, said, whole
from ._kinds import path as path_of
from ._library import WriteOptions, call, hinted, path_bytes, unknown_name, utf8
from ._picture import Watched, pixels_of
from ._png import png

File = Union[Path, IO[bytes]]
TYPES = {"png": 1, "tif": 2, "tiff": 2, "exr": 3, "jpg": 4, "jpeg": 4}
FILMS = ("gif", "webp", "apng", "mp4", "webm")
# The words of the command for the bits of a channel, and what the library calls them: its type of numbers, and whether floats are halved.
DEPTHS = {None: (-1, 1), 8: (0, 1), 16: (1, 1), "half": (2, 1), "float": (2, 0)}


def format_of(file: File, format: Optional[str]) -> str:
    """A file's format, without the dot: as it is said, or else by the file's name; of a file object without one PNG."""
    if format is not None:
        return format.lstrip(".").lower()
    name = getattr(file, "name", "a.png") if hasattr(file, "write") else path_of(file, "file")
    return pathlib.PurePath(name).suffix[1:].lower() if isinstance(name, str) else "png"


def save(file: File, format: Optional[str], run: Callable[[Path, str], Any]) -> None:
    """Writes by run(path, format): into the path, or through a file of its own into a file object."""
    kind = format_of(file, format)
    if not hasattr(file, "write"):
        with writing(file):
            run(file, kind)
        return
    with tempfile.TemporaryDirectory(prefix="mien-") as folder:
        made = pathlib.Path(folder, "picture." + (kind or "png"))
        run(made, kind)
        with open(made, "rb") as whole_file:
            try:
                shutil.copyfileobj(whole_file, file)  # type: ignore[arg-type]
            except TypeError:
                raise TypeError(f"file: expected one that takes bytes, opened with 'wb', got {said(file)}") from None


def write_whole(path: Path, raw: bytes) -> None:
    """A file that appears whole or not at all, as pictures do."""
    place = pathlib.Path(path)
    if place.exists() and not place.is_file():  # a pipe; a folder is refused
        with writing(place):
            place.write_bytes(raw)
        return
    with writing(place), tempfile.NamedTemporaryFile("wb", dir=place.parent, prefix=".mien-", suffix=".part", delete=False) as file:
        try:
            file.write(raw)
            file.flush()
            os.chmod(file.name, 0o666 & ~_umask())
            os.replace(file.name, place)
        except OSError:
            os.unlink(file.name)
            raise


def _umask() -> int:
    """What new files may not have. Python tells it only by setting it."""
    now = os.umask(0o022)
    os.umask(now)
    return now


def write_options(path: Path, kind: str, depth: Any, threads: int, memory: int, recipe: str, dpi: float, watched: Watched) -> WriteOptions:
    """How a picture is written; refuses formats that hold no picture."""
    if kind in FILMS:
        raise Error(os.fspath(path), f".{kind} is for films: face.animate writes it; of one picture Pillow makes one, to_pil().save(…)")
    if kind not in TYPES:
        raise Error(os.fspath(path), unknown_name("format", kind, [*TYPES, "svg"]) if kind else
                    "its name says no format; known are .png .tif .tiff .exr .jpg .jpeg .svg")
    if isinstance(depth, (list, dict)) or depth not in DEPTHS:
        raise Error("depth", f"expected 8, 16, 'half' or 'float', got {said(depth)}")
    options = WriteOptions()
    _library.image().mien_write_options_init(options, ctypes.sizeof(WriteOptions))
    options.type = TYPES[kind]
    options.depth, options.half = DEPTHS[depth]
    options.threads, options.memory = whole(threads, "threads"), _bytes(memory)
    options.recipe, options.recipe_length = utf8(recipe, "recipe")
    options.progress, options.dpi = watched.function, number(dpi, "dpi")
    return options


def _bytes(memory: Any) -> int:
    """So many bytes; there may be more than an int32 counts."""
    return min(max(index(memory, "memory", "a whole number of bytes"), 0), 2**64 - 1)


def to_pil(pixels: numpy.typing.NDArray[Any]) -> Any:
    """A picture of Pillow's. It keeps 8 bits alone."""
    try:
        image = importlib.import_module("PIL.Image")
    except ImportError:
        raise ImportError("to_pil needs Pillow: pip install pillow, or apt install python3-pil") from None
    return image.fromarray(pixels)


class Picture:
    """A picture that shows itself in a notebook: sheets, and tables as faces."""

    def __init__(self, pixels: numpy.typing.NDArray[numpy.uint8]) -> None:
        if not isinstance(pixels, numpy.ndarray) or pixels.ndim != 3 or pixels.shape[2] != 4 or pixels.dtype != numpy.uint8:
            raise TypeError(f"pixels: expected an array (height, width, 4) of uint8, got {said(pixels)}")
        self.pixels = pixels

    @hinted
    def save(self, file: File, *, format: Optional[str] = None, recipe: str = "", dpi: float = 0) -> None:
        """Writes .png, .tif, .exr or .jpg, by the name or by `format`; into a path or a file object. It appears whole or not at all."""
        def run(path: Path, kind: str) -> None:
            options = write_options(path, kind, None, 0, 0, recipe, dpi, Watched(None))
            pixels = numpy.ascontiguousarray(self.pixels)
            height, width, _ = pixels.shape
            call(_library.image().mien_write_image, pixels_of(pixels), width, height, *path_bytes(path), options)

        save(file, format, run)

    def to_pil(self) -> Any:
        """It as a PIL.Image."""
        return to_pil(self.pixels)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> numpy.typing.NDArray[Any]:
        return numpy.array(self.pixels, dtype=dtype) if copy or dtype is not None else self.pixels

    def _repr_png_(self) -> bytes:
        return png(self.pixels)

    def __repr__(self) -> str:
        return f"<mien.{type(self).__name__}: {self.pixels.shape[1]} x {self.pixels.shape[0]}>"


__all__ = ["File", "Picture", "save", "to_pil", "write_options", "write_whole"]
