"""Faces and posed faces."""
from __future__ import annotations

import ctypes
import json
import os
import threading
from types import MappingProxyType
from typing import Any, Callable, Iterator, Mapping, NamedTuple, Optional, Sequence, Union

import numpy
import numpy.typing

from . import _library
from ._library import Handle, NameRecord, WriteOptions, call, hinted, lib, path_bytes, text, texts, utf8
from ._basis import Basis, wish
from ._motion import Motion, Steady
from ._picture import Color, Renderer, Size, Watch, Watched, choice, debug_picture, effects_of, png, view, whole

Value = Union[str, float, Sequence[float], numpy.typing.NDArray[Any]]
ClipLike = Union[str, "tuple[str, float]", "tuple[str, float, float]"]
MotionLike = Union[Motion, "tuple[Motion, float]", "tuple[Motion, float, float]"]
DRAWN = ("outlines", "regions", "fragments", "looks", "distance", "normals")  # pictures of how a face is drawn
MOVED = ("muscles", "points", "morph")                                        # and of what moves it
UNWRAP_MODES = ("linear", "delayed", "sine")
SHOWN_IN_NOTEBOOKS = 400  # [px] the longer side


class Svg(NamedTuple):
    """A face as an SVG file."""

    text: str
    simplified: tuple[str, ...]  # what SVG cannot say, a sentence each with the layer's name


class EditedText(NamedTuple):
    """A face file with other values."""

    text: str
    left: tuple[str, ...]  # names that the file cannot hold


class Canvas(NamedTuple):
    """What a picture of a face shows [face units]."""

    box: tuple[float, float, float, float]  # x0, y0, x1, y1
    y_up: bool
    mirror_x: float
    unit: str

    @property
    def aspect(self) -> float:
        return (self.box[2] - self.box[0]) / (self.box[3] - self.box[1])


class Name(NamedTuple):
    """Something that can be set."""

    name: str
    unit: str
    range: tuple[float, float]
    value: Union[float, tuple[float, ...]]  # at rest
    is_control: bool  # else a slice of the face's numbers
    is_pose: bool     # a control that is the weight of a pose
    begin: int        # a slice: where its numbers begin in the vector; a control: -1


