#!/usr/bin/env python3
"""Arguments of wrong kinds: each public function tells them by their names: kinds_test.py MIEN SOURCE CASES

CASES exports cases as mien-accuracy does."""
import io
import inspect
import os
import pathlib
import re
import sys
import tempfile
import unittest
import warnings

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
import mien.dask
from mien import distance, people

CASES = sys.argv.pop()
ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = sys.argv.pop()

WRONG = {"none": None, "float": 1.5, "bytes": b"x", "object": object(), "list": [], "nan": float("nan"), "huge": 10**400, "text": "xyz", "complex": 1j,
         "lone": chr(0xd800), "class": int}
# What an annotation takes of these; None where it says Optional or None.
TAKES = {"str": "text", "Path": "text", "Word": "text huge", "Text": "text bytes", "float": "float", "File": "text", "int": "", "bool": "", "Watch": "class"}
# Words of Python and of ctypes that users should not read.
INTERNAL = re.compile(r"ctypes|argument \d|NoneType|not supported between|unsupported operand|has no attribute|embedded null|__\w+__|unexpected keyword|positional|"
                      r"must be real|cannot be interpreted|object is not|codec can't|descriptor|0x[0-9a-f]{6,}")
QUAD, QUADS = [[0, 0], [0.5, 1], [1, 0]], [[[0, 0], [0.5, 1], [1, 0]]]
WIDTHS = [0.1, 0.1, 0.1]
POINT = {"x": "float list nan", "y": "float list nan"}
TOON = (ROOT / "faces/compat/toon.face.json").read_text(encoding="utf-8")
PERSON = mien.from_code("A66CB-AA5S0-14")
CODE = PERSON.code
FACE = mien.read_face_text(TOON)
POSED = FACE.pose()
TRACK = mien.read_motion_text("0\tsil\n0.2\tm\n0.4\tɑː\n0.8\t\n", "a.tsv")
BASIS = mien.fit_basis(numpy.arange(12.0).reshape(4, 3) ** 2, components=1)
PLAN = {"size": 16, "factors": [{"name": "joy", "emotion": "joy", "steps": 2}]}
TABLE = {"who": ["a", "b"], "joy": [1, 2]}
# What drawing takes beyond what its annotations tell; NaN in light is told by the library.
HOW = {"size": "", "background": "none", "region": "none", "light": "none", "out": "none", "effects": "list", "renderer": "none"}
SET_OF_POSE = {name: "none" for name in ("set", "emotions", "muscles", "visemes", "arkit", "facs", "vrm", "azure", "expressions", "basis", "weights", "look_at", "steady")}
POSE = {**SET_OF_POSE, **{name: "none text" for name in ("emotion", "muscle", "viseme", "clip", "frame")}, "clips": "none list", "motions": "none list", "frame": "none text list"}
FILM = {**HOW, "pose": "none"}


