"""Faces at rest."""
from __future__ import annotations

import ctypes
import os
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Iterator, Mapping, NamedTuple, Optional, Sequence, Union

import numpy
import numpy.typing

from . import _library, people
from ._basis import Basis, wish
from ._errors import Error, Path, reading
from ._kinds import Text, Word, finite, number, said, table, whole
from ._kinds import raw as raw_of
from ._kinds import word as word_of
from ._library import Handle, NameRecord, call, hinted, hinted_with, lib, parameters_of, text, texts, utf8
from ._motion import Motion, Steady
from ._names import Canvas, Name
from ._picture import Renderer, Size
from ._pose import ClipLike, MotionLike, One, PoseLike, Strengths, Value, pose_of, posed, value_text
from ._posed import HOW, Posed, Svg
from ._saved import File
from ._source import Source, read, source_of

if TYPE_CHECKING:
    from ._film import Film


class EditedText(NamedTuple):
    """A face file with other values."""

    text: str
    left: tuple[str, ...]  # names that the file cannot hold


class Face:
    """A face at rest. It never changes: threads may share it."""

    def __init__(self, handle: Handle, source: Optional[Source] = None) -> None:
        """For this package: `from_seed`, `from_code`, `read_face` and `read_face_text` make faces."""
        if not isinstance(handle, Handle) or source is None:
            raise TypeError("a face is made by mien.from_seed, mien.from_code, mien.read_face or mien.read_face_text")
        self._handle = handle
        self._source = source
        self._names: Optional[Mapping[str, Name]] = None

    @classmethod
    @hinted
    def from_seed(cls, word: Word, *, style: Optional[str] = None, hold: Optional[Mapping[str, Any]] = None, neutral: bool = False) -> Face:
        """As `mien.from_seed`."""
        return from_seed(word, style=style, hold=hold, neutral=neutral)

    @classmethod
    @hinted
    def from_code(cls, code: str, *, style: Optional[str] = None, neutral: bool = False) -> Face:
        """As `mien.from_code`."""
        return from_code(code, style=style, neutral=neutral)

    @property
    def code(self) -> Optional[str]:
        """The code that draws this person, whatever her style; None of faces that have none."""
        return self._source.code

    @property
    def recipe(self) -> Optional[str]:
        """The recipe that it is composed of, a face file of a few lines; None of faces in full."""
        return self.text if self._source.is_recipe else None

    @property
    def style(self) -> Optional[str]:
        """How a recipe paints it: "soft", "ink" …; None of faces in full."""
        return str(self._source.tree.get("style", "soft")) if self._source.is_recipe else None

    @property
    def text(self) -> str:
        """Its face file. Parts of one's own lie beside it, and morph targets in other files."""
        return self._source.text.decode("utf-8", "replace")

    @hinted
    def with_style(self, style: str) -> Face:
        """The same person painted in another style, one of `people.styles()`."""
        source = self._source.styled(style)
        return Face(source.handle(), source)

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
             emotions: Optional[Strengths] = None, muscles: Optional[Strengths] = None, visemes: Optional[Strengths] = None,
             arkit: Optional[Strengths] = None, facs: Optional[Strengths] = None, vrm: Optional[Strengths] = None,
             azure: Optional[Strengths] = None, expressions: Optional[Mapping[str, Strengths]] = None,
             emotion: Optional[One] = None, muscle: Optional[One] = None, viseme: Optional[One] = None,
             blink: Optional[float] = None, bias: Optional[float] = None, yaw: Optional[float] = None, pitch: Optional[float] = None,
             roll: Optional[float] = None, clips: Optional[Sequence[ClipLike]] = None, clip: Optional[ClipLike] = None,
             look_at: Optional[Sequence[float]] = None, unwrap: Optional[float] = None, unwrap_mode: Optional[str] = None,
             clamp: Optional[bool] = None, basis: Optional[Basis] = None, weights: Optional[Sequence[float]] = None,
             seed: Optional[Word] = None, liveliness: Optional[float] = None, gestures: Optional[float] = None,
             motions: Union[Motion, Sequence[MotionLike], None] = None,
             frame: Union[str, Mapping[str, Any], Sequence[Any], None] = None,
             steady: Optional[tuple[Steady, float]] = None) -> Posed:
        """The face at that pose. None is as if it were not said.

        time         [s] at which clips are taken; without one none runs
        set          values by name (`Face.names`); a colour may be "#rrggbb" or a name. They beat everything else
        emotions     strengths by name, 0 to 1: {"joy": 0.8, "left.surprise": 0.3}
        muscles, visemes, arkit, facs, vrm, azure   strengths of other sets: visemes={"aa": 0.7}, arkit={"jawOpen": 0.5}
        expressions  sets by name, a face's own among them: {"arkit": {"jawOpen": 0.5}}
        emotion, muscle, viseme, clip   one of each, as the command says it: emotion="joy", emotion="joy=0.8"
        blink, bias, yaw, pitch, roll   controls that most faces have, as in `set`; angles in degrees
        clips        names, or (name, weight), or (name, weight, begin [s]); each acts on those before it
        look_at      x, y, z that the eyes look at [face units], z towards the viewer
        unwrap       0 to 1: how far the features have travelled to a flat chart, by `unwrap_mode`: "linear", "delayed", "sine"
        clamp        strengths out of range become the nearer end instead of an error
        basis        whose vector replaces that at rest: of its `weights`, or without any of those at `time`
        seed         a word instead of the face's own code, recipe or text, for blinks and glances by chance
        liveliness   0 to 2: how far clips move the face; 1 as they say, 0 not at all
        gestures     0 to 2: how far the head nods and brows rise with the stresses of speech; 0: the mouth alone speaks
        motions      takes and speech (`read_motion`), or (motion, weight), or (motion, weight, begin [s]), on top of clips
        frame        what a camera saw: ARKit's shapes by name, a result of MediaPipe, or its JSON; it beats motions
        steady       of frames that come live: what keeps them quiet, and the frame's moment [s]
        """
        asked = {name: value for name, value in locals().items() if name != "self" and value is not None}
        return Posed(self, posed(self._handle.value, asked), asked)

    @hinted_with(parameters_of(pose, "time", "motions"))
    def speak(self, track: Motion, time: float, **pose: Any) -> Posed:
        """The face at a moment of a track of speech, or of a take [s]: what sounds then. `pose` has further arguments of
        `Face.pose`; without `clips` the face's first one runs below."""
        if not isinstance(track, Motion):
            raise TypeError(f"track: expected a mien.Motion, as read_motion gives it, got {said(track)}")
        below: dict[str, Any] = {} if "clips" in pose or "clip" in pose else {"clips": self.clips[:1]}
        return self.pose(time=time, motions=[track], **below, **pose)

    @hinted_with(parameters_of(pose, "frame"))
    def follow(self, frame: Union[str, Mapping[str, Any], Sequence[Any]], **pose: Any) -> Posed:
        """The face as a camera saw an actor's: ARKit's shapes by name, a result of MediaPipe, or its JSON. `steady` is
        (Steady(), the frame's moment [s]) for frames that come live."""
        if frame is None:
            raise TypeError("frame: expected shapes by name, a result of MediaPipe or its JSON, got None")
        return self.pose(frame=frame, **pose)

    @hinted
    def unfollowed(self, motion: Motion) -> tuple[str, ...]:
        """The names of what moves in a motion and not in this face."""
        if not isinstance(motion, Motion):
            raise TypeError(f"motion: expected a mien.Motion, as read_motion gives it, got {said(motion)}")
        return tuple(texts(lib.mien_motion_unfollowed, motion._handle.value, self._handle.value))

    @hinted_with(parameters_of(pose))
    def fit_basis(self, count: int, *, fps: float = 30, first: int = 0, components: Optional[int] = None,
                  variance: Optional[float] = None, max_error: Optional[float] = None, **pose: Any) -> Basis:
        """A basis of `count` frames of the face, at first / fps, (first + 1) / fps ... seconds, as `mien pca fit` makes it.

        One of: so many `components`; the fewest that hold this share of the `variance`; the fewest with no larger `max_error`
        of any number [face units; levels of 255 for colours]. `pose` has further arguments of `Face.pose`.
        """
        if (frames := whole(count, "count")) < 1:
            raise Error("count", "expected 1 frame or more")
        posed = self.pose(**pose)
        return Basis(Handle(lib.mien_basis_free, lib.mien_basis_of_pose, posed._pose.value, whole(first, "first"), frames, number(fps, "fps"),
                            *wish(components, variance, max_error)))

    @hinted_with(parameters_of(Posed.render))
    def render(self, size: Size = 1024, **how: Any) -> numpy.typing.NDArray[Any]:
        """The picture at rest: see `Posed.render`."""
        return self.pose().render(size, **how)

    @hinted_with(parameters_of(Posed.for_device))
    def for_device(self, format: str, size: Size = 240, **how: Any) -> numpy.typing.NDArray[Any]:
        """The picture at rest for a small display: see `Posed.for_device`."""
        return self.pose().for_device(format, size, **how)

    @hinted_with(parameters_of(Posed.save))
    def save(self, file: File, size: Size = 1024, **how: Any) -> None:
        """Draws it at rest into a file: see `Posed.save`."""
        self.pose().save(file, size, **how)

    @hinted_with(parameters_of(Posed.svg))
    def svg(self, size: Size = 1024, **how: Any) -> Svg:
        """It at rest as an SVG file: see `Posed.svg`."""
        return self.pose().svg(size, **how)

    @hinted_with(parameters_of(Posed.render))
    def to_pil(self, size: Size = 1024, **how: Any) -> Any:
        """The picture at rest as a PIL.Image."""
        return self.pose().to_pil(size, **how)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> numpy.typing.NDArray[Any]:
        return self.pose().__array__(dtype, copy)

    @hinted_with(parameters_of(Posed.render, "renderer"))
    def frames(self, count: int, size: Size = 1024, *, fps: float = 30, begin: float = 0,
               pose: PoseLike = None,
               **how: Any) -> Iterator[numpy.typing.NDArray[Any]]:
        """The pictures of an animation, one after another, by one renderer.

        `pose` has the arguments of `Face.pose`, or is a function that gives them for a time; without a `time` of
        its own each frame has that of its number. `how` is as for `Posed.render`.
        """
        if not finite(fps, "fps") > 0:
            raise Error("fps", f"expected more than 0, got {fps}")
        finite(begin, "begin")
        return self._frames(whole(count, "count"), size, fps, begin, pose_of(pose), how)

    def _frames(self, count: int, size: Size, fps: float, begin: float, pose: PoseLike, how: Mapping[str, Any]) -> Iterator[numpy.typing.NDArray[Any]]:
        renderer = Renderer()
        for frame in range(count):
            time = begin + frame / fps
            asked: dict[str, Any] = {"time": time, **((pose_of(pose(time)) if callable(pose) else pose) or {})}
            yield self.pose(**asked).render(size, renderer=renderer, **how)

    @hinted_with(HOW)
    def animate(self, file: Optional[File] = None, *, seconds: Optional[float] = None, frames: Optional[int] = None, fps: float = 30,
                size: Size = 320, begin: float = 0, pose: PoseLike = None, sound: Optional[Path] = None, format: Optional[str] = None,
                quality: Optional[int] = None, **how: Any) -> Film:
        """A film: .apng (or .png), .gif, .webp, .mp4 or .webm, which a notebook plays.

        file      a path or a file object; without one the film is in memory, as APNG
        seconds   how long, or so many `frames`; default until the last of the pose's `motions` ends, or 2 s without motions
        pose      as for `frames`: arguments of `Face.pose`, or a function of the time that gives them
        sound     a file of it, for .mp4 and .webm, from the film's beginning on
        format    "gif" …, where the file's name does not say it
        quality   1 to 100, of .webp alone, and then with loss, by Pillow; without it nothing is lost
        how       as for `Posed.render`

        This package writes APNG. GIF and WebP are written by the command `mien`, where it has words for the pose, or by Pillow; .mp4 and
        .webm need ffmpeg.
        """
        from ._film import animate  # which knows faces
        return animate(self, file, seconds=seconds, frames=frames, fps=fps, size=size, begin=begin, pose=pose, sound=sound, format=format, quality=quality,
                       **how)

    @hinted
    def with_morphs(self, path: Path) -> Face:
        """The face with the morph targets of a file: further names, whose weights `set` holds."""
        with reading(path), open(path, "rb") as file:
            return self.with_morphs_text(file.read(), os.fspath(path))

    @hinted
    def with_morphs_text(self, words: Text, name: str = "morphs") -> Face:
        """The same from memory; `name` stands for the file's name in errors."""
        raw = raw_of(words, "words")
        made = Handle(lib.mien_face_free, lib.mien_face_with_morphs_text, self._handle.value, raw, len(raw), *utf8(name))
        return Face(made, self._source.with_more(name, raw))

    @hinted
    def morphs_text(self, shapes: Mapping[str, Face]) -> str:
        """The text of a file of morph targets: the same face, slice for slice, in other shapes, by name."""
        for name, face in table(shapes, "shapes", 'faces by name, such as {"cold": face}').items():
            if not isinstance(face, Face):
                raise TypeError(f"shapes[{name!r}]: expected a face, got {said(face)}")
        names = (ctypes.c_char_p * len(shapes))(*(_c_text(name, "shapes") for name in shapes))
        faces = (ctypes.c_void_p * len(shapes))(*(face._handle.value.value for face in shapes.values()))
        return texts(lib.mien_morphs_text, self._handle.value, names, faces, len(shapes))[0]

    def __eq__(self, other: object) -> bool:
        """Whether both are made of the same texts, whatever their spaces and the order of their keys."""
        return isinstance(other, Face) and self._source.key == other._source.key

    def __hash__(self) -> int:
        return hash(self._source.key)

    def __copy__(self) -> Face:
        return self

    def __deepcopy__(self, memo: object) -> Face:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _face_again, (self._source.state(),)

    def _repr_png_(self) -> bytes:
        return self.pose()._repr_png_()

    def __repr__(self) -> str:
        style = f", {self.style}" if self.style not in (None, "soft") else ""
        return f"<mien.Face {self.title or 'without a name'}{style}: {len(self.names)} names>"


