"""mien: a face goes in, an exact picture comes out.

    import mien
    face = mien.read_face("faces/toon.face.json")
    posed = face.pose(time=1.25, set={"gaze.x": 0.04}, emotions={"joy": 0.8})
    pixels = posed.render((1920, 1080))      # a NumPy array (1080, 1920, 4)
    posed.save("toon.png", size=7680)
    posed                                    # in a notebook, a picture

`mien.distance` has distances from points to curves, `mien.people` people by codes. What is wrong raises `mien.Error`,
a ValueError with an address and a sentence. The work is done by libmien_c; while it runs, other threads of Python run, too.
"""
from . import distance, lab, people
from ._basis import Basis, fit_basis, read_basis
from ._face import Canvas, EditedText, Face, Name, Posed, Svg, face_pointers, face_text_with, from_code, read_face, read_face_text
from ._library import Cancelled, Error
from ._motion import Motion, Steady, read_motion, read_motion_text
from ._library import lib as _lib
from ._library import text as _text
from ._picture import Renderer, Stats
from .people import crowd

__version__: str = _text(_lib.mien_version_text())
__all__ = ["Basis", "Cancelled", "Canvas", "EditedText", "Error", "Face", "Motion", "Name", "Posed", "Renderer", "Stats", "Steady", "Svg", "crowd", "distance", "face_pointers", "face_text_with", "fit_basis", "from_code",
           "lab", "people", "read_basis", "read_face", "read_face_text", "read_motion", "read_motion_text"]
