#!/usr/bin/env python3
"""Faces, their texts, motions and poses: faces_test.py MIEN ROOT"""
import gc
import json
import math
import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import time
import unittest
import warnings
import xml.dom.minidom

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
import mien._library
from mien import people

ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = MIEN = sys.argv.pop()
TOON = ROOT / "faces/compat/toon.face.json"


def toon():
    return mien.read_face(TOON)


class Faces(unittest.TestCase):
    def test_say_what_they_are(self):
        face = toon()
        self.assertIn(face.title, repr(face))
        self.assertIsInstance(face.credit, str)
        x0, y0, x1, y1 = face.canvas.box
        self.assertTrue(x0 < x1 and y0 < y1 and face.canvas.unit)
        self.assertGreater(len(face.names), 100)
        blink = face.names["blink"]
        self.assertEqual((blink.range, blink.value, blink.is_control), ((0, 1), 0, True))
        self.assertTrue(face.clips)
        slices = [name for name in face.names.values() if not name.is_control]
        rest = numpy.concatenate([numpy.ravel(name.value) for name in slices])
        numpy.testing.assert_array_equal(rest, face.vector)
        self.assertEqual([name.begin for name in slices][:2], [0, numpy.size(slices[0].value)])
        with self.assertRaises(TypeError):
            face.names["blink"] = 1

    def test_names_are_those_of_the_command(self):
        listed = subprocess.run([MIEN, "list", TOON], capture_output=True, text=True, check=True).stdout
        for name in toon().names:
            self.assertIn(name, listed)

    def test_come_from_memory_and_codes(self):
        text = TOON.read_text(encoding="utf-8")
        for words in (text, text.encode()):
            numpy.testing.assert_array_equal(mien.read_face_text(words).vector, toon().vector)
        code = mien.crowd("chorus", 2)[1]
        person = mien.from_code(code)
        self.assertEqual(person.emotions[:1], ("joy",))
        again = mien.read_face_text(people.recipe(code))
        numpy.testing.assert_array_equal(person.vector, again.vector)

    def test_words_that_people_use_are_understood(self):
        person = mien.from_code(mien.crowd("chorus", 1)[0])
        for call, raised, what in (
                (lambda: person.pose(emotions={"happiness": 1}), mien.Error, 'did you mean "joy"?'),
                (lambda: person.pose(emotions={"scared": 1}), mien.Error, 'did you mean "fear"?'),
                (lambda: person.pose(expressions={"arkit": {"jawOpn": 1}}), mien.Error, 'did you mean "jawOpen"?'),
                (lambda: person.pose(time=float("nan")), mien.Error, "finite"),
                (lambda: person.pose(yaws=20), TypeError, 'pose: no argument named "yaws"; did you mean "yaw"?'),
                (lambda: person.pose(emotoins={"joy": 1}), TypeError, 'did you mean "emotions"?'),
                (lambda: person.pose().render(64, bg="#fff"), TypeError, 'say background=')):
            with self.assertRaises(raised) as caught:
                call()
            self.assertIn(what, str(caught.exception))

    def test_errors_are_sentences(self):
        for call, where, what in (
                (lambda: mien.read_face("no/such.json"), "no/such.json", ""),
                (lambda: mien.read_face_text("{", "mine"), "mine:1:", ""),
                (lambda: mien.from_code("AA7Q2-MKX4T-XM"), "", ""),
                (lambda: toon().pose(set={"gaze.z": 1}), "gaze.z=1", 'did you mean "gaze.x"?'),
                (lambda: toon().pose(set={"blink": float("nan")}), "blink=nan", "finite"),
                (lambda: toon().pose(set={"blink": [1, 2]}), "blink=1.0,2.0", "expected 1 number, got 2"),
                (lambda: toon().pose(emotions={"none": 1}), "", "emotion"),
                (lambda: toon().pose(clips=["none"]), "none", "clip"),
                (lambda: toon().pose(clips=[("a", 1, 2, 3)]), "clips", "expected a name, (name, weight)"),
                (lambda: toon().pose(look_at=(1, 2)), "look_at", "got 2 numbers"),
                (lambda: toon().pose(unwrap=2), "unwrap", "0 to 1"),
                (lambda: toon().pose(unwrap_mode="odd"), "unwrap_mode", "'odd'"),
                (lambda: mien.crowd("a", -1), "count", "people"),
                (lambda: people.code(2**50), "of", "2^50"),
                (lambda: people.code(-1), "of", "2^50"),
                (lambda: people.near("?", 0.1), "", "")):
            with self.assertRaises(mien.Error) as raised:
                call()
            self.assertIn(where, raised.exception.where)
            self.assertIn(what, raised.exception.what)
            self.assertIn(raised.exception.what, str(raised.exception))
        self.assertIsInstance(raised.exception, ValueError)
        self.assertEqual(pickle.loads(pickle.dumps(raised.exception)).where, raised.exception.where)
        for call in (lambda: mien.read_face(7), lambda: mien.from_code(None), lambda: mien.crowd("a", 1.5)):
            self.assertRaises(TypeError, call)

    def test_that_nobody_holds_are_freed(self):
        freed = []
        free = mien._library.lib.mien_face_free
        handle = mien._library.Handle(lambda value: (freed.append(1), free(value)), mien._library.lib.mien_face_read,
                                      *mien._library.path_bytes(TOON))
        posed = mien.Face(handle, toon()._source).pose(time=1)
        del handle
        gc.collect()
        self.assertFalse(freed)  # a posed face holds its face
        posed.render(32)
        del posed
        gc.collect()
        self.assertEqual(freed, [1])


