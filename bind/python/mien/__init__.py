"""mien: a face goes in, an exact picture comes out.

    import mien
    face = mien.from_seed("ada")             # or from_code, read_face
    face                                     # in a notebook, a picture
    posed = face.pose(emotion="joy", yaw=20, blink=0.3)
    posed.save("ada.png", size=2048)
    pixels = posed.render((1920, 1080))      # a NumPy array (1080, 1920, 4)
    face.animate("ada.gif", seconds=2, size=256)

`mien.distance` has distances from points to curves, `mien.people` people by codes, `mien.lab` a laboratory for solvers, `mien.widget`
a face in a notebook that is posed by sliders. What is wrong raises `mien.Error`, a ValueError with an address and a sentence. The work
is done by libmien_c; while it runs, other threads of Python run, too.
"""
import importlib
from typing import TYPE_CHECKING

try:
    import numpy as _numpy
except ImportError as _missing:
    raise ImportError("mien needs NumPy: pip install numpy, or apt install python3-numpy") from _missing

from . import distance, people
from ._basis import Basis, fit_basis, read_basis
from ._data import Chernoff, Stimuli, chernoff, stimuli
from ._errors import Cancelled, Error, FileError, ForbiddenFile, MissingFile, Warned
from ._face import EditedText, Face, face_pointers, face_text_with, from_code, from_seed, read_face, read_face_text
from ._film import Film, animate
from ._library import lib as _lib
from ._library import text as _text
from ._motion import Motion, Steady, read_motion, read_motion_text
from ._names import Canvas, Name
from ._picture import Renderer, Stats
from ._posed import Posed, Svg
from ._samples import sample, samples
from ._saved import Picture
from ._sheet import sheet
from .people import crowd

if TYPE_CHECKING:
    from . import lab, widget

__version__: str = _text(_lib.mien_version_text())
__all__ = ["Basis", "Cancelled", "Canvas", "Chernoff", "EditedText", "Error", "Face", "FileError", "Film", "ForbiddenFile", "MissingFile", "Motion",
           "Name", "Picture", "Posed", "Renderer", "Stats", "Steady", "Stimuli", "Svg", "Warned", "animate", "chernoff", "crowd", "distance",
           "face_pointers", "face_text_with", "fit_basis", "from_code", "from_seed", "lab", "people", "read_basis", "read_face", "read_face_text",
           "read_motion", "read_motion_text", "sample", "samples", "sheet", "stimuli", "widget"]


def __getattr__(name: str) -> object:
    """`mien.lab` and `mien.widget` are loaded when they are used first."""
    if name in ("lab", "widget"):
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module 'mien' has no attribute {name!r}")
