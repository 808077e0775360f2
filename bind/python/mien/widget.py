"""A face in a notebook that is posed by sliders, by anywidget: in Jupyter, Colab, VS Code and marimo.

    from mien.widget import FaceWidget
    shown = FaceWidget(mien.from_seed("ada"))       # the cell's last line shows it
    shown.values = {"emotion.joy": 0.8, "yaw": 20}  # moves its sliders
    shown.posed.save("ada.png")                     # as it is posed now

The page draws the face itself where the package has the web package inside, as wheels may; else the kernel draws.
"""
from __future__ import annotations

import importlib
import math
import pathlib
from typing import Any, Mapping, Optional, Sequence

from ._errors import Error
from ._face import Face
from ._kinds import listed, said, table
from ._library import hinted, unknown_name
from ._picture import Size, sides
from ._posed import Posed

try:
    _anywidget: Any = importlib.import_module("anywidget")
    _traitlets: Any = importlib.import_module("traitlets")
except ImportError:
    raise ImportError("mien.widget needs anywidget: pip install anywidget") from None

_HERE = pathlib.Path(__file__).resolve().parent
_MODULES = ("mien.js", "pose_keys.js", "wasm_host.js")
_FIRST = ("yaw", "pitch", "gaze.x", "gaze.y", "blink", "jaw.open")  # sliders beside the emotions


def web_package() -> Optional[pathlib.Path]:
    """The folder with mien.wasm: in the package, or as the build of the source made it."""
    places = (_HERE / "share/mien/web", _HERE.parents[2] / "build/web/bind/web/package", *(_HERE.parents[i] / "share/mien/web" for i in range(3, min(5, len(_HERE.parents)))))
    return next((place for place in places if (place / "mien.wasm").is_file()), None)


class FaceWidget(_anywidget.AnyWidget):  # type: ignore[misc]
    """A face with sliders. `values` are those of its controls now."""

    _esm = _HERE / "widget.js"
    values = _traitlets.Dict().tag(sync=True)
    sliders = _traitlets.List().tag(sync=True)
    size = _traitlets.Tuple().tag(sync=True)
    label = _traitlets.Unicode().tag(sync=True)
    _picture = _traitlets.Bytes().tag(sync=True)
    _text = _traitlets.Unicode().tag(sync=True)
    _modules = _traitlets.Dict().tag(sync=True)
    _wasm = _traitlets.Bytes().tag(sync=True)

    @hinted
    def __init__(self, face: Face, sliders: Optional[Sequence[str]] = None, *, size: Size = 320, values: Optional[Mapping[str, float]] = None) -> None:
        """`sliders` are names of controls, of `face.names`; default emotions, the head, the gaze, lids and jaw. A slider's range is the
        control's, or 0 to 1 where that has no end."""
        if not isinstance(face, Face):
            raise TypeError(f"face: expected a face, got {said(face)}")
        self.face = face
        names = [one for one in (*(f"emotion.{one}" for one in face.emotions), *_FIRST) if one in face.names] if sliders is None else (
            listed(sliders, "sliders", '["emotion.joy"]'))
        package = web_package() if face.text and not (face._source.beside or face._source.morphs) else None
        made = {"_wasm": (package / "mien.wasm").read_bytes(), "_modules": {one: (package / one).read_text(encoding="utf-8") for one in _MODULES},
                "_text": face.text} if package else {}
        super().__init__(sliders=[_slider(face, one) for one in names], size=sides(size, face.canvas.aspect), label=face.title or "a drawn face",
                         values=dict(table({} if values is None else values, "values", 'values by name, such as {"yaw": 20}')), **made)
        self._draw()
        self.observe(self._draw, names=["values"])

    @property
    def posed(self) -> Posed:
        """The face as it is posed now."""
        return self.face.pose(set=self.values)

    def _draw(self, change: object = None) -> None:
        """The picture at the beginning also stands in notebooks that nobody runs."""
        if change is None or not self._wasm:
            self._picture = self.posed._drawn_png((self.size[0], self.size[1]))


def _slider(face: Face, name: str) -> "dict[str, Any]":
    known = face.names.get(name)
    if known is None or not known.is_control:
        raise Error("sliders", unknown_name("control", str(name), [one for one, what in face.names.items() if what.is_control]))
    lo, hi = known.range
    return {"name": name, "lo": lo if math.isfinite(lo) else 0, "hi": hi if math.isfinite(hi) else 1}
