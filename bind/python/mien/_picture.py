"""Pictures: views, arrays of pixels, PNG."""
from __future__ import annotations

import ctypes
import threading
from typing import Any, Callable, Generator, NamedTuple, Optional, Sequence, TypeVar, Union

import numpy
import numpy.typing

from ._colors import NAMES, hexadecimal
from ._errors import Error
from ._kinds import listed, number, real, said, text, truth, whole
from ._library import DevicePixels, Handle, Pixels, Progress, RenderOptions, RenderStats, View, call, lib, unknown_name, utf8

Size = Union[int, "tuple[int, int]"]
Color = Union[str, Sequence[float]]
Watch = Callable[[float], Optional[bool]]
_Made = TypeVar("_Made")

DTYPES = [numpy.dtype(one) for one in (numpy.uint8, numpy.uint16, numpy.float32)]  # in the library's order


def choice(value: str, of: Sequence[str], name: str) -> int:
    if not isinstance(value, str) or value not in of:
        raise Error(name, f"expected {', '.join(of[:-1])} or {of[-1]}, got {said(value)}")
    return list(of).index(value)


def sides(size: Size, aspect: float, name: str = "size") -> tuple[int, int]:
    """Width and height; of one number the longer side, the other as the canvas is."""
    if isinstance(size, (tuple, list)):
        if len(size) != 2:
            raise Error(name, f"expected width and height, got {len(size)} numbers")
        return whole(size[0], name), whole(size[1], name)
    longer = whole(size, name)
    if longer < 1:
        raise Error(name, f"expected 1 pixel or more, got {longer}")
    beside = max(1, int(longer * min(aspect, 1 / aspect) + 0.5))
    return (longer, beside) if aspect >= 1 else (beside, longer)


def color(of: Color, name: str = "background") -> list[float]:
    """A colour in linear light: of "transparent", a name of CSS, "#rgb", "#rrggbb", "#rrggbbaa", or 3 or 4 numbers."""
    if isinstance(of, str):
        return _color_of_text(text(of, name), name)
    numbers = real(of, name).ravel()
    if numbers.size not in (3, 4):
        raise Error(name, f"expected 3 or 4 numbers, got {numbers.size}")
    if numbers.dtype.kind in "iu" and numbers.max() > 1:
        raise Error(name, f"numbers are linear light, 0 to 1; of bytes say '#{bytes(numbers.clip(0, 255).astype(numpy.uint8)).hex()}'")
    return [*map(float, numbers), 1.0][:4]


def _color_of_text(words: str, name: str) -> list[float]:
    found = (ctypes.c_double * 4)()
    if words == "transparent":
        return list(found)
    try:
        call(lib.mien_color_from_text, *utf8(hexadecimal(words), name), found)
    except Error as error:
        if words.startswith("#"):
            raise Error(name, f"{error.what}, got {said(words)}") from None
        meant = unknown_name("colour", words, ["transparent", *NAMES])
        raise Error(name, f"{meant}; colours are names, #rrggbb or #rrggbbaa") from None
    return list(found)


def view(aspect: float, size: Size, fit: str = "meet", blend: str = "linear", background: Optional[Color] = None,
         region: Optional[Sequence[int]] = None, light: Optional[Sequence[float]] = None, dither: bool = True,
         legible: float = 0) -> View:
    made = View()
    lib.mien_view_init(made, ctypes.sizeof(View))
    made.width, made.height = sides(size, aspect)
    made.fit, made.blend = choice(fit, ("meet", "slice"), "fit"), choice(blend, ("linear", "srgb"), "blend")
    made.dither, made.legible = truth(dither, "dither"), number(legible, "legible")
    if background is not None:
        made.has_background, made.background = 1, (ctypes.c_double * 4)(*color(background))
    if region is not None:
        region = listed(region, "region", "(x, y, width, height)")
        if len(region) != 4:
            raise Error("region", f"expected x, y, width, height, got {len(region)} numbers")
        made.has_region, made.region = 1, (ctypes.c_int32 * 4)(*[whole(one, "region") for one in region])
    if light is not None:
        lamp = real(listed(light, "light", "(-1, 1, 2)"), "light").ravel()
        if lamp.size != 3:
            raise Error("light", f"expected x, y, z, got {lamp.size} numbers")
        made.has_light, made.light = 1, (ctypes.c_double * 3)(*map(float, lamp))
    return made