def calls():
    """Public functions: what is right for each, and of which of WRONG an argument may be beyond TAKES."""
    folder = pathlib.Path.cwd()
    made = mien.stimuli(PLAN, folder / "made")
    (folder / "a.json").write_text(TOON, encoding="utf-8")
    (folder / "a.tsv").write_text("0\tsil\n0.2\tm\n", encoding="utf-8")
    (folder / "a.morphs.json").write_text(FACE.morphs_text({"cold": FACE}), encoding="utf-8")
    BASIS.save(folder / "a.basis")
    pair = {"one": CODE, "other": CODE}
    place = {"x": 0.5, "y": 0.25}
    return {
        "mien.from_seed": ({"word": "ada"}, {"hold": "none"}), "mien.from_code": ({"code": CODE}, {}), "mien.read_face": ({"path": "a.json"}, {}),
        "mien.read_face_text": ({"words": TOON}, {}), "mien.face_pointers": ({"words": TOON}, {}), "mien.face_text_with": ({"words": TOON, "set": {"yaw": 0}}, {}),
        "mien.read_motion": ({"path": "a.tsv"}, {}), "mien.read_motion_text": ({"words": "0\tsil\n0.2\tm\n"}, {}), "mien.sample": ({"name": "toon"}, {}), "mien.samples": ({}, {}),
        "mien.read_basis": ({"path": "a.basis"}, {}), "mien.fit_basis": ({"frames": numpy.eye(4), "components": 1}, {"components": "none", "variance": "none", "max_error": "none"}),
        "mien.sheet": ({"faces": [FACE], "cell": 8}, {**HOW, "columns": "none"}), "mien.animate": ({"face": FACE, "frames": 1, "size": 8}, {**FILM, "file": "none text"}),
        "mien.chernoff": ({"data": TABLE, "cell": 16}, {"data": "text", "map": "none text list"}), "mien.stimuli": ({"plan": PLAN, "folder": folder / "made"}, {"plan": "text"}),
        "mien.Steady": ({}, {}), "mien.Renderer": ({}, {}), "mien.Stimuli": ({"folder": "made"}, {}), "mien.Picture": ({"pixels": numpy.zeros((2, 2, 4), numpy.uint8)}, {}),
        "mien.crowd": ({"word": "a", "count": 2}, {}), "people.crowd": ({"word": "a", "count": 2}, {}), "people.seed": ({"word": "ada"}, {}), "people.code": ({"of": "ada"}, {"of": "text"}),
        "people.recipe": ({"of": CODE}, {"of": "text"}), "people.in_full": ({"words": people.recipe(CODE)}, {}), "people.hold": ({"person": CODE}, {}), "people.neutral": ({"person": CODE}, {}),
        "people.near": ({"person": CODE}, {}), "people.between": (pair, {}), "people.child": (pair, {}), "people.difference": (pair, {}),
        "people.styles": ({}, {}), "people.parts": ({}, {}), "people.numbers": ({}, {}),
        "distance.quad": ({"points": QUAD, **place}, {**POINT, "out": "none"}), "distance.quads": ({"curves": QUADS, **place}, {**POINT, "out": "none", "curves": "list"}),
        "distance.cubic": ({"points": [*QUAD, [2, 0]], **place}, {**POINT, "out": "none"}), "distance.quad_on_grid": ({"points": QUAD, "origin": (0, 0), "step": 0.1, "columns": 2, "rows": 2}, {}),
        "distance.ellipse": ({"center": (0, 0), "radii": (2, 1), **place}, {**POINT, "out": "none"}),
        "distance.parabola": ({"vertex": (0, 0), "axis": (0, 1), "bend": 1, **place}, {**POINT, "out": "none"}),
        "distance.tapered": ({"points": QUAD, "half_widths": WIDTHS, **place}, {**POINT, "out": "none"}),
        "feet.quad": ({"points": QUAD, **place}, POINT), "feet.quads": ({"curves": QUADS, **place}, {**POINT, "curves": "list"}), "feet.line": ({"a": (0, 0), "b": (1, 1), **place}, POINT),
        "feet.lines": ({"segments": [[[0, 0], [1, 1]]], **place}, {**POINT, "segments": "list"}), "feet.tapered": ({"points": QUAD, "half_widths": WIDTHS, **place}, POINT),
        "feet.tapereds": ({"strokes": QUADS, "half_widths": [WIDTHS], **place}, POINT), "feet.ellipse": ({"center": (0, 0), "radii": (2, 1), **place}, POINT),
        "lab.check": ({"solver": distance.quad, "count": 1, "program": CASES}, {"solver": "class"}), "lab.check_feet": ({"solver": distance.feet.quad, "count": 1, "program": CASES}, {"solver": "class"}),
        "dask.submit": ({"plan": "a.json", "client": _Client(), "folder": "out"}, {"parts": "none"}), "dask.join": (None, {}),
        **methods(made, folder)}


