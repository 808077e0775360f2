"""libmien_c: where it is, what its functions take, and its errors as exceptions."""
from __future__ import annotations

import ctypes
import functools
import inspect
import os
import pathlib
import re
import weakref
from ctypes import POINTER, Structure, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p
from typing import Any, Callable, Mapping, Optional, Sequence, TypeVar

from . import _kinds
from ._errors import Cancelled, Error
from ._kinds import said

ABI = 0  # of the interface that these prototypes are
NUL_ENDED = c_size_t(-1).value
OK, MISUSE, UNREADABLE, REFUSED, CANCELLED, NO_MEMORY, NOT_WRITTEN, UNEXPECTED = range(8)

# mien_progress without its data, which comes last: in C's calling conventions callers clear away what nobody reads.
Progress = ctypes.CFUNCTYPE(c_int32, c_double)


class Canvas(Structure):
    _fields_ = [("size", c_uint32), ("y_up", c_int32), ("box", c_double * 4), ("mirror_x", c_double), ("unit", c_char_p)]


class NameRecord(Structure):
    _fields_ = [("size", c_uint32), ("is_control", c_int32), ("is_pose", c_int32), ("count", c_int32), ("begin", c_int32),
                ("reserved", c_int32), ("name", c_char_p), ("unit", c_char_p), ("lo", c_double), ("hi", c_double)]


class View(Structure):
    _fields_ = [("size", c_uint32), ("width", c_int32), ("height", c_int32), ("fit", c_int32), ("blend", c_int32),
                ("dither", c_int32), ("has_background", c_int32), ("has_region", c_int32), ("has_light", c_int32),
                ("reserved", c_int32), ("background", c_double * 4), ("light", c_double * 3), ("region", c_int32 * 4),
                ("legible", c_double)]


class Pixels(Structure):
    _fields_ = [("size", c_uint32), ("depth", c_int32), ("data", c_void_p), ("bytes", c_size_t), ("stride", c_size_t)]


class DevicePixels(Structure):
    _fields_ = [("size", c_uint32), ("format", c_int32), ("data", c_void_p), ("bytes", c_size_t), ("stride", c_size_t)]


class RenderOptions(Structure):
    _fields_ = [("size", c_uint32), ("threads", c_int32), ("progress", Progress), ("progress_data", c_void_p),
                ("executor", c_void_p), ("executor_data", c_void_p),
                ("most_steps", c_int64), ("most_memory", c_uint64)]


class RenderStats(Structure):
    _fields_ = [("size", c_uint32), ("cancelled", c_int32), *((name, c_int64) for name in (
        "pixels", "fill_pixels", "varied_pixels", "edge_pixels", "resolved_pixels", "recalled_pixels", "pieces", "crossings",
        "regions", "doubts", "roots", "distances")), ("root_seconds", c_double), ("distance_seconds", c_double),
                ("steps", c_int64), ("memory", c_int64)]


class Feet(Structure):
    _fields_ = [("size", c_uint32), ("reserved", c_int32), *((name, c_void_p) for name in (
        "piece", "t", "distance", "normal_x", "normal_y", "bend"))]


class BasisInfo(Structure):
    _fields_ = [("size", c_uint32), ("of_face", c_int32), ("frames", c_uint64), ("vertices", c_uint64), ("dimensions", c_uint64),
                ("components", c_uint64), ("total_variance", c_double), ("fps", c_double), ("begin", c_double)]


class WriteOptions(Structure):
    _fields_ = [("size", c_uint32), ("type", c_int32), ("half", c_int32), ("jpeg_quality", c_int32), ("threads", c_int32),
                ("depth", c_int32), ("memory", c_uint64), ("recipe", c_char_p), ("recipe_length", c_size_t),
                ("progress", Progress), ("progress_data", c_void_p), ("dpi", c_double)]


_ERROR = POINTER(c_void_p)  # and every other place that a handle is written to
_TEXT = [c_char_p, c_size_t]