class FaceTexts(unittest.TestCase):
    def test_are_edited_in_place(self):
        words = TOON.read_text(encoding="utf-8")
        self.assertEqual(mien.face_text_with(words, {}), (words, ()))
        set = {"palette/skin": "#88aa66", "brow.right/spine/0": (-0.1, 0.36), "gaze.x": 0.01}
        made = mien.face_text_with(words, set, "toon.face.json")
        self.assertEqual(made.left, ("gaze.x",))
        self.assertEqual(mien.read_face_text(made.text).names["brow.right/spine/0"].value, (-0.1, 0.36))
        self.assertIn('"#88aa66"', made.text)
        self.assertEqual(made, mien.face_text_with(words.encode(), set))
        for bad in (lambda: mien.face_text_with(words, {"palette/skim": "#88aa66"}), lambda: mien.face_text_with("{", {}), lambda: mien.face_pointers("{")):
            self.assertRaises(mien.Error, bad)

    def test_say_where_values_stand(self):
        words = TOON.read_text(encoding="utf-8")
        pointers = mien.face_pointers(words)
        self.assertEqual(pointers["palette/skin"], "/palette/skin")
        self.assertNotIn("gaze.x", pointers)
        at = json.loads(words)
        for key in pointers["head/points/3"].split("/")[1:]:
            at = at[int(key) if isinstance(at, list) else key]
        self.assertEqual(tuple(at[:2]), toon().names["head/points/3"].value)

    def test_clips_have_lengths(self):
        person = mien.from_code(mien.people.code("hello"))
        self.assertEqual(dict(person.clip_lengths), {"idle": math.inf, "feelings": 12})