def methods(made, folder):
    """The same of methods, by an object that has them."""
    film = FACE.animate(frames=1, size=8)
    assert film
    place = {"x": 0.1, "y": 0.1}
    return {
        (mien.Face, "from_seed"): (mien.Face, {"word": "ada"}, {"hold": "none"}), (mien.Face, "from_code"): (mien.Face, {"code": CODE}, {}), (mien.Face, "with_style"): (PERSON, {"style": "ink"}, {}),
        (mien.Face, "pose"): (FACE, {}, POSE), (mien.Face, "speak"): (FACE, {"track": TRACK, "time": 0.1}, POSE), (mien.Face, "follow"): (FACE, {"frame": {"jawOpen": 0.1}}, {**POSE, "frame": "text list"}),
        (mien.Face, "unfollowed"): (FACE, {"motion": TRACK}, {}), (mien.Face, "fit_basis"): (FACE, {"count": 2, "components": 1}, POSE), (mien.Face, "render"): (FACE, {"size": 8}, HOW),
        (mien.Face, "for_device"): (FACE, {"format": "mono", "size": 8}, HOW), (mien.Face, "save"): (FACE, {"file": io.BytesIO(), "size": 8}, {**HOW, "depth": "none"}),
        (mien.Face, "svg"): (FACE, {"size": 8}, HOW), (mien.Face, "to_pil"): (FACE, {"size": 8}, HOW), (mien.Face, "frames"): (FACE, {"count": 1, "size": 8}, FILM),
        (mien.Face, "animate"): (FACE, {"frames": 1, "size": 8}, {**FILM, "file": "none text"}), (mien.Face, "with_morphs"): (FACE, {"path": "a.morphs.json"}, {}),
        (mien.Face, "with_morphs_text"): (FACE, {"words": (folder / "a.morphs.json").read_text(encoding="utf-8")}, {}), (mien.Face, "morphs_text"): (FACE, {"shapes": {"cold": FACE}}, {}),
        (mien.Posed, "render"): (POSED, {"size": 8}, HOW), (mien.Posed, "for_device"): (POSED, {"format": "mono", "size": 8}, HOW), (mien.Posed, "debug"): (POSED, {"which": "regions", "size": 8}, HOW),
        (mien.Posed, "svg"): (POSED, {"size": 8}, HOW), (mien.Posed, "save"): (POSED, {"file": io.BytesIO(), "size": 8}, {**HOW, "depth": "none"}), (mien.Posed, "to_pil"): (POSED, {"size": 8}, HOW),
        (mien.Posed, "layer_at"): (POSED, place, {}), (mien.Posed, "feature_at"): (POSED, place, {}), (mien.Posed, "distance"): (POSED, {"layer": 0, **place}, {"layer": "text"}),
        (mien.Posed, "face_from_pixel"): (POSED, {"x": 1, "y": 1, "size": 8}, HOW), (mien.Posed, "pixel_from_face"): (POSED, {**place, "size": 8}, HOW),
        (mien.Motion, "value"): (TRACK, {"channel": TRACK.channels[0], "time": 0.1}, {}), (mien.Basis, "decode"): (BASIS, {}, {"weights": "none"}), (mien.Basis, "encode"): (BASIS, {"frames": numpy.eye(3)}, {}),
        (mien.Basis, "save"): (BASIS, {"path": "b.basis"}, {}), (mien.Picture, "save"): (mien.sheet([FACE], cell=8), {"file": io.BytesIO()}, {}), (mien.Picture, "to_pil"): (mien.sheet([FACE], cell=8), {}, {}),
        (mien.Chernoff, "save"): (mien.chernoff(TABLE, cell=16), {"file": io.BytesIO()}, {}), (mien.Chernoff, "to_pil"): (mien.sheet([FACE], cell=8), {}, {}),
        (mien.Stimuli, "save"): (made, {"file": io.BytesIO()}, {})}


class _Client:
    """What a cluster's client does here."""

    def nthreads(self):
        return {"here": 1}

    def submit(self, *words, **how):
        return words


MODULES = {"mien": mien, "people": people, "distance": distance, "feet": distance.feet, "lab": mien.lab, "dask": mien.dask}
# Records, and what the package alone makes; these refuse everything else, which Made tests.
PLAIN = (mien.Canvas, mien.Name, mien.Stats, mien.Svg, mien.EditedText)
MADE = (mien.Face, mien.Posed, mien.Basis, mien.Motion, mien.Film, mien.Chernoff)


def public():
    """Everything public that is called: functions by a text, methods by class and name."""
    found = set()
    for at, module in MODULES.items():
        for name in module.__all__:
            one = None if name == "widget" else getattr(module, name)
            if inspect.isfunction(one) or inspect.isclass(one) and not issubclass(one, (Exception, *PLAIN, *MADE)) and not issubclass(one, tuple) or one is mien.Picture:
                found.add(f"{at}.{name}")
            if inspect.isclass(one) and not issubclass(one, (Exception, tuple)):
                found |= {(one, method) for method in dir(one) if not method.startswith("_") and callable(getattr(one, method))}
    return found


