"""Films: a face at many moments, in a file or in a notebook."""
from __future__ import annotations

import base64
import importlib
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any, Iterator, Mapping, Optional

import numpy
import numpy.typing

from . import _command
from ._colors import hexadecimal
from ._errors import Error, Path
from ._face import Face
from ._kinds import number, said, whole, word
from ._library import hinted_with
from ._picture import Size, sides
from ._png import apng
from ._pose import PoseLike, clip_texts, motion_layer, motions_of, pose_of, settings, strengths
from ._posed import HOW
from ._saved import File, format_of, save, write_whole

_MIME = {"png": "image/png", "apng": "image/png", "gif": "image/gif", "webp": "image/webp", "mp4": "video/mp4", "webm": "video/webm"}
# What the command says of a pose and of a picture, too. The rest is drawn here.
_SAID_THERE = {"set", "emotions", "muscles", "emotion", "muscle", "blink", "bias", "yaw", "pitch", "roll", "clips", "clip", "look_at", "seed",
               "liveliness", "clamp"}
_ENCODERS = {"mp4": ["-c:v", "libx264", "-crf", "16", "-movflags", "+faststart", "-c:a", "aac"],
             "webm": ["-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0", "-c:a", "libopus"]}


class Film:
    """A film that was written. A notebook plays it."""

    def __init__(self, path: Optional[pathlib.Path], kind: str, raw: bytes) -> None:
        if not isinstance(raw, bytes) or kind not in _MIME:
            raise TypeError("a film is made by face.animate or mien.animate")
        self.path = path  # None of one that is in memory alone
        self.kind = kind  # "gif" …
        self._raw = raw

    def __bytes__(self) -> bytes:
        return self._raw

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> "dict[str, str]":
        data, mime = base64.b64encode(self._raw).decode(), _MIME[self.kind]
        if mime.startswith("video/"):
            return {"text/html": f'<video controls autoplay loop muted src="data:{mime};base64,{data}"></video>', "text/plain": repr(self)}
        if mime == "image/webp":
            return {"text/html": f'<img src="data:{mime};base64,{data}">', "text/plain": repr(self)}
        return {mime: data, "text/plain": repr(self)}

    def __repr__(self) -> str:
        return f"<mien.Film {str(self.path) if self.path else 'in memory'}: {self.kind}, {len(self._raw)} bytes>"


@hinted_with(HOW)
def animate(face: Face, file: Optional[File] = None, *, seconds: Optional[float] = None, frames: Optional[int] = None, fps: float = 30,
            size: Size = 320, begin: float = 0, pose: PoseLike = None, sound: Optional[Path] = None, format: Optional[str] = None,
            quality: Optional[int] = None, **how: Any) -> Film:
    """A film of a face: see `Face.animate`."""
    if not isinstance(face, Face):
        raise TypeError(f"face: expected a face, got {said(face)}")
    if quality is not None and (not 1 <= quality <= 100 or file is None or format_of(file, format) != "webp"):
        raise Error("quality", f"is 1 to 100, of .webp alone, got {quality}" + (" without a .webp" if 1 <= quality <= 100 else ""))
    work = _Work(face, _count(seconds, frames, fps, begin, pose_of(pose)), fps, size, begin, pose, sound, quality, how)
    if file is None:
        return Film(None, "apng", work.bytes_of("apng"))
    written: "list[tuple[str, bytes]]" = []

    def run(path: Path, kind: str) -> None:
        raw = work.bytes_of(kind)
        write_whole(path, raw)
        written.append((kind, raw))

    save(file, format, run)
    return Film(None if hasattr(file, "write") else pathlib.Path(os.fspath(file)), *written[0])


def _count(seconds: Optional[float], frames: Optional[int], fps: float, begin: float, pose: PoseLike) -> int:
    """How many frames: those of `frames`, of `seconds`, or of the motions."""
    if not (fps > 0 and math.isfinite(fps)):
        raise Error("fps", f"expected more than 0, got {fps}")
    if not math.isfinite(begin):
        raise Error("begin", f"expected a finite number, got {begin}")
    if frames is not None:
        if seconds is not None:
            raise Error("frames", "expected seconds or frames, one of them")
        if frames < 1:
            raise Error("frames", f"expected 1 or more, got {frames}")
        return int(frames)
    if seconds is not None and not (seconds > 0 and math.isfinite(seconds)):
        raise Error("seconds", f"expected more than 0, got {seconds}")
    return max(1, round(seconds * fps)) if seconds is not None else max(1, math.ceil(_length(pose, begin) * fps))


def _length(pose: PoseLike, begin: float) -> float:
    """[s] Until the last motion ends; 2 without motions."""
    if not isinstance(pose, Mapping) or pose.get("motions") is None:
        return 2.0
    layers = [motion_layer(one) for one in motions_of(pose)]
    return max((start + motion.length - begin for motion, _, start in layers), default=2.0)