class Watched:
    """A progress in Python: what it raises stops the work and is raised again afterwards. Asking also lets Ctrl-C in."""

    def __init__(self, watch: Optional[Watch]) -> None:
        self.raised: Optional[BaseException] = None
        answers = self._answers(watch)
        next(answers)
        self.function = Progress(answers.send)

    def _answers(self, watch: Optional[Watch]) -> Generator[int, float, None]:
        """Whether to stop, by the share done. A generator waits within its try: there Python raises what a signal's
        handler raises, such as KeyboardInterrupt. In a function it is raised before the first line, and is lost."""
        stop = 0
        while True:
            try:
                while True:
                    done = yield stop
                    stop = int(stop or watch is not None and watch(done) is False)
            except GeneratorExit:
                return
            except BaseException as raised:
                self.raised, stop = self.raised or raised, 1

    def options(self, threads: int = 0) -> RenderOptions:
        """Those of drawing that ask."""
        options = RenderOptions()
        lib.mien_render_options_init(options, ctypes.sizeof(RenderOptions))
        options.threads, options.progress = whole(threads, "threads"), self.function
        return options

    def run(self, work: Callable[..., _Made], *arguments: Any) -> _Made:
        """What the work returns."""
        try:
            made = work(*arguments)
            if self.raised is None:
                return made
        except Error:
            if self.raised is None:
                raise
        raise self.raised from None


def dtype_of(given: Any) -> numpy.dtype[Any]:
    """The type of a picture's numbers: numpy.uint8, numpy.uint16, numpy.float32, or their names."""
    try:
        found = numpy.dtype(given)
    except (TypeError, ValueError):
        found = None
    if given is None or found not in DTYPES:
        raise Error("dtype", f"expected uint8, uint16 or float32, got {said(given)}")
    return found


def array_for(seen: View, dtype: numpy.dtype[Any], out: Optional[numpy.typing.NDArray[Any]]) -> numpy.typing.NDArray[Any]:
    """The array that is drawn into: `out`, if it can hold the picture, or a new one."""
    rect = (ctypes.c_int32 * 4)()
    call(lib.mien_drawn_rect, seen, rect)
    shape = (max(rect[3], 0), max(rect[2], 0), 4)
    if out is None:
        try:
            return numpy.empty(shape, dtype)
        except (MemoryError, ValueError) as failure:
            raise MemoryError(str(failure)) from None
    if not isinstance(out, numpy.ndarray):
        raise TypeError(f"out: expected an array, got {type(out).__name__}")
    if out.dtype != dtype or not out.dtype.isnative:
        raise TypeError(f"out: expected {dtype}, got {out.dtype}")
    if out.shape != shape:
        raise Error("out", f"its shape is {out.shape}, and the picture's {shape}")
    if not out.flags.writeable:
        raise Error("out", "is read-only")
    item = dtype.itemsize
    if out.size and (out.strides[1:] != (4 * item, item) or out.strides[0] < 4 * item * shape[1] and shape[0] > 1
                     or not out.flags.aligned):
        raise Error("out", "its rows are not in order: pixels of a row lie side by side, rows below each other")
    return out


class Stats(NamedTuple):
    """The work that a picture took."""

    pixels: int           # drawn
    fill_pixels: int      # in runs of one colour
    varied_pixels: int    # in runs of a colour that varies
    edge_pixels: int      # crossed by visible outlines
    resolved_pixels: int  # those of them resolved by distances, because nothing else was proven
    recalled_pixels: int  # copied from the frame before
    pieces: int           # pieces of outline
    crossings: int        # of those pieces with each other
    regions: int          # different sets of outlines that places are inside of
    doubts: int           # places where the order of outlines could not be proven
    roots: int            # solved, where visible pieces meet rows and columns of pixels
    distances: int        # solved for light and for gradients along a distance
    root_seconds: float   # time of the roots, over all threads
    distance_seconds: float
    steps: int            # of work, which docs/limits.md tells of
    memory: int           # bytes that outlines, their order and regions held at most
    cancelled: bool