def takes(parameter):
    """Which of WRONG are right by the annotation; None where it has no plain one."""
    kinds = str(parameter.annotation).strip("'\"")
    inner = re.fullmatch(r"Optional\[(.*)\]", kinds)
    found = TAKES.get(inner[1] if inner else kinds)
    return None if found is None else found + (" none" if inner else "")


class Kinds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        before = os.getcwd()
        os.chdir(folder.name)
        self.addCleanup(os.chdir, before)
        warnings.simplefilter("ignore", mien.Warned)

    def test_all_functions_stand_in_the_table(self):
        self.assertEqual({str(one) for one in public()} ^ {str(one) for one in calls()}, set())

    def test_wrong_ones_are_told_by_their_names(self):
        wrong = []
        for at, (*of, right, more) in calls().items():
            if right is None:
                continue
            function = getattr(of[0], at[1]) if of else getattr(MODULES[at.split(".")[0]], at.split(".")[1])
            self.run_one(function, right)
            for name, parameter in inspect.signature(function).parameters.items():
                well = more.get(name, takes(parameter) or "").split() + (["none"] if parameter.default is None else [])
                for kind, value in WRONG.items():
                    if parameter.kind is parameter.VAR_POSITIONAL:
                        said = self.told(lambda: function(*right.values(), value)) if kind != "text" else None
                    else:
                        said = self.told(lambda: self.run_one(function, {**right, name: value}))
                    fault = self.fault(name, said, kind in well)
                    if fault and not (parameter.kind is parameter.VAR_POSITIONAL and kind == "text"):
                        wrong.append(f"{at}({name}={kind}): {fault}")
        self.assertEqual(wrong, [], "\n" + "\n".join(wrong))

    def run_one(self, function, words):
        made = function(**words)
        return list(made) if inspect.isgenerator(made) else made

    def told(self, call):
        try:
            call()
        except BaseException as error:
            return error
        return None

    def fault(self, name, error, is_right):
        if error is None:
            return None if is_right else "is taken"
        text = str(error)
        if not isinstance(error, (TypeError, mien.Error)):
            return f"{type(error).__name__}: {text}"
        if INTERNAL.search(text):
            return f"tells internals: {text}"
        return None if is_right or re.search(rf"\b{name}\b", text) else f"is told without its name: {text}"

    def test_what_the_package_makes_is_made_by_it(self):
        for one in (mien.Face, mien.Basis):
            for value in WRONG.values():
                with self.assertRaisesRegex(TypeError, "is made by"):
                    one(value)
        for call in (lambda: mien.Posed(FACE, 5, {}), lambda: mien.Motion("a", b"", ""), lambda: mien.Film(None, "gif", "x"), lambda: mien.Film(None, "odd", b"")):
            with self.assertRaisesRegex(TypeError, "is made by"):
                call()