def _face_again(state: Any) -> Face:
    source = source_of(state)
    return Face(source.handle(), source)


@hinted
def read_face(path: Path) -> Face:
    """Reads a face file. What is wrong with it is an `Error` with file, line and column; a file that is not there is a
    `FileNotFoundError`, too."""
    return Face(*read(path))


@hinted
def read_face_text(words: Text, name: str = "face") -> Face:
    """The same from memory; `name` stands for the file's name in errors."""
    source = Source(raw_of(words, "words"), name)
    return Face(source.handle(), source)


@hinted
def face_pointers(words: Text, name: str = "face") -> dict[str, str]:
    """Where a face file's text says its values: JSON pointers (RFC 6901) by the values' names.

    Two sides that the file writes once have the same one. Names that the file does not hold are not among them: controls,
    whose values are poses, and all names of a recipe.
    """
    face = read_face_text(words, name)
    raw = raw_of(words, "words")
    return {known: at for known, at in zip(face.names, texts(lib.mien_face_pointers, raw, len(raw), *utf8(name))) if at}


@hinted
def face_text_with(words: Text, set: Mapping[str, Value], name: str = "face") -> EditedText:
    """A face file's text with other values; all else keeps every byte.

    `set` is that of `Face.pose`. A side that differs from its mirror image gets an object of its own.
    """
    raw = raw_of(words, "words")
    values = table(set, "set", 'values by name, such as {"brow_lift": 0.5}')
    settings = (ctypes.c_char_p * len(values))(*(_c_text(f"{one}={value_text(value, str(one))}", "set") for one, value in values.items()))
    made, *left = texts(lib.mien_face_text_with, raw, len(raw), *utf8(name), settings, len(values))
    return EditedText(made, tuple(left))