class Motions(unittest.TestCase):
    TRACK = "0\tsil\n0.2\tm\n0.4\tɑː\n0.8\t\n"

    def test_are_read_and_followed(self):
        person, track = mien.from_code(people.code("ada")), mien.read_motion_text(self.TRACK, "track.tsv")
        self.assertGreater(track.length, 0.8)
        self.assertIn("viseme.PP", track.channels)
        self.assertEqual(track.value("viseme.PP", 0.3), 1)
        self.assertEqual((track.told, person.unfollowed(track)), ((), ()))
        open_mouth = person.speak(track, 0.6).vector
        self.assertFalse(numpy.array_equal(open_mouth, person.pose(time=0.6).vector))
        self.assertTrue(numpy.array_equal(open_mouth, person.pose(time=0.6, clips=["idle"], motions=[(track, 1)]).vector))
        frame = {"faceBlendshapes": [{"categories": [{"categoryName": "jawOpen", "score": 0.5}]}]}
        self.assertTrue(numpy.array_equal(person.follow(frame).vector, person.pose(arkit={"jawOpen": 0.5}).vector))

    def test_are_steadied_where_they_come_live(self):
        person, steady = mien.from_code(people.code("ada")), mien.Steady(cutoff=1, beta=0)
        at = lambda jaw, seconds: person.follow({"jawOpen": jaw}, steady=(steady, seconds)).vector
        self.assertTrue(numpy.array_equal(at(0, 7), person.follow({"jawOpen": 0}).vector))
        share = 1 / (1 + 1 / (2 * math.pi / 30))
        numpy.testing.assert_allclose(at(1, 7 + 1 / 30), person.follow({"jawOpen": share}).vector, atol=1e-9)
        self.assertTrue(numpy.array_equal(at(1, 9), person.follow({"jawOpen": 1}).vector))
        with self.assertRaises(mien.Error):
            mien.Steady(cutoff=0)

    def test_say_what_is_wrong(self):
        with self.assertRaises(mien.Error) as wrong:
            mien.read_motion_text("time,jawOpen\n0,0\n1,nan\n", "take.csv")
        self.assertEqual(wrong.exception.where, "take.csv:3:3")
        with self.assertRaises(mien.Error):
            mien.read_motion("nowhere.csv")
        with self.assertWarns(mien.Warned) as odd:
            clamped = mien.read_motion_text("time,jawOpen,tongueOut\n0,0,0\n1,1.5,1\n")
        self.assertEqual((len(clamped.told), pathlib.Path(odd.filename).name), (1, pathlib.Path(__file__).name))
        with tempfile.TemporaryDirectory() as folder:
            odd_one = pathlib.Path(folder, "odd.txt")
            odd_one.write_text("0 h\n0.2 ☃\n0.4 sil\n", encoding="utf-8")
            with self.assertWarnsRegex(mien.Warned, "no sound is called") as odd:
                track = mien.read_motion(odd_one)
        self.assertEqual(pathlib.Path(odd.filename).name, pathlib.Path(__file__).name)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(pickle.loads(pickle.dumps(track)), track)
            mien.read_motion_text("0 h\n0.2 PP\n0.4 sil\n")  # shapes of a mouth among phones


