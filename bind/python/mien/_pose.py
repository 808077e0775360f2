"""What a pose says, as the library takes it."""
from __future__ import annotations

import json
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy
import numpy.typing

from ._basis import Basis
from ._colors import hexadecimal
from ._errors import Error
from ._kinds import Word, finite, listed, number, real, said, table, text, truth, word
from ._library import Handle, call, lib, utf8
from ._motion import Motion, Steady
from ._picture import choice

Value = Union[str, float, Sequence[float], numpy.typing.NDArray[Any]]
Strengths = Mapping[str, float]
One = Union[str, Strengths]  # "joy", "joy=0.8" or strengths by name
ClipLike = Union[str, "tuple[str, float]", "tuple[str, float, float]"]
MotionLike = Union[Motion, "tuple[Motion, float]", "tuple[Motion, float, float]"]
UNWRAP_MODES = ("linear", "delayed", "sine")
# What each argument calls its set. The words of the command, which has one of each at a time, are in the singular.
SETS = {"emotions": "emotion", "muscles": "muscle", "arkit": "arkit", "facs": "facs", "vrm": "vrm", "visemes": "viseme", "azure": "azure"}
SINGULAR = ("emotion", "muscle", "viseme")
CONTROLS = ("blink", "bias", "yaw", "pitch", "roll")  # that have an argument of their own
_LIKE = {"emotions": '{"joy": 0.8}', "muscles": '{"zygomaticus": 0.5}', "arkit": '{"jawOpen": 0.4}', "facs": '{"AU12": 0.6}',
         "vrm": '{"happy": 1}', "visemes": '{"aa": 0.7}', "azure": '{"2": 1}'}


def posed(face: Any, asked: Mapping[str, Any]) -> Handle:
    """A pose of a face of the library's with the arguments of `Face.pose` that were given."""
    made = Handle(lib.mien_pose_free, lib.mien_pose_new, face)
    pose, clamp = made.value, truth(asked.get("clamp", False), "clamp")
    if "time" in asked:
        call(lib.mien_pose_time, pose, finite(asked["time"], "time"))
    for clip in clip_texts(asked):
        call(lib.mien_pose_clip, pose, *utf8(clip))
    _play(pose, asked)
    for name, function in (("seed", lib.mien_pose_seed), ("liveliness", lib.mien_pose_liveliness),
                           ("gestures", lib.mien_pose_gestures)):
        if name in asked:
            call(function, pose, *(utf8(word(asked[name], name)) if name == "seed" else [number(asked[name], name)]))
    if "look_at" in asked:
        point = real(listed(asked["look_at"], "look_at", "(0.5, 0.3, 9)"), "look_at").ravel()
        if point.size != 3:
            raise Error("look_at", f"expected x, y, z, got {point.size} numbers")
        call(lib.mien_pose_look_at, pose, *map(float, point))
    if "unwrap" in asked or "unwrap_mode" in asked:
        mode = choice(asked.get("unwrap_mode", "linear"), UNWRAP_MODES, "unwrap_mode")
        share = number(asked.get("unwrap", 0), "unwrap")
        if not 0 <= share <= 1:
            raise Error("unwrap", f"goes from 0 to 1, got {share}")
        call(lib.mien_pose_unwrap, pose, share, mode)
    for kind, words in strengths(asked):
        call(lib.mien_pose_express, pose, *utf8(kind), *utf8(words), clamp)
    for words in settings(asked):
        call(lib.mien_pose_set, pose, *utf8(words))
    _lay_basis(pose, asked.get("basis"), asked.get("weights"))
    return made


def _play(pose: Any, asked: Mapping[str, Any]) -> None:
    for motion in motions_of(asked):
        of, weight, begin = motion_layer(motion)
        call(lib.mien_pose_motion, pose, of._handle.value, weight, begin)
    steady = asked.get("steady")
    if steady is not None and not (isinstance(steady, tuple) and len(steady) == 2 and isinstance(steady[0], Steady)):
        raise TypeError(f"steady: expected (Steady(), the frame's moment in seconds), got {said(steady)}")
    if "frame" not in asked:
        return
    frame = asked["frame"]
    seen = utf8(frame if isinstance(frame, str) else _json(frame), "frame")
    if steady is None:
        call(lib.mien_pose_follow, pose, *seen)
    else:
        call(lib.mien_pose_follow_steadily, pose, steady[0]._handle.value, number(steady[1], "steady"), *seen)


def _json(frame: Any) -> str:
    def plain(one: Any) -> Any:
        if isinstance(one, numpy.generic) or isinstance(one, numpy.ndarray):
            return one.tolist()
        raise TypeError(f"frame: expected shapes by name, such as {{\"jawOpen\": 0.4}}, a result of MediaPipe or its JSON, got {said(one)}")

    return json.dumps(frame if isinstance(frame, (Mapping, list, tuple)) else plain(frame), default=plain)