class Face:
    """A face at rest. It never changes: threads may share it."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle
        self._names: Optional[Mapping[str, Name]] = None

    @property
    def title(self) -> str:
        """The name that its file gives it; may be empty."""
        return text(lib.mien_face_title(self._handle.value))

    @property
    def credit(self) -> str:
        """Whom its file credits; may be empty."""
        return text(lib.mien_face_credit(self._handle.value))

    @property
    def canvas(self) -> Canvas:
        raw = _library.Canvas(size=ctypes.sizeof(_library.Canvas))
        call(lib.mien_face_canvas, self._handle.value, raw)
        x0, y0, x1, y1 = raw.box
        return Canvas((x0, y0, x1, y1), bool(raw.y_up), raw.mirror_x, text(raw.unit))

    @property
    def names(self) -> Mapping[str, Name]:
        """Everything that can be set, by name: controls first, then slices in the vector's order."""
        if self._names is None:
            count = lib.mien_face_name_count(self._handle.value)
            self._names = MappingProxyType({one.name: one for one in map(self._name, range(count))})
        return self._names

    def _name(self, index: int) -> Name:
        raw = NameRecord(size=ctypes.sizeof(NameRecord))
        call(lib.mien_face_name_at, self._handle.value, index, raw)
        numbers = (ctypes.c_double * raw.count)()
        call(lib.mien_face_values_at, self._handle.value, index, numbers, raw.count)
        value = numbers[0] if raw.count == 1 else tuple(numbers)
        return Name(text(raw.name), text(raw.unit), (raw.lo, raw.hi), value, bool(raw.is_control), bool(raw.is_pose),
                    raw.begin)

    @property
    def clips(self) -> tuple[str, ...]:
        """The names of the clips that it can run."""
        count = lib.mien_face_clip_count(self._handle.value)
        return tuple(text(lib.mien_face_clip_name(self._handle.value, i)) for i in range(count))

    @property
    def clip_lengths(self) -> Mapping[str, float]:
        """How long each clip is [s]: from then on it repeats, or rests; infinite where it never does."""
        return MappingProxyType({name: lib.mien_face_clip_length(self._handle.value, i) for i, name in enumerate(self.clips)})

    @property
    def emotions(self) -> tuple[str, ...]:
        """The emotions that it can show, without their halves."""
        return tuple(name[8:] for name in self.names if name.startswith("emotion.") and name.count(".") == 1)

    @property
    def vector(self) -> numpy.typing.NDArray[numpy.float64]:
        """All its numbers, at rest."""
        return self.pose().vector

    @hinted
    def pose(self, *, time: Optional[float] = None, set: Optional[Mapping[str, Value]] = None,
             emotions: Optional[Mapping[str, float]] = None,
             expressions: Optional[Mapping[str, Mapping[str, float]]] = None, clips: Sequence[ClipLike] = (),
             look_at: Optional[Sequence[float]] = None, unwrap: float = 0, unwrap_mode: str = "linear",
             clamp: bool = False, basis: Optional[Basis] = None, weights: Optional[Sequence[float]] = None,
             seed: Union[str, int, None] = None, liveliness: float = 1, gestures: float = 1,
             motions: Sequence[MotionLike] = (),
             frame: Union[str, Mapping[str, Any], Sequence[Any], None] = None,
             steady: Optional[tuple[Steady, float]] = None) -> Posed:
        """The face at that pose.

        time         [s] at which clips are taken; without one none runs
        set          values by name (`Face.names`); a colour may be "#rrggbb". They beat everything else
        emotions     strengths by name, 0 to 1: {"joy": 0.8, "left.surprise": 0.3}
        expressions  strengths of other sets: {"arkit": {"jawOpen": 0.5}}
        clips        names, or (name, weight), or (name, weight, begin [s]); each acts on those before it
        look_at      x, y, z that the eyes look at [face units], z towards the viewer
        unwrap       0 to 1: how far the features have travelled to a flat chart, by `unwrap_mode`
        clamp        strengths out of range become the nearer end instead of an error
        basis        whose vector replaces that at rest: of its `weights`, or without any of those at `time`
        seed         a word instead of the face's own code, recipe or text, for blinks and glances by chance
        liveliness   0 to 2: how far clips move the face; 1 as they say, 0 not at all
        gestures     0 to 2: how far the head nods and brows rise with the stresses of speech; 0: the mouth alone speaks
        motions      takes and speech (`read_motion`), or (motion, weight), or (motion, weight, begin [s]), on top of clips
        frame        what a camera saw: ARKit's shapes by name, a result of MediaPipe, or its JSON; it beats motions
        steady       of frames that come live: what keeps them quiet, and the frame's moment [s]
        """
        made = Handle(lib.mien_pose_free, lib.mien_pose_new, self._handle.value)
        pose = made.value
        if time is not None:
            call(lib.mien_pose_time, pose, float(time))
        for clip in clips:
            call(lib.mien_pose_clip, pose, *utf8(_clip_text(clip)))
        for motion in motions:
            of, weight, begin = _motion_layer(motion)
            call(lib.mien_pose_motion, pose, of._handle.value, weight, begin)
        if frame is not None:
            seen = utf8(frame if isinstance(frame, str) else json.dumps(frame))
            if steady is None:
                call(lib.mien_pose_follow, pose, *seen)
            else:
                call(lib.mien_pose_follow_steadily, pose, steady[0]._handle.value, float(steady[1]), *seen)
        if seed is not None:
            call(lib.mien_pose_seed, pose, *utf8(str(seed)))
        if liveliness != 1:
            call(lib.mien_pose_liveliness, pose, float(liveliness))
        if gestures != 1:
            call(lib.mien_pose_gestures, pose, float(gestures))
        if look_at is not None:
            if len(look_at) != 3:
                raise _library.Error("look_at", f"expected x, y, z, got {len(look_at)} numbers")
            call(lib.mien_pose_look_at, pose, *[float(one) for one in look_at])
        if unwrap or unwrap_mode != "linear":
            call(lib.mien_pose_unwrap, pose, float(unwrap), choice(unwrap_mode, UNWRAP_MODES, "unwrap_mode"))
        for kind, strengths in [*(expressions or {}).items(), ("emotion", emotions or {})]:
            for name, strength in strengths.items():
                call(lib.mien_pose_express, pose, *utf8(kind), *utf8(f"{name}={float(strength)!r}"), clamp)
        for name, value in (set or {}).items():
            call(lib.mien_pose_set, pose, *utf8(f"{name}={_value_text(value)}"))
        if basis is not None:
            held = numpy.ascontiguousarray(() if weights is None else weights, numpy.float64).ravel()
            call(lib.mien_pose_basis, pose, basis._handle.value, held.ctypes.data, held.size)
        elif weights is not None:
            raise _library.Error("weights", "are those of a basis")
        return Posed(self, made)

    def speak(self, track: Motion, time: float, **pose: Any) -> Posed:
        """The face at a moment of a track of speech, or of a take [s]: what sounds then. `pose` has further arguments of
        `Face.pose`; without `clips` the face's first one runs below."""
        clips = pose.pop("clips", self.clips[:1])
        return self.pose(time=time, clips=clips, motions=[track], **pose)

    def follow(self, frame: Union[str, Mapping[str, Any], Sequence[Any]], **pose: Any) -> Posed:
        """The face as a camera saw an actor's: ARKit's shapes by name, a result of MediaPipe, or its JSON. `steady` is
        (Steady(), the frame's moment [s]) for frames that come live."""
        return self.pose(frame=frame, **pose)

    def unfollowed(self, motion: Motion) -> tuple[str, ...]:
        """The names of what moves in a motion and not in this face."""
        return tuple(texts(lib.mien_motion_unfollowed, motion._handle.value, self._handle.value))

    def fit_basis(self, count: int, *, fps: float = 30, first: int = 0, components: Optional[int] = None,
                  variance: Optional[float] = None, max_error: Optional[float] = None, **pose: Any) -> Basis:
        """A basis of `count` frames of the face, at first / fps, (first + 1) / fps ... seconds, as `mien pca fit` makes it.

        One of: so many `components`; the fewest that hold this share of the `variance`; the fewest with no larger `max_error`
        of any number [face units; levels of 255 for colours]. `pose` has further arguments of `Face.pose`.
        """
        if (frames := whole(count, "count")) < 1:
            raise _library.Error("count", "expected 1 frame or more")
        posed = self.pose(**pose)
        return Basis(Handle(lib.mien_basis_free, lib.mien_basis_of_pose, posed._pose.value, whole(first, "first"), frames, float(fps),
                            *wish(components, variance, max_error)))

    def render(self, size: Size = 1024, **how: Any) -> numpy.typing.NDArray[Any]:
        """The picture at rest: see `Posed.render`."""
        return self.pose().render(size, **how)

    def frames(self, count: int, size: Size = 1024, *, fps: float = 30, begin: float = 0,
               pose: Union[Mapping[str, Any], Callable[[float], Mapping[str, Any]], None] = None,
               **how: Any) -> Iterator[numpy.typing.NDArray[Any]]:
        """The pictures of an animation, one after another, by one renderer.

        `pose` has the arguments of `Face.pose`, or is a function that gives them for a time; without a `time` of
        its own each frame has that of its number. `how` is as for `Posed.render`.
        """
        renderer = Renderer()
        for frame in range(count):
            time = begin + frame / fps
            asked: dict[str, Any] = {"time": time, **((pose(time) if callable(pose) else pose) or {})}
            yield self.pose(**asked).render(size, renderer=renderer, **how)

    def with_morphs(self, path: "str | os.PathLike[str]") -> Face:
        """The face with the morph targets of a file: further names, whose weights `set` holds."""
        return Face(Handle(lib.mien_face_free, lib.mien_face_with_morphs, self._handle.value, *path_bytes(path)))

    def with_morphs_text(self, words: Union[str, bytes], name: str = "morphs") -> Face:
        """The same from memory; `name` stands for the file's name in errors."""
        raw = words if isinstance(words, bytes) else utf8(words)[0]
        return Face(Handle(lib.mien_face_free, lib.mien_face_with_morphs_text, self._handle.value, raw, len(raw), *utf8(name)))

    def morphs_text(self, shapes: Mapping[str, Face]) -> str:
        """The text of a file of morph targets: the same face, slice for slice, in other shapes, by name."""
        names = (ctypes.c_char_p * len(shapes))(*(utf8(name)[0] for name in shapes))
        faces = (ctypes.c_void_p * len(shapes))(*(face._handle.value.value for face in shapes.values()))
        return texts(lib.mien_morphs_text, self._handle.value, names, faces, len(shapes))[0]

    def _repr_png_(self) -> bytes:
        return self.pose()._repr_png_()

    def __repr__(self) -> str:
        return f"<mien.Face {self.title or 'without a name'}: {len(self.names)} names>"