# What each function takes and gives, but for the final `error` of those that give a status.
_STATUS: dict[str, list[Any]] = {
    "mien_face_read": [*_TEXT, _ERROR],
    "mien_face_read_text": [*_TEXT, *_TEXT, _ERROR],
    "mien_face_from_code": [*_TEXT, _ERROR],
    "mien_face_with_morphs": [c_void_p, *_TEXT, _ERROR],
    "mien_face_with_morphs_text": [c_void_p, *_TEXT, *_TEXT, _ERROR],
    "mien_face_pointers": [*_TEXT, *_TEXT, _ERROR],
    "mien_recipe_in_full": [*_TEXT, *_TEXT, _ERROR],
    "mien_face_text_with": [*_TEXT, *_TEXT, c_void_p, c_int32, _ERROR],
    "mien_morphs_text": [c_void_p, c_void_p, c_void_p, c_int32, _ERROR],
    "mien_face_canvas": [c_void_p, POINTER(Canvas)],
    "mien_face_name_at": [c_void_p, c_int32, POINTER(NameRecord)],
    "mien_face_values_at": [c_void_p, c_int32, c_void_p, c_int32],
    "mien_basis_read": [*_TEXT, _ERROR],
    "mien_basis_of_frames": [c_void_p, c_size_t, c_size_t, c_size_t, c_int32, c_double, _ERROR],
    "mien_basis_of_pose": [c_void_p, c_int64, c_size_t, c_double, c_int32, c_double, _ERROR],
    "mien_basis_about": [c_void_p, POINTER(BasisInfo)],
    "mien_basis_numbers": [c_void_p, c_int32, c_void_p, c_size_t],
    "mien_basis_decode": [c_void_p, c_void_p, c_size_t, c_void_p, c_size_t],
    "mien_basis_encode": [c_void_p, c_void_p, c_size_t, c_void_p, c_size_t],
    "mien_basis_file": [c_void_p, c_void_p, c_size_t],
    "mien_pose_basis": [c_void_p, c_void_p, c_void_p, c_size_t],
    "mien_unknown_name": [*_TEXT, *_TEXT, *_TEXT, _ERROR],
    "mien_seed_from_word": [*_TEXT, POINTER(c_uint64)],
    "mien_code_from_seed": [c_uint64, _ERROR],
    "mien_recipe_from_seed": [c_uint64, _ERROR],
    "mien_recipe_from_code": [*_TEXT, _ERROR],
    "mien_code_hold": [*_TEXT, *_TEXT, c_int32, _ERROR],
    "mien_code_neutral": [*_TEXT, _ERROR],
    "mien_code_near": [*_TEXT, c_double, c_uint64, _ERROR],
    "mien_code_between": [*_TEXT, *_TEXT, c_double, _ERROR],
    "mien_code_of_child": [*_TEXT, *_TEXT, c_uint64, _ERROR],
    "mien_code_difference": [*_TEXT, *_TEXT, POINTER(c_double)],
    "mien_crowd": [*_TEXT, c_int32, _ERROR],
    "mien_part_families": [_ERROR],
    "mien_part_numbers": [_ERROR],
    "mien_part_styles": [_ERROR],
    "mien_part_names": [*_TEXT, _ERROR],
    "mien_part_number": [*_TEXT, c_void_p],
    "mien_pose_new": [c_void_p, _ERROR],
    "mien_pose_time": [c_void_p, c_double],
    "mien_pose_set": [c_void_p, *_TEXT],
    "mien_pose_express": [c_void_p, *_TEXT, *_TEXT, c_int32],
    "mien_pose_clip": [c_void_p, *_TEXT],
    "mien_pose_motion": [c_void_p, c_void_p, c_double, c_double],
    "mien_pose_follow": [c_void_p, *_TEXT],
    "mien_pose_follow_steadily": [c_void_p, c_void_p, c_double, *_TEXT],
    "mien_steadier_new": [c_double, c_double, _ERROR],
    "mien_motion_read": [*_TEXT, _ERROR],
    "mien_motion_read_text": [*_TEXT, *_TEXT, _ERROR],
    "mien_motion_told": [c_void_p, _ERROR],
    "mien_motion_unfollowed": [c_void_p, c_void_p, _ERROR],
    "mien_pose_seed": [c_void_p, *_TEXT],
    "mien_pose_liveliness": [c_void_p, c_double],
    "mien_pose_gestures": [c_void_p, c_double],
    "mien_pose_look_at": [c_void_p, c_double, c_double, c_double],
    "mien_pose_unwrap": [c_void_p, c_double, c_int32],
    "mien_pose_vector": [c_void_p, c_void_p, c_int32],
    "mien_scene_new": [c_void_p, _ERROR],
    "mien_scene_debug": [c_void_p, c_int32, _ERROR],
    "mien_scene_text": [c_void_p, _ERROR],
    "mien_scene_distance": [c_void_p, c_int32, c_double, c_double, POINTER(c_double)],
    "mien_scene_layer_at": [c_void_p, c_double, c_double, POINTER(c_int32)],
    "mien_scene_feature_at": [c_void_p, c_double, c_double, _ERROR],
    "mien_drawn_rect": [POINTER(View), c_void_p],
    "mien_color_from_text": [*_TEXT, c_void_p],
    "mien_renderer_new": [_ERROR],
    "mien_render": [c_void_p, c_void_p, POINTER(View), POINTER(Pixels), POINTER(RenderOptions)],
    "mien_svg": [c_void_p, POINTER(View), c_double, *_TEXT, POINTER(RenderOptions), _ERROR],
    "mien_debug_picture": [c_void_p, POINTER(View), c_int32, POINTER(Pixels), POINTER(RenderOptions)],
    "mien_render_for_device": [c_void_p, POINTER(View), POINTER(DevicePixels), POINTER(RenderOptions)],
    "mien_renderer_stats": [c_void_p, POINTER(RenderStats)],
    "mien_effects_new": [_ERROR],
    "mien_effects_of_face": [c_void_p, _ERROR],
    "mien_effects_add": [c_void_p, *_TEXT],
    "mien_render_with_effects": [c_void_p, c_void_p, POINTER(View), c_void_p, POINTER(Pixels), POINTER(RenderOptions)],
    "mien_face_from_pixel": [c_void_p, POINTER(View), c_double, c_double, c_void_p],
    "mien_pixel_from_face": [c_void_p, POINTER(View), c_double, c_double, c_void_p],
    **{f"mien_distances_{figure}_{number}": [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t]
       for figure in ("quad", "cubic", "ellipse", "parabola", "tapered") for number in ("f32", "f64")},
    "mien_distances_quad_accurate_f32": [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t],
    "mien_distances_quads_f32": [c_void_p, c_size_t, c_void_p, c_void_p, c_void_p, c_size_t],
    "mien_distances_quad_on_grid_f32": [c_void_p, c_double, c_double, c_double, c_size_t, c_size_t, c_void_p],
    **{f"mien_feet_{figures}_f64": [c_void_p, c_size_t, c_void_p, c_void_p, c_size_t, POINTER(Feet), POINTER(Feet)]
       for figures in ("quads", "lines", "tapered")},
    "mien_feet_ellipse_f64": [c_void_p, c_void_p, c_void_p, c_size_t, POINTER(Feet), POINTER(Feet)],
}
_PLAIN: dict[str, tuple[Any, list[Any]]] = {
    "mien_version_text": (c_char_p, []),
    "mien_abi_version": (c_uint32, []),
    "mien_error_where": (c_char_p, [c_void_p]),
    "mien_error_what": (c_char_p, [c_void_p]),
    "mien_error_free": (None, [c_void_p]),
    "mien_texts_count": (c_int32, [c_void_p]),
    "mien_texts_at": (c_char_p, [c_void_p, c_int32]),
    "mien_texts_free": (None, [c_void_p]),
    "mien_face_free": (None, [c_void_p]),
    "mien_face_title": (c_char_p, [c_void_p]),
    "mien_face_credit": (c_char_p, [c_void_p]),
    "mien_face_name_count": (c_int32, [c_void_p]),
    "mien_face_clip_count": (c_int32, [c_void_p]),
    "mien_face_clip_name": (c_char_p, [c_void_p, c_int32]),
    "mien_face_clip_length": (c_double, [c_void_p, c_int32]),
    "mien_face_vector_size": (c_int32, [c_void_p]),
    "mien_basis_free": (None, [c_void_p]),
    "mien_basis_file_size": (c_size_t, [c_void_p]),
    "mien_pose_free": (None, [c_void_p]),
    "mien_motion_free": (None, [c_void_p]),
    "mien_steadier_free": (None, [c_void_p]),
    "mien_motion_length": (c_double, [c_void_p]),
    "mien_motion_channel_count": (c_int32, [c_void_p]),
    "mien_motion_channel_name": (c_char_p, [c_void_p, c_int32]),
    "mien_motion_value": (c_double, [c_void_p, c_int32, c_double]),
    "mien_scene_free": (None, [c_void_p]),
    "mien_scene_layer_count": (c_int32, [c_void_p]),
    "mien_scene_layer_name": (c_char_p, [c_void_p, c_int32]),
    "mien_view_init": (None, [POINTER(View), c_size_t]),
    "mien_device_pixels_init": (None, [POINTER(DevicePixels), c_size_t]),
    "mien_pixels_init": (None, [POINTER(Pixels), c_size_t]),
    "mien_render_options_init": (None, [POINTER(RenderOptions), c_size_t]),
    "mien_renderer_free": (None, [c_void_p]),
    "mien_effects_free": (None, [c_void_p]),
}
_IMAGE_STATUS: dict[str, list[Any]] = {
    "mien_write_image": [POINTER(Pixels), c_int32, c_int32, *_TEXT, POINTER(WriteOptions)],
    "mien_write_picture": [c_void_p, POINTER(View), *_TEXT, POINTER(WriteOptions)],
}
_IMAGE_PLAIN: dict[str, tuple[Any, list[Any]]] = {
    "mien_write_options_init": (None, [POINTER(WriteOptions), c_size_t]),
}