class _Work:
    """What a film is to show."""

    def __init__(self, face: Face, count: int, fps: float, size: Size, begin: float, pose: PoseLike, sound: Optional[Path],
                 quality: Optional[int], how: Mapping[str, Any]) -> None:
        self.face, self.count, self.fps, self.size, self.begin, self.pose, self.how = face, count, fps, size, begin, pose, how
        self.sound, self.quality = sound, quality

    def bytes_of(self, kind: str) -> bytes:
        """The film, by what can write it: the package APNG, the command, Pillow, ffmpeg."""
        if kind not in _MIME:
            raise Error("format", f"no film is .{kind}; films are .gif .webp .apng .png .mp4 .webm" if kind else "expected a name that ends with .gif .webp .apng .png .mp4 .webm")
        if self.sound is not None and kind not in _ENCODERS:
            raise Error("sound", f"a .{kind} has none; films with sound are .mp4 .webm")
        if kind in ("apng", "png"):
            return apng(self.frames(), self.fps)
        words = self.words()
        if words is not None and self.quality is None and _command.found():
            return self.by_command(kind, words)
        return self.by_ffmpeg(kind) if kind in _ENCODERS else self.by_pillow(kind)

    def frames(self) -> Iterator[numpy.typing.NDArray[numpy.uint8]]:
        return self.face.frames(self.count, self.size, fps=self.fps, begin=self.begin, pose=self.pose, **self.how)

    def words(self) -> "Optional[list[str]]":
        """The pose in the command's words; None where it has none, as for a pose by a function."""
        if callable(self.pose):
            return None
        pose = {name: one for name, one in (self.pose or {}).items() if one is not None}
        whole_frames = abs(self.begin * self.fps - round(self.begin * self.fps)) < 1e-9
        if not _SAID_THERE.issuperset(pose) or not {"background"}.issuperset(self.how) or not whole_frames:
            return None
        if not isinstance(self.how.get("background", ""), str) or self.face._source.morphs:
            return None
        words = [f"--{kind}={text}" for kind, text in strengths(pose)] + [f"--set={text}" for text in settings(pose)]
        words += [f"--clip={clip}" for clip in clip_texts(pose)]
        if "look_at" in pose:
            words.append("--look-at=" + ",".join(repr(float(one)) for one in pose["look_at"]))
        words += [f"--{name}={of(pose[name], name)}" for name, of in (("seed", word), ("liveliness", number)) if name in pose] + ["--clamp"] * bool(pose.get("clamp"))
        return words + [f"--background={hexadecimal(self.how[name])}" for name in self.how]

    def by_command(self, kind: str, words: "list[str]") -> bytes:
        self.face.pose(**(self.pose or {}))  # type: ignore[arg-type]  # what is wrong with it is told in Python's words
        width, height = sides(self.size, self.face.canvas.aspect)
        first = round(self.begin * self.fps)
        with tempfile.TemporaryDirectory(prefix="mien-") as folder:
            made = pathlib.Path(folder, f"film.{kind}")
            more = ["--sound", os.fspath(self.sound)] if self.sound is not None else []
            with self.face._source.in_file() as face:
                _command.run("animate", "animate", face, *words, *more, "--frames", f"{first}-{first + self.count - 1}", "--fps", f"{self.fps:g}",
                             "--size", f"{width}x{height}", "-o", made)
            return made.read_bytes()

    def by_pillow(self, kind: str) -> bytes:
        try:
            image, features = importlib.import_module("PIL.Image"), importlib.import_module("PIL.features")
        except ImportError:
            if self.quality is not None:
                raise Error("quality", "of a .webp needs Pillow: pip install pillow") from None
            _command.needed(f".{kind}", ", or Pillow (pip install pillow); .apng needs neither")
            raise Error("pose", f"of a .{kind} by a function, or by what the command has no words for, needs Pillow: pip install pillow; "
                                ".apng needs nothing") from None
        if kind == "webp" and not features.check("webp_anim"):
            raise Error(".webp", "this Pillow writes no films in WebP; .apng needs nothing")
        first, *rest = [image.fromarray(frame.copy()) for frame in self.frames()]
        ends = [round(1000 * (i + 1) / self.fps) for i in range(self.count)]
        if kind == "gif":
            ends = [10 * round(end / 10) for end in ends]  # its clock has hundredths
        delays = [end - begin for begin, end in zip([0, *ends], ends)]
        with tempfile.TemporaryDirectory(prefix="mien-") as folder:
            made = pathlib.Path(folder, f"film.{kind}")
            more: "dict[str, Any]" = {"disposal": 1} if kind == "gif" else {"lossless": True} if self.quality is None else {"quality": self.quality}
            first.save(made, save_all=True, append_images=rest, duration=delays, loop=0, **more)
            return made.read_bytes()

    def by_ffmpeg(self, kind: str) -> bytes:
        program = shutil.which("ffmpeg")
        if program is None:
            raise Error(f".{kind}", "needs ffmpeg, in PATH; .apng, .gif and .webp do not")
        width, height = sides(self.size, self.face.canvas.aspect)
        with tempfile.TemporaryDirectory(prefix="mien-") as folder:
            made = pathlib.Path(folder, f"film.{kind}")
            sound = ["-i", os.fspath(self.sound)] if self.sound is not None else []
            colors = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p", "-colorspace", "bt709",
                      "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"]
            with subprocess.Popen([program, "-v", "error", "-f", "rawvideo", "-pix_fmt", "rgba", "-s", f"{width}x{height}", "-r", f"{self.fps:g}",
                                   "-i", "-", *sound, *colors, *_ENCODERS[kind], made], stdin=subprocess.PIPE, stderr=subprocess.PIPE) as work:
                assert work.stdin and work.stderr
                try:
                    for frame in self.frames():
                        work.stdin.write(frame.tobytes())
                    work.stdin.close()
                except BrokenPipeError:
                    pass  # it says why
                told = work.stderr.read().decode("utf-8", "replace").strip()
            if work.returncode:
                raise Error("ffmpeg", told.splitlines()[-1] if told else f"ended with {work.returncode}")
            return made.read_bytes()


__all__ = ["Film", "animate"]