def strengths(asked: Mapping[str, Any]) -> "list[tuple[str, str]]":
    """Sets and "NAME=STRENGTH", in the order in which they act."""
    found = []
    for argument, kind in SETS.items():
        like = f"strengths by name, such as {_LIKE[argument]}"
        for name, strength in table(asked.get(argument, {}), argument, like).items():
            found.append((kind, f"{name}={number(strength, f'{argument}[{name!r}]')!r}"))
    sets = table(asked.get("expressions", {}), "expressions", 'sets by name, such as {"arkit": {"jawOpen": 0.5}}')
    for kind, given in sets.items():
        where = f"expressions[{kind!r}]"
        for name, strength in table(given, where, 'strengths by name, such as {"jawOpen": 0.5}').items():
            found.append((str(kind), f"{name}={number(strength, f'{where}[{name!r}]')!r}"))
    for kind in SINGULAR:
        given = asked.get(kind, {})
        if isinstance(given, str):
            found.append((kind, text(given, kind) if "=" in given else f"{text(given, kind)}=1"))
            continue
        for name, strength in table(given, kind, f'"NAME", "NAME=STRENGTH" or {_LIKE[kind + "s"]}').items():
            found.append((kind, f"{name}={number(strength, f'{kind}[{name!r}]')!r}"))
    return found


def settings(asked: Mapping[str, Any]) -> "list[str]":
    """"NAME=VALUE", in order: later ones win."""
    named = [f"{name}={number(asked[name], name)!r}" for name in CONTROLS if name in asked]
    values = table(asked.get("set", {}), "set", 'values by name, such as {"gaze.x": 0.04}')
    return named + [f"{name}={value_text(value, str(name))}" for name, value in values.items()]


def value_text(value: Any, name: str) -> str:
    """A value as `--set` of the command has it."""
    if isinstance(value, str):
        return hexadecimal(value)
    if value is None:
        raise TypeError(f"{name}: expected a number, numbers or a colour, got None")
    return ",".join(repr(float(one)) for one in real(value, name).ravel())


def motions_of(asked: Mapping[str, Any]) -> Sequence[Any]:
    """The motions of a pose, as they were given."""
    motions = asked.get("motions", ())
    return [motions] if isinstance(motions, Motion) else listed(motions, "motions", "[track]")


def motion_layer(layer: Any) -> "tuple[Motion, float, float]":
    """The motion, its weight and when it begins."""
    if isinstance(layer, Motion):
        return layer, 1.0, 0.0
    parts = tuple(layer) if isinstance(layer, (tuple, list)) else ()
    if not 2 <= len(parts) <= 3 or not isinstance(parts[0], Motion):
        raise Error("motions", f"expected a motion, (motion, weight) or (motion, weight, begin), got {said(layer)}")
    return parts[0], number(parts[1], "motions"), number(parts[2], "motions") if len(parts) == 3 else 0.0


def clip_texts(asked: Mapping[str, Any]) -> "list[str]":
    """The clips of a pose as the command has them, in order."""
    return ([_clip_text(one, "clips") for one in listed(asked.get("clips", ()), "clips", '["idle"]')]
            + ([_clip_text(asked["clip"], "clip")] if "clip" in asked else []))


def _clip_text(clip: Any, where: str) -> str:
    if isinstance(clip, str):
        return text(clip, where)
    parts = tuple(clip) if isinstance(clip, (tuple, list)) else ()
    if not 2 <= len(parts) <= 3 or not isinstance(parts[0], str):
        raise Error(where, f"expected a name, (name, weight) or (name, weight, begin), got {said(clip)}")
    name, weight, begin = (*parts, 0.0)[:3]
    return f"{name}={number(weight, where)!r}@{number(begin, where)!r}"


def _lay_basis(pose: Any, basis: Optional[Basis], weights: Any) -> None:
    if basis is None:
        if weights is not None:
            raise Error("weights", "are those of a basis")
        return
    if not isinstance(basis, Basis):
        raise TypeError(f"basis: expected a mien.Basis, as fit_basis and read_basis give it, got {said(basis)}")
    held = numpy.ascontiguousarray(real(() if weights is None else weights, "weights"), numpy.float64).ravel()
    call(lib.mien_pose_basis, pose, basis._handle.value, held.ctypes.data, held.size)


def pose_of(given: Any) -> Any:
    """What poses a film's frames: nothing, arguments of `Face.pose`, or a function that gives them."""
    return given if given is None or callable(given) else table(given, "pose", 'arguments of face.pose, such as {"yaw": 20}, or a function of the time')


PoseLike = Union[Mapping[str, Any], Callable[[float], Mapping[str, Any]], None]