class Posed:
    """A face at a pose. A notebook shows it."""

    def __init__(self, face: Face, pose: Handle) -> None:
        self.face = face
        self._pose = pose
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
    def render(self, size: Size = 1024, *, fit: str = "meet", blend: str = "linear", depth: str = "u8",
               background: Optional[Color] = None, region: Optional[Sequence[int]] = None,
               light: Optional[Sequence[float]] = None, dither: bool = True, threads: int = 0,
               out: Optional[numpy.typing.NDArray[Any]] = None, progress: Optional[Watch] = None,
               renderer: Optional[Renderer] = None, effects: Union[Sequence[str], bool] = ()) -> numpy.typing.NDArray[Any]:
        """The picture: an array (height, width, 4) of red, green, blue, alpha.

        size        (width, height), or the longer side; the other then follows the canvas
        depth       "u8" and "u16": sRGB-encoded, straight alpha; "f32": linear light, premultiplied
        fit         "meet": all of the canvas; "slice": all of the picture
        blend       "linear" or "srgb": where colours are mixed
        background  "#rrggbb", "#rrggbbaa", "transparent", or linear red, green, blue, alpha
        region      x, y, width, height: draws only this part, with the same pixels
        light       x, y, z: the direction to the lamp that lights reliefs
        threads     0: all. It does not change a bit
        out         an array to draw into; its rows may lie apart
        progress    called with the share done; returning False stops, and Cancelled is raised
        renderer    keeps memory and finished rows between frames
        effects     on the finished picture, in order: ["mosaic:24,0.3", "grid:12"]; True: those of the face's file
        """
        seen = view(self.face.canvas.aspect, size, fit, blend, background, region, light, dither)
        return (renderer or Renderer())._render(self._drawn, seen, depth, threads, out, progress, self._effects(effects))

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
        return Renderer()._render(scene.value, seen, "u8", threads, None, progress)

    def svg(self, size: Size = 1024, *, fit: str = "meet", background: Optional[Color] = None, tolerance: float = 0.01,
            id_prefix: Optional[str] = None, progress: Optional[Watch] = None) -> Svg:
        """The face as an SVG file: paths that leave the outlines by `tolerance` [px] at most, 1e-4 to 1.

        Colours are mixed as SVG viewers do, as with blend="srgb". `id_prefix` begins all ids, so that several pictures can
        stand in one page; without one it is made of the picture, so that only equal pictures share ids. `progress` is as
        for `render`.
        """
        seen = view(self.face.canvas.aspect, size, fit, background=background)
        if not tolerance > 0:
            raise _library.Error("tolerance", f"expected a number from 1e-4 to 1, got {tolerance!r}")
        prefix = (None, 0) if id_prefix is None else utf8(id_prefix)
        watched = Watched(progress)
        file, *simplified = watched.run(texts, lib.mien_svg, self._drawn, seen, float(tolerance), *prefix, watched.options())
        return Svg(file, tuple(simplified))

    def _effects(self, asked: Union[Sequence[str], bool]) -> Optional[Handle]:
        if asked is True:
            return Handle(lib.mien_effects_free, lib.mien_effects_of_face, self.face._handle.value)
        return effects_of(asked) if asked else None

    @hinted
    def save(self, path: "str | os.PathLike[str]", size: Size = 1024, *, fit: str = "meet", blend: str = "linear",
             depth: Optional[str] = None, background: Optional[Color] = None, region: Optional[Sequence[int]] = None,
             light: Optional[Sequence[float]] = None, dither: bool = True, threads: int = 0, memory: int = 256 << 20,
             recipe: str = "", dpi: float = 0, progress: Optional[Watch] = None) -> None:
        """Draws into a file, .png, .tif, .exr or .jpg, at any size, piece by piece in so many bytes of memory. It appears whole
        or not at all. `recipe` goes into its metadata; `dpi`, pixels per inch, says how large it is on paper."""
        library = _library.image()
        seen = view(self.face.canvas.aspect, size, fit, blend, background, region, light, dither)
        options, watched = WriteOptions(), Watched(progress)
        library.mien_write_options_init(options, ctypes.sizeof(WriteOptions))
        options.depth = -1 if depth is None else choice(depth, ("u8", "u16", "f32"), "depth")
        options.half = depth is None
        options.threads, options.memory = whole(threads, "threads"), min(max(memory, 0), 2**64 - 1)
        options.recipe, options.recipe_length = utf8(recipe)
        options.progress, options.dpi = watched.function, float(dpi)
        watched.run(call, library.mien_write_picture, self._drawn, seen, *path_bytes(path), options)

    @property
    def layers(self) -> tuple[str, ...]:
        """The names of what is drawn, from the bottom to the top."""
        scene = self._drawn
        return tuple(text(lib.mien_scene_layer_name(scene, i)) for i in range(lib.mien_scene_layer_count(scene)))

    def layer_at(self, x: float, y: float) -> Optional[str]:
        """The topmost layer at a point [face units]."""
        found, scene = ctypes.c_int32(), self._drawn
        call(lib.mien_scene_layer_at, scene, float(x), float(y), ctypes.byref(found))
        return text(lib.mien_scene_layer_name(scene, found.value)) if found.value >= 0 else None

    def feature_at(self, x: float, y: float) -> Optional[str]:
        """The feature that is seen at a point [face units]: not its shadow or outline, and nothing transparent."""
        found = texts(lib.mien_scene_feature_at, self._drawn, float(x), float(y))
        return found[0] if found else None

    def distance(self, layer: Union[str, int], x: float, y: float) -> float:
        """The signed distance to a layer's outline, negative inside [face units]."""
        index = layer
        if isinstance(index, str):
            if index not in self.layers:
                raise _library.Error("layer", f"there is no layer {index!r}")
            index = self.layers.index(index)
        found = ctypes.c_double()
        call(lib.mien_scene_distance, self._drawn, whole(index, "layer"), float(x), float(y), ctypes.byref(found))
        return found.value

    def face_from_pixel(self, x: float, y: float, size: Size = 1024, fit: str = "meet") -> tuple[float, float]:
        """Where a point of the picture [px] is in the face [face units]."""
        found = (ctypes.c_double * 2)()
        call(lib.mien_face_from_pixel, self._drawn, view(self.face.canvas.aspect, size, fit), float(x), float(y), found)
        return found[0], found[1]

    def pixel_from_face(self, x: float, y: float, size: Size = 1024, fit: str = "meet") -> tuple[float, float]:
        """Where a point of the face [face units] is in the picture [px]."""
        found = (ctypes.c_double * 2)()
        call(lib.mien_pixel_from_face, self._drawn, view(self.face.canvas.aspect, size, fit), float(x), float(y), found)
        return found[0], found[1]

    @property
    def scene(self) -> str:
        """The shapes and layers as text, one a line."""
        return texts(lib.mien_scene_text, self._drawn)[0]

    def _repr_png_(self) -> bytes:
        return png(self.render(SHOWN_IN_NOTEBOOKS))


