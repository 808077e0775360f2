"""Posed faces."""
from __future__ import annotations

import ctypes
import threading
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence, Union

import numpy
import numpy.typing

from . import _library
from ._errors import Error, Path
from ._kinds import number, said, whole
from ._library import Handle, call, hinted, hinted_with, lib, made_by, parameters_of, path_bytes, text, texts, utf8
from ._picture import Color, Renderer, Size, Watch, Watched, choice, debug_picture, device_picture, effects_of, view
from ._png import png
from ._saved import File, save, to_pil, write_options, write_whole

if TYPE_CHECKING:
    from ._face import Face

DRAWN = ("outlines", "regions", "fragments", "looks", "distance", "normals")  # pictures of how a face is drawn
MOVED = ("muscles", "points", "morph")                                        # and of what moves it
SHOWN_IN_NOTEBOOKS = 400  # [px] the longer side


class Svg(NamedTuple):
    """A face as an SVG file."""

    text: str
    simplified: tuple[str, ...]  # what SVG cannot say, a sentence each with the layer's name

    def _repr_svg_(self) -> str:
        return self.text


class Posed:
    """A face at a pose. A notebook shows it."""

    def __init__(self, face: Face, pose: Handle, asked: Mapping[str, Any]) -> None:
        self.face = face
        self._pose = made_by(pose, "a posed face", "face.pose")
        self._asked = dict(asked)  # what Face.pose was given
        self._scene: Optional[Handle] = None
        self._lock = threading.Lock()  # a pose is used by one thread at a time

    @property
    def _drawn(self) -> Any:
        with self._lock:
            if self._scene is None:
                self._scene = Handle(lib.mien_scene_free, lib.mien_scene_new, self._pose.value)
            return self._scene.value

    @property
    def vector(self) -> numpy.typing.NDArray[numpy.float64]:
        """All numbers of the posed face."""
        numbers = numpy.empty(lib.mien_face_vector_size(self.face._handle.value))
        with self._lock:
            call(lib.mien_pose_vector, self._pose.value, numbers.ctypes.data, numbers.size)
        return numbers

    @hinted
    def render(self, size: Size = 1024, *, fit: str = "meet", blend: str = "linear", dtype: Any = "uint8",
               background: Optional[Color] = None, region: Optional[Sequence[int]] = None,
               light: Optional[Sequence[float]] = None, dither: bool = True, legible: float = 0, threads: int = 0,
               out: Optional[numpy.typing.NDArray[Any]] = None, progress: Optional[Watch] = None,
               renderer: Optional[Renderer] = None, effects: Union[Sequence[str], bool] = ()) -> numpy.typing.NDArray[Any]:
        """The picture: an array (height, width, 4) of red, green, blue, alpha.

        size        (width, height), or the longer side; the other then follows the canvas
        dtype       numpy.uint8 and uint16: sRGB-encoded, straight alpha; float32: linear light, premultiplied
        fit         "meet": all of the canvas; "slice": all of the picture
        blend       "linear" or "srgb": where colours are mixed
        background  "white" or another name of CSS, "#rrggbb", "#rrggbbaa", "transparent", or linear red, green, blue, alpha
        region      x, y, width, height: draws only this part, with the same pixels
        light       x, y, z: the direction to the lamp that lights reliefs
        legible     pixels, 0 to 16: lines are at least so wide, for small pictures
        threads     0: all. It does not change a bit
        out         an array to draw into; its rows may lie apart
        progress    called with the share done; returning False stops, and Cancelled is raised
        renderer    keeps memory and finished rows between frames
        effects     on the finished picture, in order: ["mosaic:24,0.3", "grid:12"]; True: those of the face's file
        """
        seen = view(self.face.canvas.aspect, size, fit, blend, background, region, light, dither, legible)
        if renderer is not None and not isinstance(renderer, Renderer):
            raise TypeError(f"renderer: expected a mien.Renderer, got {said(renderer)}")
        return (renderer or Renderer())._render(self._drawn, seen, dtype, threads, out, progress, self._effects(effects))

    @hinted
    def for_device(self, format: str, size: Size = 240, *, fit: str = "meet", blend: str = "linear",
                   background: Optional[Color] = None, region: Optional[Sequence[int]] = None,
                   light: Optional[Sequence[float]] = None, dither: bool = True, legible: float = 0, threads: int = 0,
                   progress: Optional[Watch] = None) -> numpy.typing.NDArray[Any]:
        """The picture as a small display's memory holds it, without alpha: what is open is black.

        format      "rgb565": (height, width) of uint16; "rgb565_swapped": the same with its bytes exchanged, as most displays
                    on a serial bus want it; "bgrx": (height, width, 4) of uint8; "mono": (height, width / 8) of uint8, a bit a
                    pixel, 1 for white, the leftmost uppermost
        dither      by rows and columns of 8 × 8 pixels, whose mean is right; else each pixel is rounded
        The rest is as in `render`.
        """
        seen = view(self.face.canvas.aspect, size, fit, blend, background, region, light, dither, legible)
        return device_picture(self._drawn, seen, format, threads, progress)

    @hinted
    def debug(self, which: str, size: Size = 1024, *, fit: str = "meet", background: Optional[Color] = None,
              region: Optional[Sequence[int]] = None, threads: int = 0,
              progress: Optional[Watch] = None) -> numpy.typing.NDArray[Any]:
        """A picture of how the face is drawn, "outlines", "regions", "fragments", "looks", "distance" or "normals", or of
        what moves it, "muscles", "points" or "morph", without names: as `mien render --debug`."""
        kind = choice(which, (*DRAWN, *MOVED), "which")
        seen = view(self.face.canvas.aspect, size, fit, background=background, region=region)
        if which in DRAWN:
            return debug_picture(self._drawn, seen, kind, threads, progress)
        with self._lock:
            scene = Handle(lib.mien_scene_free, lib.mien_scene_debug, self._pose.value, kind - len(DRAWN))
        return Renderer()._render(scene.value, seen, "uint8", threads, None, progress)

    @hinted
    def svg(self, size: Size = 1024, *, fit: str = "meet", background: Optional[Color] = None, tolerance: float = 0.006,
            legible: float = 0, id_prefix: Optional[str] = None, progress: Optional[Watch] = None) -> Svg:
        """The face as an SVG file: paths that leave the outlines by `tolerance` [px] at most, 1e-4 to 1.

        Colours are mixed as SVG viewers do, as with blend="srgb". `id_prefix` begins all ids, so that several pictures can
        stand in one page; without one it is made of the picture, so that only equal pictures share ids. `progress` is as
        for `render`.
        """
        seen = view(self.face.canvas.aspect, size, fit, background=background, legible=legible)
        if not tolerance > 0:
            raise Error("tolerance", f"expected a number from 1e-4 to 1, got {tolerance!r}")
        prefix = (None, 0) if id_prefix is None else utf8(id_prefix, "id_prefix")
        watched = Watched(progress)
        file, *simplified = watched.run(texts, lib.mien_svg, self._drawn, seen, float(tolerance), *prefix, watched.options())
        return Svg(file, tuple(simplified))

    def _effects(self, asked: Union[Sequence[str], bool]) -> Optional[Handle]:
        if asked is True:
            return Handle(lib.mien_effects_free, lib.mien_effects_of_face, self.face._handle.value)
        return None if asked is False or asked == () else effects_of(asked)

    @hinted
    def save(self, file: File, size: Size = 1024, *, format: Optional[str] = None, fit: str = "meet", blend: str = "linear",
             depth: Union[int, str, None] = None, background: Optional[Color] = None, region: Optional[Sequence[int]] = None,
             light: Optional[Sequence[float]] = None, dither: bool = True, legible: float = 0, threads: int = 0, memory: int = 256 << 20,
             recipe: str = "", dpi: float = 0, progress: Optional[Watch] = None) -> None:
        """Draws into a file, .png, .tif, .exr, .jpg or .svg, at any size, piece by piece in so many bytes of memory. It appears
        whole or not at all.

        file    a path, or a file object that takes bytes
        format  "png" …, where the file's name does not say it
        depth   bits of a channel: 8, 16, "half" or "float"; default the format's first
        recipe  goes into the picture's metadata
        dpi     pixels per inch: how large it is on paper
        """
        def run(path: Path, kind: str) -> None:
            if kind == "svg":
                write_whole(path, self.svg(size, fit=fit, background=background, legible=legible,
                                           progress=progress).text.encode())
                return
            seen = view(self.face.canvas.aspect, size, fit, blend, background, region, light, dither, legible)
            watched = Watched(progress)
            options = write_options(path, kind, depth, threads, memory, recipe, dpi, watched)
            watched.run(call, _library.image().mien_write_picture, self._drawn, seen, *path_bytes(path), options)

        save(file, format, run)

    @hinted_with(parameters_of(render))
    def to_pil(self, size: Size = 1024, **how: Any) -> Any:
        """The picture as a PIL.Image, of mode RGBA; `how` is as for `render`."""
        return to_pil(self.render(size, **how))

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> numpy.typing.NDArray[Any]:
        """The picture, so that numpy.asarray and plt.imshow take a face; `render` has what can be chosen."""
        pixels = self.render()
        return pixels if dtype is None else pixels.astype(dtype)

    @property
    def layers(self) -> tuple[str, ...]:
        """The names of what is drawn, from the bottom to the top."""
        scene = self._drawn
        return tuple(text(lib.mien_scene_layer_name(scene, i)) for i in range(lib.mien_scene_layer_count(scene)))

    @hinted
    def layer_at(self, x: float, y: float) -> Optional[str]:
        """The topmost layer at a point [face units]."""
        found, scene = ctypes.c_int32(), self._drawn
        call(lib.mien_scene_layer_at, scene, float(x), float(y), ctypes.byref(found))
        return text(lib.mien_scene_layer_name(scene, found.value)) if found.value >= 0 else None

    @hinted
    def feature_at(self, x: float, y: float) -> Optional[str]:
        """The feature that is seen at a point [face units]: not its shadow or outline, and nothing transparent."""
        found = texts(lib.mien_scene_feature_at, self._drawn, float(x), float(y))
        return found[0] if found else None

    @hinted
    def distance(self, layer: Union[str, int], x: float, y: float) -> float:
        """The signed distance to a layer's outline, negative inside [face units]."""
        index = layer
        if isinstance(index, str):
            if index not in self.layers:
                raise Error("layer", f"there is no layer {said(index)}")
            index = self.layers.index(index)
        found = ctypes.c_double()
        call(lib.mien_scene_distance, self._drawn, whole(index, "layer"), float(x), float(y), ctypes.byref(found))
        return found.value

    @hinted
    def face_from_pixel(self, x: float, y: float, size: Size = 1024, fit: str = "meet") -> tuple[float, float]:
        """Where a point of the picture [px] is in the face [face units]."""
        found = (ctypes.c_double * 2)()
        call(lib.mien_face_from_pixel, self._drawn, view(self.face.canvas.aspect, size, fit), float(x), float(y), found)
        return found[0], found[1]

    @hinted
    def pixel_from_face(self, x: float, y: float, size: Size = 1024, fit: str = "meet") -> tuple[float, float]:
        """Where a point of the face [face units] is in the picture [px]."""
        found = (ctypes.c_double * 2)()
        call(lib.mien_pixel_from_face, self._drawn, view(self.face.canvas.aspect, size, fit), float(x), float(y), found)
        return found[0], found[1]

    @property
    def scene(self) -> str:
        """The shapes and layers as text, one a line."""
        return texts(lib.mien_scene_text, self._drawn)[0]

    def __eq__(self, other: object) -> bool:
        """Whether both are drawn with the same shapes."""
        return isinstance(other, Posed) and self.face.canvas == other.face.canvas and self.scene == other.scene

    def __hash__(self) -> int:
        return hash(self.scene)

    def __copy__(self) -> Posed:
        return self

    def __deepcopy__(self, memo: object) -> Posed:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        if "steady" in self._asked:
            raise TypeError("a face that follows a live camera cannot be pickled: its filter remembers the frames before")
        return _posed_again, (self.face, self._asked)

    def _drawn_png(self, size: Size) -> bytes:
        return png(self.render(size))

    def _repr_png_(self) -> bytes:
        return self._drawn_png(SHOWN_IN_NOTEBOOKS)

    def __repr__(self) -> str:
        how = ", ".join(f"{name}={said(value)}" for name, value in self._asked.items())
        return f"<mien.Posed {self.face.title or 'without a name'}: {how or 'at rest'}>"


def _posed_again(face: Face, asked: Mapping[str, Any]) -> Posed:
    return face.pose(**asked)


# What `how` of a sheet, of frames and of a film takes.
HOW = parameters_of(Posed.render, "size", "dtype", "out", "progress", "renderer")