class Poses(unittest.TestCase):
    def test_are_those_of_the_command(self):
        face, size = mien.from_code(people.code("ada")), (96, 96)
        posed = face.pose(time=0.5, clips=[("idle", 0.5, 0.25)], look_at=(1, 0.5, 9), emotions={"joy": 0.75, "left.fear": 0.25},
                          set={"blink": 0.125})
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.png")
            subprocess.run([MIEN, "render", people.code("ada"), "-o", file, "--size", "96x96", "--time", "0.5", "--clip",
                            "idle=0.5@0.25", "--look-at", "1,0.5,9", "--emotion", "joy=0.75", "--emotion", "left.fear=0.25",
                            "--set", "blink=0.125"], check=True)
            by_command = file.read_bytes()
            posed.save(pathlib.Path(folder, "b.png"), size)
            by_python = pathlib.Path(folder, "b.png").read_bytes()
        data = [b[b.index(b"IDAT"):] for b in (by_command, by_python)]
        self.assertEqual(*data)

    def test_have_a_time_of_their_own(self):
        ada, bob = (mien.from_code(people.code(name)) for name in ("ada", "bob"))
        at = lambda face, **more: face.pose(time=1.25, **more).vector.tolist()
        self.assertEqual(at(ada), at(ada, seed=people.code("ada")))
        self.assertNotEqual(at(ada), at(ada, seed="bob"))
        self.assertEqual(at(ada, seed=7), at(ada, seed="7"))
        self.assertNotEqual(at(ada, seed="x" * 10**6), at(ada))
        self.assertEqual(at(bob, liveliness=0), bob.vector.tolist())
        self.assertNotEqual(at(bob, liveliness=0.5), at(bob))
        for wrong, where, what in (({"seed": ""}, "seed", "an empty word is no seed"),
                                   ({"liveliness": -1}, "liveliness", "goes from 0 to 2, got -1"),
                                   ({"liveliness": math.nan}, "liveliness", "goes from 0 to 2, got nan")):
            with self.assertRaises(mien.Error) as caught:
                at(ada, **wrong)
            self.assertEqual((caught.exception.where, caught.exception.what), (where, what))

    def test_take_numbers_arrays_and_colours(self):
        face = toon()
        point = next(n for n in face.names.values() if not n.is_control and numpy.size(n.value) == 2)
        moved = face.pose(set={point.name: numpy.array([0.1, 0.2], numpy.float32), "blink": numpy.float64(0.5)}).vector
        numpy.testing.assert_array_equal(moved[point.begin:point.begin + 2], numpy.float32([0.1, 0.2]).astype(float))
        color = next(n for n in face.names.values() if numpy.size(n.value) == 4 and n.unit == "linear light")
        red = face.pose(set={color.name: "#ff0000"}).vector
        numpy.testing.assert_array_equal(red[color.begin:color.begin + 4], [1, 0, 0, 1])

    def test_know_what_is_where(self):
        posed = toon().pose()
        self.assertEqual(len(posed.layers), len(set(range(len(posed.layers)))))
        x, y = posed.face_from_pixel(512.25, 100.5)
        numpy.testing.assert_allclose(posed.pixel_from_face(x, y), (512.25, 100.5), atol=1e-9)
        layer = posed.layer_at(0, 0)
        self.assertIn(layer, posed.layers)
        self.assertIsNone(posed.layer_at(1e9, 1e9) if posed.layers[0] != "background" else None)
        feature = posed.feature_at(0, 0)
        self.assertTrue(feature and layer.startswith(feature), feature)
        self.assertEqual(posed.feature_at(1e9, 1e9) is None, posed.layer_at(1e9, 1e9) is None)
        self.assertLess(min(posed.distance(i, 0, 0) for i in range(len(posed.layers))), 0)
        self.assertGreater(posed.distance(layer, 1e6, 0), 0)
        self.assertIn("layer", posed.scene)
        for bad in (lambda: posed.distance("none", 0, 0), lambda: posed.distance(10**6, 0, 0),
                    lambda: posed.layer_at(float("nan"), 0), lambda: posed.feature_at(0, float("inf"))):
            self.assertRaises(mien.Error, bad)


    def test_are_svg_files(self):
        posed = toon().pose()
        made = posed.svg((300, 200), background="transparent", id_prefix="a-")
        self.assertTrue(made.text.startswith('<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200"'))
        self.assertIn('<path id="a-', made.text)
        ids = [set(re.findall(r'\bid="([^"]+)"', toon().pose(**pose).svg(64).text)) for pose in ({}, {"set": {"yaw": 5}})]
        self.assertFalse(ids[0] & ids[1])
        self.assertTrue(all(one.startswith('layer "') for one in made.simplified))
        xml.dom.minidom.parseString(made.text)
        self.assertLess(len(posed.svg(300, tolerance=0.5).text), len(posed.svg(300, tolerance=1e-3).text))
        for bad in (lambda: posed.svg(0), lambda: posed.svg(9, tolerance=0), lambda: posed.svg(9, tolerance=float("nan")),
                    lambda: posed.svg(9, tolerance=7), lambda: posed.svg(9, fit="none")):
            self.assertRaises(mien.Error, bad)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