def read_face(path: "str | os.PathLike[str]") -> Face:
    """Reads a face file. What is wrong with it is an `Error` with file, line and column."""
    return Face(Handle(lib.mien_face_free, lib.mien_face_read, *path_bytes(path)))


def read_face_text(words: Union[str, bytes], name: str = "face") -> Face:
    """The same from memory; `name` stands for the file's name in errors."""
    raw = words if isinstance(words, bytes) else utf8(words)[0]
    return Face(Handle(lib.mien_face_free, lib.mien_face_read_text, raw, len(raw), *utf8(name)))


def face_pointers(words: Union[str, bytes], name: str = "face") -> dict[str, str]:
    """Where a face file's text says its values: JSON pointers (RFC 6901) by the values' names.

    Two sides that the file writes once have the same one. Names that the file does not hold are not among them: controls,
    whose values are poses, and all names of a recipe.
    """
    face = read_face_text(words, name)
    raw = words if isinstance(words, bytes) else utf8(words)[0]
    return {known: at for known, at in zip(face.names, texts(lib.mien_face_pointers, raw, len(raw), *utf8(name))) if at}


def face_text_with(words: Union[str, bytes], set: Mapping[str, Value], name: str = "face") -> EditedText:
    """A face file's text with other values; all else keeps every byte.

    `set` is that of `Face.pose`. A side that differs from its mirror image gets an object of its own.
    """
    raw = words if isinstance(words, bytes) else utf8(words)[0]
    settings = (ctypes.c_char_p * len(set))(*(utf8(f"{one}={_value_text(value)}")[0] for one, value in set.items()))
    made, *left = texts(lib.mien_face_text_with, raw, len(raw), *utf8(name), settings, len(set))
    return EditedText(made, tuple(left))