# Where MIEN_LIBRARY says now: the program may go elsewhere before it writes a file.
_SAID = os.path.abspath(os.environ["MIEN_LIBRARY"]) if os.environ.get("MIEN_LIBRARY") else None


def _candidates(name: str) -> list[str]:
    """Where the library may be: MIEN_LIBRARY, a folder or libmien_c itself; beside the package; where the system looks."""
    found = []
    if _SAID:
        place = pathlib.Path(_SAID)
        found.append(place / name if place.is_dir() else place if "image" not in name else place.parent / name)
    here = pathlib.Path(__file__).resolve().parent
    found += [here / "native" / name, here.parents[2] / name]  # of a wheel; PREFIX/lib of PREFIX/lib/python3/dist-packages/mien
    return [str(path) for path in found if path.is_file()] + [name]


def _open(name: str, status: dict[str, list[Any]], plain: dict[str, tuple[Any, list[Any]]]) -> ctypes.CDLL:
    said = []
    for path in _candidates(name):
        try:
            library = ctypes.CDLL(path)
            break
        except OSError as failure:
            said.append(str(failure))
    else:
        raise ImportError(f"mien needs {name}; MIEN_LIBRARY may say in which folder it is: {'; '.join(said)}")
    try:
        for function, (gives, takes) in plain.items():
            getattr(library, function).restype, getattr(library, function).argtypes = gives, takes
        for function, takes in status.items():
            getattr(library, function).restype, getattr(library, function).argtypes = c_int32, [*takes, _ERROR]
    except AttributeError as failure:
        raise ImportError(f"{name} is older than this package: {failure}") from None
    return library