def _c_text(words: str, name: str) -> bytes:
    """A text that C reads to its end."""
    raw = utf8(words, name)[0]
    if b"\0" in raw:
        raise Error(name, f"a name has no NUL, got {said(words)}")
    return raw


@hinted
def from_code(code: str, *, style: Optional[str] = None, neutral: bool = False) -> Face:
    """The person of a code, "AA7Q2-MKX4T-BY"; `style`, such as "ink", is how she is painted (`people.styles()`). `neutral`: without
    the smile and the mood that people rest in."""
    code = people.neutral(code) if neutral else code
    source = Source(None, code, code)
    if style is not None:
        source = source.styled(style)
    return Face(source.handle(), source)


@hinted
def from_seed(word: Word, *, style: Optional[str] = None, hold: Optional[Mapping[str, Any]] = None, neutral: bool = False) -> Face:
    """The person of a word, such as a user's name: the same word, the same person. A whole number is its text: 42 is "42".

    `hold` has parts and numbers that she has whatever the word says: {"hair": "bob", "glasses": None, "age": 30}. `neutral`: without
    the smile and the mood that people rest in; what is held stays.
    """
    code = people.code(word_of(word, "word"))
    held = table({} if hold is None else hold, "hold", 'parts and numbers by name, such as {"hair": "bob"}')
    return from_code(people.hold(people.neutral(code) if neutral else code, held), style=style)