class Names(unittest.TestCase):
    def test_arguments_have_them(self):
        for call, words in ((lambda: FACE.pose("joy"), r'^pose: arguments have names: pose\(emotion="joy"\)$'), (lambda: FACE.pose({"joy": 1}), r"pose\(emotions=\{'joy': 1\}\)"),
                            (lambda: FACE.pose(2), r"pose\(time=2\)"), (lambda: POSED.render(8, "slice"), r'render: arguments after size have names: render\(size=…, fit="slice"\)'),
                            (lambda: FACE.render(8, "slice"), r'fit="slice"'), (lambda: mien.from_seed("ada", "ink"), r'from_seed\(word=…, style="ink"\)'),
                            (lambda: FACE.animate(None, 2.5), r"animate: .*seconds=2.5"), (lambda: mien.sheet([FACE], 3), r"sheet: .*columns=3"),
                            (lambda: mien.lab.check(distance.quad, 10), r"check: .*count=10"), (lambda: mien.fit_basis(numpy.eye(3), 2), r"fit_basis: .*components=2"),
                            (lambda: FACE.speak(TRACK, 0.1, "joy"), r'speak: .*emotion="joy"'), (lambda: distance.quad(QUAD, 1, 2, None), "quad: arguments after y have names"),
                            (lambda: mien.crowd("a", 1, 2), "crowd: expected word and count, got 1 more"), (lambda: mien.samples(1), "samples: expected no arguments, got 1 more"),
                            (lambda: mien.crowd("a"), 'crowd: the argument "count" is missing'), (lambda: mien.crowd(), '"word" is missing'), (lambda: mien.crowd("a", word="b"), '"word" is given twice')):
            with self.assertRaisesRegex(TypeError, words):
                call()

    def test_unknown_ones_are_told(self):
        for call, words in ((lambda: mien.lab.check(distance.quad, cuont=10), 'check: no argument named "cuont"; did you mean "count"'),
                            (lambda: mien.lab.check_feet(distance.quad, sed=10), 'did you mean "seed"'), (lambda: people.near(CODE, sede=1), 'did you mean "seed"'),
                            (lambda: mien.crowd("a", cuont=1), 'did you mean "count"'), (lambda: distance.quad(QUAD, 1, 1, accurat=True), 'did you mean "accurate"'),
                            (lambda: POSED.svg(8, tolerence=1), 'did you mean "tolerance"'), (lambda: FACE.speak(TRACK, 0.1, yawn=1), 'did you mean "yaw"'),
                            (lambda: FACE.fit_basis(2, componets=1), 'did you mean "components"'), (lambda: mien.Steady(cutof=1), 'Steady: .*did you mean "cutoff"')):
            with self.assertRaisesRegex(TypeError, words):
                call()

    def test_are_seen_by_help(self):
        for function, name in ((FACE.render, "fit"), (mien.sheet, "background"), (FACE.speak, "emotion"), (FACE.animate, "quality")):
            self.assertIn(name, inspect.signature(function).parameters)


class Texts(unittest.TestCase):
    def test_have_no_end_before_their_end(self):
        for call, words in ((lambda: mien.read_face("a\0b"), "path: a path has no NUL"), (lambda: mien.lab.check(abs, program="a\0b"), "program: a path has no NUL"),
                            (lambda: mien.chernoff(TABLE, style="a\0b"), "style: no style named"), (lambda: FACE.morphs_text({"a\0b": FACE}), "shapes: a name has no NUL"),
                            (lambda: mien.face_text_with(TOON, {"yaw\0b": 1}), "set: a name has no NUL"), (lambda: mien.from_seed("a", hold={"age": object()}), r"hold\['age'\]: expected a number, got <object object>"),
                            (lambda: mien.chernoff({"who": [chr(0xd800)], "a": [1]}), "^data:2")):
            with self.assertRaisesRegex((TypeError, mien.Error), words):
                call()


class Seeds(unittest.TestCase):
    def test_are_words_and_whole_numbers_are_their_texts(self):
        self.assertEqual(mien.from_seed(42), mien.from_seed("42"))
        self.assertEqual(mien.from_seed(numpy.int64(42)), mien.from_seed("42"))
        self.assertEqual(mien.crowd(42, 3), mien.crowd("42", 3))
        self.assertEqual(people.seed(42), people.seed("42"))
        self.assertEqual(people.near(CODE, 0.5, 3), people.near(CODE, 0.5, "3"))
        self.assertEqual(people.child(CODE, people.code("bob"), 3), people.child(CODE, people.code("bob"), "3"))
        self.assertEqual(people.code(people.seed("42")), people.code("42"))
        self.assertEqual(people.recipe(people.seed("42")), people.recipe(people.code("42")))
        for wrong in (True, 1.0, numpy.zeros(1, int)):
            with self.assertRaisesRegex(TypeError, "word: expected a word or a whole number"):
                mien.from_seed(wrong)
        with self.assertRaisesRegex(mien.Error, "word: has too many digits"):
            mien.from_seed(10**5000)

    def test_of_plans_are_words(self):
        with tempfile.TemporaryDirectory() as folder:
            def drawn(seed):
                plan = {"size": 16, "seed": seed, "sample": 2, "factors": [{"name": "who", "people": 3, "seed": seed}]}
                return [one["sha256"] for one in mien.stimuli(plan, folder).records]
            self.assertEqual(drawn(42), drawn("42"))
            self.assertEqual(drawn(numpy.int32(7)), drawn("7"))
            with self.assertRaisesRegex(TypeError, r"plan: factors\[0\].seed: expected a word or a whole number, got 1.5"):
                drawn(1.5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