def from_code(code: str) -> Face:
    """The person of a code, "AA7Q2-MKX4T-BY"."""
    return Face(Handle(lib.mien_face_free, lib.mien_face_from_code, *utf8(code)))


def _value_text(value: Value) -> str:
    if isinstance(value, str):
        return value
    numbers = numpy.asarray(value, dtype=numpy.float64).ravel()
    return ",".join(repr(float(one)) for one in numbers)


def _motion_layer(layer: MotionLike) -> tuple[Motion, float, float]:
    """The motion, its weight and when it begins."""
    if isinstance(layer, Motion):
        return layer, 1.0, 0.0
    parts: tuple[Any, ...] = tuple(layer)
    if not 2 <= len(parts) <= 3 or not isinstance(parts[0], Motion):
        raise _library.Error("motions", f"expected a motion, (motion, weight) or (motion, weight, begin), got {layer!r}")
    return parts[0], float(parts[1]), float(parts[2]) if len(parts) == 3 else 0.0


def _clip_text(clip: ClipLike) -> str:
    if isinstance(clip, str):
        return clip
    parts: tuple[Any, ...] = tuple(clip)
    if not 2 <= len(parts) <= 3:
        raise _library.Error("clips", f"expected (name, weight) or (name, weight, begin), got {clip!r}")
    name, weight, begin = (*parts, 0.0)[:3]
    return f"{name}={float(weight)!r}@{float(begin)!r}"