lib = _open("libmien_c.so.0", _STATUS, _PLAIN)
if lib.mien_abi_version() != ABI:
    raise ImportError(f"libmien_c has interface {lib.mien_abi_version()}, and this package needs {ABI}")

_image: list[ctypes.CDLL] = []


def image() -> ctypes.CDLL:
    """libmien_image_c, which writes files: loaded when one is written first."""
    if not _image:
        _image.append(_open("libmien_image_c.so.0", _IMAGE_STATUS, _IMAGE_PLAIN))
    return _image[0]


def text(raw: Optional[bytes]) -> str:
    return (raw or b"").decode("utf-8", "replace")


def call(function: Callable[..., Any], *arguments: Any) -> None:
    """Calls a function that gives a status; raises what it says."""
    error = c_void_p()
    status = function(*arguments, ctypes.byref(error))
    if status == OK:
        return
    where, what = text(lib.mien_error_where(error)), text(lib.mien_error_what(error))
    lib.mien_error_free(error)
    if status == NO_MEMORY:
        raise MemoryError(f"{where}: {what}" if where else what)
    raise (Cancelled if status == CANCELLED else Error)(where, what)


class Handle:
    """Something of the library's, freed with this object."""

    def __init__(self, free: Callable[[Any], Any], function: Callable[..., Any], *arguments: Any) -> None:
        self.value = c_void_p()
        call(function, *arguments, ctypes.byref(self.value))
        weakref.finalize(self, free, self.value)


