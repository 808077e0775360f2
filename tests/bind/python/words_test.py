#!/usr/bin/env python3
"""The words of poses and pictures, and what is said about wrong ones: words_test.py SOURCE"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
from mien import _colors, distance, people

ROOT = pathlib.Path(sys.argv.pop())
PERSON = mien.from_code("A66CB-AA5S0-14")


class Poses(unittest.TestCase):
    def same(self, one, other):
        numpy.testing.assert_array_equal(PERSON.pose(**one).vector, PERSON.pose(**other).vector)
        self.assertTrue((PERSON.pose(**one).vector != PERSON.vector).any(), one)

    def test_any_set_is_said_by_its_name(self):
        self.assertEqual(PERSON.pose(expressions={"arkit": {"jawOpen": 0.5}}), PERSON.pose(arkit={"jawOpen": 0.5}))
        self.assertNotEqual(PERSON.pose(expressions={"arkit": {"jawOpen": 0.5}}), PERSON.pose())

    def test_people_are_neutral_when_asked(self):
        smiling = people.hold(people.code("ada"), "smile=0.9")
        calm = mien.from_code(smiling, neutral=True)
        self.assertEqual(calm, mien.from_code(people.neutral(smiling)))
        self.assertNotEqual(calm, mien.from_code(smiling))
        self.assertEqual(people.neutral(people.neutral(smiling)), people.neutral(smiling))
        self.assertEqual(mien.from_seed("ada", neutral=True), mien.from_code(people.neutral(people.code("ada"))))
        self.assertEqual(mien.from_seed("ada", neutral=True, hold={"smile": 0.9}), mien.from_code(people.hold(people.neutral(people.code("ada")), "smile=0.9")))

    def test_things_are_held_as_texts_or_as_a_table(self):
        ada = people.code("ada")
        self.assertEqual(people.hold(ada, {"glasses": None, "age": 30}), people.hold(ada, "glasses=none", "age=30"))
        self.assertEqual(mien.from_seed("ada", hold={"beard": None}), mien.from_code(people.hold(ada, "beard=none")))
        with self.assertRaisesRegex(TypeError, r"hold\['age'\]: expected a number"):
            people.hold(ada, {"age": object()})

    def test_have_the_words_of_the_command_and_of_javascript(self):
        self.same({"blink": 0.5, "yaw": 20, "pitch": -5, "roll": 3, "bias": 0.1},
                  {"set": {"blink": 0.5, "yaw": 20, "pitch": -5, "roll": 3, "bias": 0.1}})
        self.same({"blink": 0.5}, {"blink": numpy.float32(0.5)})
        self.same({"emotion": "joy"}, {"emotions": {"joy": 1}})
        self.same({"emotion": "joy=0.5"}, {"emotions": {"joy": 0.5}})
        self.same({"emotion": {"joy": 0.5}}, {"emotions": {"joy": 0.5}, "blink": None, "clips": None})
        self.same({"emotion": "joy", "emotions": {"fear": 0.5}}, {"emotions": {"fear": 0.5, "joy": 1}})
        self.same({"muscle": "jaw=0.4"}, {"muscles": {"jaw": 0.4}})
        self.same({"viseme": "aa"}, {"visemes": {"aa": 1}})
        for words in ({"visemes": {"aa": 0.7}}, {"arkit": {"jawOpen": 0.5}}, {"facs": {"AU12": 0.6}}, {"vrm": {"happy": 1}}, {"azure": {"2": 1}}):
            self.same(words, words)
        self.same({"clip": "feelings", "time": 1}, {"clips": ["feelings"], "time": 1})
        self.same({"clip": ("feelings", 0.5), "time": 1}, {"clips": [("feelings", 0.5, 0)], "time": 1})
        track = mien.read_motion_text("0\tsil\n0.2\tm\n0.4\tɑː\n0.8\t\n", "a.tsv")
        self.same({"motions": track, "time": 0.5}, {"motions": [(track, 1)], "time": 0.5})
        self.same({"frame": {"jawOpen": numpy.float64(0.5)}}, {"arkit": {"jawOpen": 0.5}})
        self.same({"set": {"yaw": True}}, {"yaw": 1})

    def test_of_other_kinds_are_refused_in_a_sentence(self):
        joy = {"joy": 1}
        for words, said in (({"clips": "idle"}, r'clips: expected a list, such as \["idle"\], got \'idle\''), ({"emotions": "joy"}, "emotions: expected strengths by name"),
                            ({"emotions": ["joy"]}, "strengths by name"), ({"emotion": ["joy"]}, "emotion: expected"), ({"visemes": "aa"}, "visemes"),
                            ({"set": "blink=1"}, "set: expected values by name"), ({"set": [("blink", 1)]}, "values by name"), ({"blink": "shut"}, "blink: expected a number"),
                            ({"yaw": [1, 2]}, "yaw: expected a number"), ({"time": "noon"}, "time: expected a number"), ({"look_at": "here"}, "look_at: expected a list"),
                            ({"look_at": 3}, "look_at"), ({"look_at": ["a", "b", "c"]}, "look_at: expected real numbers"), ({"emotions": {"joy": "much"}}, r"emotions\['joy'\]: expected a number"),
                            ({"emotions": {"joy": None}}, "expected a number"), ({"emotions": {"joy": numpy.zeros(2)}}, "expected a number"), ({"clips": {"idle": 1}}, "clips: expected a list"),
                            ({"motions": "talk.tsv"}, "motions: expected a list"), ({"frame": {1, 2}}, "frame"), ({"basis": "a.basis"}, "basis: expected a mien.Basis"),
                            ({"frame": joy, "steady": 1.5}, "steady"), ({"set": {"blink": None}}, "blink"), ({"set": {"blink": {}}}, "blink"),
                            ({"set": {"blink": 1j}}, "complex"), ({"set": {"blink": [[1], [2, 3]]}}, "blink"), ({"set": {"blink": numpy.array("2020", "M8")}}, "datetime"),
                            ({"set": {"blink": numpy.ma.masked_array([1.0], [True])}}, "masked"), ({"pose": 1}, "no argument named"), ({"mouths": 1}, "no argument named"),
                            ({"expressions": "arkit"}, "expressions: expected sets by name"), ({"expressions": {"arkit": "jawOpen"}}, r"expressions\['arkit'\]: expected strengths")):
            with self.subTest(words), self.assertRaisesRegex(TypeError, said):
                PERSON.pose(**words)
        for words, said in (({"motions": ["talk.tsv"]}, "motions"), ({"clips": [("idle",)]}, "clips"), ({"clips": [(1, 2)]}, "clips"), ({"emotion": "happy"}, 'did you mean "joy"'),
                            ({"viseme": "zz"}, "viseme"), ({"set": {"yaww": 1}}, 'did you mean "yaw"'), ({"emotion": "joy=lots"}, "joy=lots"),
                            ({"set": {"blink": numpy.nan}}, "finite"), ({"set": {"blink": []}}, "blink"), ({"look_at": (numpy.inf, 0, 1)}, "finite")):
            with self.subTest(words), self.assertRaisesRegex(mien.Error, said):
                PERSON.pose(**words)


class Pictures(unittest.TestCase):
    def test_have_colours_by_name(self):
        self.assertEqual(len(_colors.NAMES), 148)
        posed = PERSON.pose()
        for name, hexadecimal in (("white", "#ffffff"), ("RebeccaPurple", "#663399"), ("#fff", "#ffffff"), ("#0f08", "#00ff0088")):
            numpy.testing.assert_array_equal(posed.render(16, background=name), posed.render(16, background=hexadecimal))
        numpy.testing.assert_array_equal(posed.render(16, background=numpy.array([1.0, 1, 1])), posed.render(16, background="white"))
        toon = mien.read_face(ROOT / "faces/compat/toon.face.json")
        numpy.testing.assert_array_equal(toon.pose(set={"palette/skin": "tomato"}).vector, toon.pose(set={"palette/skin": "#ff6347"}).vector)
        for color, said in (("whit", 'no colour named "whit"; did you mean "white"'), ("#12345", "#rrggbb"), ((255, 255, 255), "'#ffffff'"), ((1, 2), "3 or 4"), ("", "colour")):
            with self.assertRaisesRegex(mien.Error, said):
                posed.render(16, background=color)
        try:
            from PIL import ImageColor
        except ImportError:
            return
        self.assertEqual({name: ImageColor.getrgb(name) for name in _colors.NAMES}, {name: ImageColor.getrgb(digits) for name, digits in _colors.NAMES.items()})

    def test_tell_what_is_said_instead(self):
        posed = PERSON.pose()
        for words, said in (({"width": 3}, r"no argument named \"width\"; say size=\(width, height\)"), ({"depth": "u8"}, "say dtype="), ({"bg": "red"}, "say background="),
                            ({"backgroud": "red"}, 'did you mean "background"'), ({"region": "abcd"}, "region: expected a list"), ({"light": "left"}, "light: expected a list"),
                            ({"effects": "grid:4"}, "effects: expected a list"), ({"background": 7}, None), ({"background": {"a": 1}}, "background"), ({"size": "64"}, "size"), ({"size": 6.4}, "size")):
            with self.subTest(words), self.assertRaisesRegex((TypeError, mien.Error), said or ""):
                posed.render(**{"size": 16, **words})

    def test_take_numbers_of_every_kind_but_wrong_ones(self):
        frames = numpy.arange(12, dtype=numpy.int32).reshape(4, 3) ** 2
        self.assertEqual(mien.fit_basis(frames, components=1), mien.fit_basis(frames.astype(float), components=1))
        basis = mien.fit_basis(frames, components=1)
        for call in (lambda of: mien.fit_basis(of, components=1), basis.encode, basis.decode, lambda of: distance.quad(of, 1, 1), lambda of: distance.feet.quad(of, 1, 1),
                     lambda of: distance.quads(of, 1, 1)):
            for wrong in ("text", ["a", "b"], [[1], [2, 3]], numpy.zeros((4, 3), complex), numpy.array([[None, 1]] * 3), numpy.zeros((4, 3), "M8[s]"),
                          numpy.ma.masked_array(frames, frames > 3), {"a": 1}, object()):
                with self.assertRaises(TypeError):
                    call(wrong)


class Names(unittest.TestCase):
    def test_are_public_in_one_place(self):
        for name in ("Error", "Cancelled", "FileError", "MissingFile", "ForbiddenFile", "Warned"):
            self.assertEqual(getattr(mien, name).__module__, "mien")
        with self.assertRaises(mien.Error) as caught:
            mien.from_code("AAAA")
        self.assertIn("code AAAA", str(caught.exception))
        self.assertEqual([name for name in mien.__all__ if name != "widget" and not hasattr(mien, name)], [])  # which may need what is not here
        with self.assertRaisesRegex(AttributeError, "no attribute 'lap'"):
            mien.lap
        with self.assertRaisesRegex(TypeError, "mien.from_seed, mien.from_code, mien.read_face"):
            mien.Face("ada")

    def test_tell_what_people_are_made_of(self):
        self.assertIn("bob", people.parts()["hair"])
        self.assertIn("ink", people.styles())
        lo, hi, rest = people.numbers()["eye.size"]
        self.assertTrue(lo < rest < hi)
        self.assertIn("toon", mien.samples())
        with self.assertRaisesRegex(mien.Error, 'no sample face named "tonn"; did you mean "toon"'):
            mien.sample("tonn")

    def test_the_laboratory_comes_when_it_is_asked_and_names_its_package(self):
        program = "import sys, mien; print('mien.lab' in sys.modules); mien.lab.check(abs, program='/no/mien-accuracy')"
        said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual(said.stdout, "False\n")
        self.assertRegex(said.stderr, r"mien.Error: /no/mien-accuracy: cannot be run: .*; it is in the package mien-accuracy, or built with -DMIEN_BUILD_ACCURACY=ON")

    def test_without_numpy_a_sentence_says_so(self):
        said = subprocess.run([sys.executable, "-c", "import sys; sys.modules['numpy'] = None; import mien"], capture_output=True, text=True)
        self.assertIn("ImportError: mien needs NumPy: pip install numpy", said.stderr)

    def test_nothing_is_written_at_home(self):
        with tempfile.TemporaryDirectory() as home:
            program = "import mien, pickle; face = mien.sample('toon'); pickle.loads(pickle.dumps(face)).render(16); face.animate(frames=1, size=16)"
            subprocess.run([sys.executable, "-c", program], check=True, cwd=home, env={**os.environ, "HOME": home, "XDG_CACHE_HOME": home})
            self.assertEqual(os.listdir(home), [])
            # And where there is no home at all, as for a service.
            subprocess.run([sys.executable, "-c", program], check=True, cwd="/", env={**os.environ, "HOME": "/proc/none"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