def pixels_of(array: numpy.typing.NDArray[Any]) -> Pixels:
    """An array of array_for as the library takes it."""
    pixels = Pixels()
    lib.mien_pixels_init(pixels, ctypes.sizeof(Pixels))
    row = array.shape[1] * 4 * array.itemsize
    pixels.depth, pixels.data = DTYPES.index(array.dtype), array.ctypes.data
    pixels.stride = array.strides[0] if array.shape[0] > 1 else row
    pixels.bytes = pixels.stride * max(array.shape[0] - 1, 0) + row
    return pixels


DEVICE_FORMATS = {"rgb565": numpy.uint16, "rgb565_swapped": numpy.uint16, "bgrx": numpy.uint8, "mono": numpy.uint8}


def device_picture(scene: Any, seen: View, name: str, threads: int, progress: Optional[Watch]) -> numpy.typing.NDArray[Any]:
    """A scene as rows for a display."""
    kind, rect = choice(name, (*DEVICE_FORMATS,), "format"), (ctypes.c_int32 * 4)()
    call(lib.mien_drawn_rect, seen, rect)
    width, height = rect[2], rect[3]
    shape = {"bgrx": (height, width, 4), "mono": (height, (width + 7) // 8)}.get(name, (height, width))
    array, watched = numpy.zeros(shape, DEVICE_FORMATS[name]), Watched(progress)
    pixels = DevicePixels()
    lib.mien_device_pixels_init(pixels, ctypes.sizeof(DevicePixels))
    pixels.format, pixels.data, pixels.bytes = kind, array.ctypes.data, array.nbytes
    pixels.stride = array.strides[0]
    watched.run(call, lib.mien_render_for_device, scene, seen, pixels, watched.options(threads))
    return array


def debug_picture(scene: Any, seen: View, which: int, threads: int, progress: Optional[Watch]) -> numpy.typing.NDArray[Any]:
    """How a scene is drawn, as a picture."""
    array, watched = array_for(seen, DTYPES[0], None), Watched(progress)
    watched.run(call, lib.mien_debug_picture, scene, seen, which, pixels_of(array), watched.options(threads))
    return array


def effects_of(texts: Sequence[str]) -> Handle:
    """Effects by their texts, in order."""
    made = Handle(lib.mien_effects_free, lib.mien_effects_new)
    for one in listed(texts, "effects", '["mosaic:24,0.3"]'):
        call(lib.mien_effects_add, made.value, *utf8(one, "effects"))
    return made


class Renderer:
    """Draws frame after frame: it keeps memory and finished rows. The pixels are those of `Posed.render`."""

    def __init__(self) -> None:
        self._handle = Handle(lib.mien_renderer_free, lib.mien_renderer_new)
        self._lock = threading.Lock()  # it draws one picture at a time

    def __reduce__(self) -> tuple[Any, ...]:
        return Renderer, ()  # what it keeps changes no pixel

    @property
    def stats(self) -> Stats:
        """The work that the last picture took; all 0 before the first."""
        raw = RenderStats(size=ctypes.sizeof(RenderStats))
        with self._lock:
            call(lib.mien_renderer_stats, self._handle.value, raw)
        fields = {name: getattr(raw, name) for name in Stats._fields}
        return Stats(**{**fields, "cancelled": bool(raw.cancelled)})

    def _render(self, scene: Any, seen: View, dtype: Any, threads: int, out: Optional[numpy.typing.NDArray[Any]],
                progress: Optional[Watch], effects: Optional[Handle] = None) -> numpy.typing.NDArray[Any]:
        array = array_for(seen, dtype_of(dtype), out)
        pixels, watched = pixels_of(array), Watched(progress)
        options = watched.options(threads)
        with self._lock:
            if effects is None:
                watched.run(call, lib.mien_render, self._handle.value, scene, seen, pixels, options)
            else:
                watched.run(call, lib.mien_render_with_effects, self._handle.value, scene, seen, effects.value, pixels, options)
        return array