def made_by(handle: Any, what: str, makers: str) -> Handle:
    """A handle that an object of the package is made of; users make none."""
    if not isinstance(handle, Handle):
        raise TypeError(f"{what} is made by {makers}")
    return handle


def texts(function: Callable[..., Any], *arguments: Any) -> list[str]:
    """The list of texts that a function gives."""
    made = Handle(lib.mien_texts_free, function, *arguments)
    return [text(lib.mien_texts_at(made.value, i)) for i in range(lib.mien_texts_count(made.value))]


def utf8(words: str, name: str = "text") -> tuple[bytes, int]:
    """A text as two arguments; `name` stands in the error about what is none."""
    raw = _kinds.encoded(_kinds.text(words, name), name)
    return raw, len(raw)


_Function = TypeVar("_Function", bound=Callable[..., Any])
Parameters = Mapping[str, inspect.Parameter]


# What other programs, other doors or older versions call an argument, and what is said here instead.
_ELSEWHERE = {"width": "size=(width, height)", "height": "size=(width, height)", "depth": "dtype=numpy.uint16", "bits": "dtype=numpy.uint16",
              "bg": "background=", "facecolor": "background=", "cols": "columns=", "ncols": "columns=", "duration": "seconds=", "length": "seconds="}


def hinted(function: _Function) -> _Function:
    """The function, which looks at its arguments first: what is wrong with their names, number or kinds is a TypeError in a sentence.
    Every public function has it."""
    return _Asked(function, {}).wrapped(function)


def hinted_with(more: Parameters) -> Callable[[_Function], _Function]:
    """The same of functions that take `more` by their **how."""
    return lambda function: _Asked(function, more).wrapped(function)


def parameters_of(function: Callable[..., Any], *without: str) -> Parameters:
    """What a function takes by name, for `hinted_with`."""
    return {name: one for name, one in inspect.signature(function).parameters.items() if name not in ("self", *without)}


class _Asked:
    """What a function takes."""

    def __init__(self, function: Callable[..., Any], more: Parameters) -> None:
        signature = inspect.signature(function)
        own = signature.parameters
        kinds = {name: one.kind for name, one in own.items()}
        is_made = function.__name__ == "__init__"
        self.name = function.__qualname__.split(".")[-2] if is_made else function.__name__
        self.first = [name for name, kind in kinds.items() if kind is inspect.Parameter.POSITIONAL_OR_KEYWORD]
        self.rest = next((name for name, kind in kinds.items() if kind is inspect.Parameter.VAR_POSITIONAL), None)
        self.takes_all = not more and inspect.Parameter.VAR_KEYWORD in kinds.values()
        self.takes = {name: one for name, one in {**own, **more}.items()
                      if name not in ("self", "cls") and one.kind not in (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)}
        self.signature = signature if self.takes_all else signature.replace(parameters=_in_order([*own.values()], more))
        self.needed = [name for name in own if name in self.takes and own[name].default is inspect.Parameter.empty]
        self.checks = {name: check for name, check in ((name, _kinds.check_of(one)) for name, one in self.takes.items()) if check}

    def wrapped(self, function: _Function) -> _Function:
        @functools.wraps(function)
        def called(*given: Any, **named: Any) -> Any:
            self.look(given, named)
            return function(*given, **named)

        called.__signature__ = self.signature  # type: ignore[attr-defined]
        return called  # type: ignore[return-value]

    def look(self, given: Sequence[Any], named: Mapping[str, Any]) -> None:
        for name in named:
            if name not in self.takes and not self.takes_all:
                raise TypeError(f"{self.name}: {_unknown_argument(name, list(self.takes))}")
        if len(given) > len(self.first) and self.rest is None:
            raise TypeError(f"{self.name}: {self.too_many(given)}")
        asked = dict(zip(self.first, given))
        for name, value in named.items():
            if name in asked:
                raise TypeError(f'{self.name}: the argument "{name}" is given twice')
            asked[name] = value
        for name in self.needed:
            if name not in asked:
                raise TypeError(f'{self.name}: the argument "{name}" is missing')
        for name, value in asked.items():
            if name in self.checks and value is not self.takes[name].default:
                self.checks[name](value, name)

    def too_many(self, given: Sequence[Any]) -> str:
        """Of arguments without names that have none here."""
        first, value = [name for name in self.first if name in self.takes], given[len(self.first)]
        named = [name for name in self.takes if name not in first]
        if not named and not self.takes_all:
            return f"expected {' and '.join(first) or 'no arguments'}, got {len(given) - len(self.first)} more"
        fits = next((name for name in named if _could_be(value, self.takes[name], self.checks.get(name))), None)
        words = f"{fits}={_quoted(value)}" if fits else f"{named[0]}=…" if named else "name=…"
        return f"arguments{' after ' + first[-1] if first else ''} have names: {self.name}({', '.join([*(one + '=…' for one in first), words])})"


def _in_order(own: "list[inspect.Parameter]", more: Parameters) -> "list[inspect.Parameter]":
    """Those of the function, with `more` in the place of its **how."""
    added = [one.replace(kind=inspect.Parameter.KEYWORD_ONLY) for name, one in more.items() if name not in {each.name for each in own}]
    return [one for one in own if one.kind is not inspect.Parameter.VAR_KEYWORD] + added


def _could_be(value: Any, parameter: inspect.Parameter, check: Optional[_kinds.Check]) -> bool:
    """Whether a value may be meant for a parameter."""
    kinds = str(parameter.annotation)
    if check is None:
        return isinstance(value, str) and re.search(r"\b(One|Color|str)\b", kinds.partition("Mapping")[0]) is not None or (
            isinstance(value, Mapping) and re.search(r"\b(Strengths|PoseLike)\b", kinds) is not None)
    try:
        check(value, "")
    except (TypeError, ValueError):
        return False
    return value is not None


def _quoted(value: Any) -> str:
    return f'"{value}"' if isinstance(value, str) and len(value) < 60 and '"' not in value else said(value)


def _unknown_argument(name: str, known: Sequence[str]) -> str:
    instead = _ELSEWHERE.get(name, "")
    if instead and instead.partition("=")[0] in known:
        return f'no argument named "{name}"; say {instead}'
    return unknown_name("argument", name, known)


def unknown_name(what: str, wanted: str, names: Sequence[str]) -> str:
    """`no WHAT named "WANTED"; did you mean "NAME"?`"""
    return texts(lib.mien_unknown_name, *utf8(what), *utf8(wanted), *utf8("\n".join(names)))[0]


def path_bytes(path: "str | os.PathLike[str]") -> tuple[bytes, int]:
    raw = os.fsencode(_kinds.path(path, "path"))
    return raw, len(raw)
