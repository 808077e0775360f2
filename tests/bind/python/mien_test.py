#!/usr/bin/env python3
"""The Python package: mien_test.py MIEN ROOT"""
import csv
import ctypes
import doctest
import gc
import importlib
import importlib.util
import json
import math
import os
import pathlib
import pickle
import re
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import tracemalloc
import types
import unittest
import unittest.mock
import warnings
import xml.dom.minidom
import zlib

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
import mien._library
import mien._picture
from mien import distance, people

ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = MIEN = sys.argv.pop()
TOON = ROOT / "faces/compat/toon.face.json"
SIZE = (160, 90)


def toon():
    return mien.read_face(TOON)


def decoded(png):
    """The RGBA pixels of a PNG of 8 bits whose rows have filter 0 or 2."""
    at, packed = 8, b""
    width, height, depth, kind = struct.unpack(">IIBB", png[16:26])
    assert (depth, kind) == (8, 6)
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at:at + 8])
        data = png[at + 8:at + 8 + size]
        assert struct.unpack(">I", png[at + 8 + size:at + 12 + size])[0] == zlib.crc32(name + data)
        packed += data if name == b"IDAT" else b""
        at += 12 + size
    rows = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + width * 4)
    assert set(rows[:, 0]) <= {0, 2}
    pixels = rows[:, 1:].copy()
    for y in range(1, height):
        if rows[y, 0] == 2:
            pixels[y] += pixels[y - 1]
    return pixels.reshape(height, width, 4)


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
        self.assertEqual((len(clamped.told), pathlib.Path(odd.filename).name), (1, "mien_test.py"))
        with tempfile.TemporaryDirectory() as folder:
            odd_one = pathlib.Path(folder, "odd.txt")
            odd_one.write_text("0 h\n0.2 ☃\n0.4 sil\n", encoding="utf-8")
            with self.assertWarnsRegex(mien.Warned, "no sound is called") as odd:
                track = mien.read_motion(odd_one)
        self.assertEqual(pathlib.Path(odd.filename).name, "mien_test.py")
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


class Pictures(unittest.TestCase):
    def test_have_every_depth(self):
        posed = toon().pose(time=1.25)
        for depth, dtype in (("uint8", numpy.uint8), (numpy.uint16, numpy.uint16), (numpy.dtype("f4"), numpy.float32)):
            picture = posed.render(SIZE, dtype=depth, dither=False)
            self.assertEqual((picture.shape, picture.dtype), ((90, 160, 4), dtype))
        encoded = posed.render(SIZE, dither=False) / 255
        linear = picture[..., :3].astype(float)
        srgb = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * numpy.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
        self.assertLess(numpy.abs(srgb - encoded[..., :3]).max(), 1.01 / 255)

    def test_are_drawn_in_place_with_gaps(self):
        posed = toon().pose()
        for depth in ("uint8", "uint16", "float32"):
            wanted = posed.render(SIZE, dtype=depth)
            room = numpy.full((100, 200, 4), 77, wanted.dtype)
            window = room[5:95, 20:180]
            self.assertIs(posed.render(SIZE, dtype=depth, out=window), window)
            numpy.testing.assert_array_equal(window, wanted)
            window[...] = 77
            self.assertTrue((room == 77).all())

    def test_refuse_arrays_that_cannot_hold_them(self):
        posed, good = toon().pose(), numpy.zeros((90, 160, 4), numpy.uint8)
        read_only = good.copy()
        read_only.flags.writeable = False
        bytes_ = numpy.zeros(90 * 160 * 8 + 1, numpy.uint8)
        for out, raised, words in (
                (read_only, mien.Error, "read-only"), (good[::-1], mien.Error, "rows"), (good[:, ::-1], mien.Error, "rows"),
                (numpy.zeros((90, 160, 8), numpy.uint8)[..., ::2], mien.Error, "rows"),
                (numpy.broadcast_to(good[:1], good.shape), mien.Error, "read-only"),
                (numpy.zeros((160, 90, 4), numpy.uint8).transpose(1, 0, 2), mien.Error, "rows"),
                (good[:89], mien.Error, "shape"), (good[..., :3], mien.Error, "shape"), (good.astype(float), TypeError, "float64"),
                (good.view(numpy.int8), TypeError, "int8"), (good.tolist(), TypeError, "list")):
            with self.assertRaisesRegex(raised, words):
                posed.render(SIZE, out=out)
        with self.assertRaisesRegex(TypeError, "u2|uint16"):
            posed.render(SIZE, dtype="u2", out=numpy.zeros((90, 160, 4), ">u2"))
        crooked = bytes_[1:].view(numpy.uint16).reshape(90, 160, 4)
        with self.assertRaises(mien.Error):
            posed.render(SIZE, dtype="u2", out=crooked)

    def test_obey_the_view(self):
        posed = toon().pose()
        whole = posed.render(SIZE, background="transparent")
        self.assertEqual(posed.render(64).shape[1], 64)
        part = posed.render(SIZE, background="transparent", region=(30, 20, 50, 40))
        numpy.testing.assert_array_equal(part, whole[20:60, 30:80])
        numpy.testing.assert_array_equal(posed.render(SIZE, background="#ff0000"), posed.render(SIZE, background=(1, 0, 0)))
        self.assertFalse((posed.render(SIZE, blend="srgb") == posed.render(SIZE)).all())
        numpy.testing.assert_array_equal(posed.render(SIZE, threads=1), posed.render(SIZE, threads=2))
        posed.render(SIZE, light=(1, 1, 1), fit="slice")
        for how, words in (({"fit": "odd"}, "meet or slice"), ({"blend": "odd"}, "linear or srgb"), ({"dtype": "u9"}, "uint8, uint16 or float32"), ({"dtype": ">u2"}, "uint8"), ({"dtype": None}, "uint8"), ({"dtype": object}, "uint8"),
                           ({"background": "redd"}, "did you mean \"red\""), ({"background": (1, 2)}, "3 or 4"), ({"region": (1, 2)}, "4|got 2"),
                           ({"region": (999, 0, 1, 1)}, "region"), ({"light": (0, 0, -1)}, "lamp"), ({"light": (0, 0)}, "x, y, z"),
                           ({"size": 0}, "1 pixel or more"), ({"size": (0, 9)}, "sides"), ({"size": (1, 2, 3)}, "width and height"), ({"size": 2**40}, "range"),
                           ({"size": 2**21}, "sides"), ({"threads": -1}, "threads")):
            with self.assertRaisesRegex(mien.Error, words):
                posed.render(**{"size": SIZE, **how})
        self.assertRaises(TypeError, posed.render, 1.5)

    def test_can_be_watched_and_stopped(self):
        posed, shares = toon().pose(), []
        posed.render(SIZE, progress=shares.append)
        self.assertEqual((shares, shares[-1]), (sorted(shares), 1.0))
        with self.assertRaises(mien.Cancelled):
            posed.render((2000, 2000), progress=lambda _: False)

        def interrupted(_):
            raise KeyboardInterrupt

        self.assertRaises(KeyboardInterrupt, posed.render, SIZE, progress=interrupted)
        with self.assertRaises(ZeroDivisionError):
            posed.render(SIZE, progress=lambda _: 1 / 0)

    def test_are_ended_by_ctrl_c(self):
        """Wherever the drawing is, also between two questions of its progress, and by every signal with a handler."""

        class Late(Exception):
            pass

        def late(*_):
            raise Late

        spikes = [[i * 7919 % 2000 / 1000 - 1, i * 104729 % 1999 / 1000 - 1] for i in range(20000)]
        posed = mien.read_face_text(json.dumps({
            "format": "mien-face", "format_version": 1, "name": "spikes", "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
            "palette": {"a": "#204080", "b": "#fff7e0"}, "background": "b",
            "features": [{"name": "p", "kind": "path", "paint": "a", "points": spikes}]})).pose()
        before = signal.signal(signal.SIGALRM, late)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        for number, raised in ((signal.SIGINT, KeyboardInterrupt), (signal.SIGALRM, Late)):
            for size, depth, threads, watch in ((64, "u1", 1, None), (256, "u2", 2, lambda _: None), (1024, "f4", 0, None)):
                with self.subTest(signal=number, size=size, threads=threads):
                    sent = []
                    timer = threading.Timer(0.2, lambda: (sent.append(time.monotonic()), os.kill(os.getpid(), number)))
                    timer.start()
                    with self.assertRaises(raised):
                        posed.render(size, dtype=depth, threads=threads, progress=watch)
                    self.assertLess(time.monotonic() - sent[0], 0.5)

    def test_show_themselves_in_notebooks(self):
        face = toon()
        png = face.pose()._repr_png_()
        numpy.testing.assert_array_equal(decoded(png), face.render(400))
        self.assertEqual(face._repr_png_(), png)

    def test_are_written(self):
        posed = toon().pose()
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.png", "a.tif", "a.exr", "a.jpg"):
                posed.save(pathlib.Path(folder, name), 64, recipe="by a test")
                self.assertGreater(pathlib.Path(folder, name).stat().st_size, 100)
            posed.save(os.path.join(folder, "b.png"), 64, depth=16)
            for call, words in ((lambda: posed.save(folder + "/a.doc"), "doc"), (lambda: posed.save(folder + "/c/a.png"), "folder"),
                                (lambda: posed.save(folder + "/d.png", memory=1), "memory"),
                                (lambda: posed.save(folder + "/d.png", progress=lambda _: False), "cancelled")):
                with self.assertRaisesRegex(mien.Error, words):
                    call()
            self.assertFalse(pathlib.Path(folder, "d.png").exists())

    def test_of_animations_come_one_by_one(self):
        face = toon()
        frames = list(face.frames(4, SIZE, fps=8, begin=1, pose={"set": {"gaze.x": 0.02}}))
        for i, frame in enumerate(frames):
            numpy.testing.assert_array_equal(frame, face.pose(time=1 + i / 8, set={"gaze.x": 0.02}).render(SIZE))
        self.assertFalse((frames[0] == frames[3]).all())
        out = numpy.zeros((90, 160, 4), numpy.uint8)
        shut = face.frames(2, SIZE, pose=lambda time: {"time": None, "set": {"blink": float(time > 0)}}, out=out)
        self.assertIs(next(shut), out)
        opened = out.copy()
        next(shut)
        self.assertFalse((opened == out).all())
        self.assertRaises(StopIteration, next, shut)

    def test_are_drawn_by_many_threads_at_once(self):
        face, renderer = toon(), mien.Renderer()
        posed = face.pose(time=1.25)
        wanted, drawn = posed.render(SIZE), []

        def draw(shared):
            for _ in range(3):
                drawn.append(posed.render(SIZE, threads=1, renderer=renderer if shared else None))

        threads = [threading.Thread(target=draw, args=(i % 2,)) for i in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(drawn), 18)
        for picture in drawn:
            numpy.testing.assert_array_equal(picture, wanted)


def stand_ins():
    """For packages that the page's examples marked `py` need and this machine has not: they do what mien asks of them."""
    pyplot = types.ModuleType("matplotlib.pyplot")
    pyplot.imshow = lambda of: len(numpy.asarray(of).shape) == 3 or 1 / 0
    pyplot.axis = pyplot.savefig = lambda _: None
    matplotlib = types.ModuleType("matplotlib")
    matplotlib.pyplot = pyplot
    pandas = types.ModuleType("pandas")

    class DataFrame:
        def __init__(self, file):
            with open(file, encoding="utf-8", newline="") as lines:
                self.columns, *self.rows = csv.reader(lines)

        def itertuples(self, index, name):
            return iter(self.rows)

    pandas.read_csv = DataFrame
    anywidget = types.ModuleType("anywidget")
    if importlib.util.find_spec("traitlets"):  # which comes with IPython
        anywidget.AnyWidget = importlib.import_module("traitlets").HasTraits
    made = {"matplotlib": matplotlib, "matplotlib.pyplot": pyplot, "pandas": pandas, "anywidget": anywidget}
    missing = {name for name in ("matplotlib", "pandas", "anywidget") if not importlib.util.find_spec(name)}
    return {name: module for name, module in made.items() if name.partition(".")[0] in missing}


QUAD = [[0, 0], [0.5, 1], [1, 0]]


def brute(point, x, y, count=20001):
    t = numpy.linspace(0, 1, count)
    px, py = point(t)
    return numpy.array([numpy.hypot(px - a, py - b).min() for a, b in zip(x, y, strict=True)])


class Distances(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        self.x, self.y = random.uniform(-1, 2, 50), random.uniform(-1, 2, 50)

    def test_are_right(self):
        x, y = self.x, self.y
        by = brute(lambda t: (t, 2 * t * (1 - t)), x, y)
        numpy.testing.assert_allclose(distance.quad(QUAD, x, y), by, atol=1e-4)
        numpy.testing.assert_allclose(distance.cubic([[0, 0], [1 / 3, 2 / 3], [2 / 3, 2 / 3], [1, 0]], x, y), by, atol=1e-4)
        numpy.testing.assert_allclose(distance.tapered(QUAD, (0.25,) * 3, x, y), by - 0.25, atol=1e-4)
        numpy.testing.assert_allclose(distance.ellipse((0.5, 0.5), (2, 2), x, y), numpy.hypot(x - 0.5, y - 0.5) - 2, atol=1e-12)

    def test_keep_types_and_shapes(self):
        x, y = self.x, self.y
        exact = distance.quad(QUAD, x, y)
        single = distance.quad(QUAD, x.astype("f4"), y.astype("f4"))
        self.assertEqual((exact.dtype, single.dtype), (numpy.float64, numpy.float32))
        numpy.testing.assert_allclose(single, exact, atol=1e-6)
        self.assertEqual(distance.quad(QUAD, x.astype("f4"), y).dtype, numpy.float64)
        self.assertEqual(distance.quad(QUAD, x.astype("f4"), 0.5).dtype, numpy.float32)
        self.assertEqual(distance.quad(QUAD, [1, 2], [3, 4]).dtype, numpy.float64)
        grid = distance.quad(QUAD, x[:, None], y[None, :])
        self.assertEqual(grid.shape, (50, 50))
        numpy.testing.assert_array_equal(grid.diagonal(), exact)
        self.assertEqual(numpy.shape(distance.quad(QUAD, 1, 2)), ())
        self.assertEqual(distance.quad(QUAD, [], []).shape, (0,))
        numpy.testing.assert_array_equal(distance.quad(QUAD, x[::-2], y[::-2]), exact[::-2])
        numpy.testing.assert_array_equal(distance.quad(QUAD, x.astype(">f8"), y), exact)
        x.flags.writeable = False
        numpy.testing.assert_array_equal(distance.quad(QUAD, x, y), exact)
        self.assertTrue(numpy.isinf(distance.quad(QUAD, numpy.nan, 0)))

    def test_go_where_they_are_told(self):
        x, y = self.x, self.y
        exact = distance.quad(QUAD, x, y)
        out = numpy.empty(50)
        self.assertIs(distance.quad(QUAD, x, y, out=out), out)
        numpy.testing.assert_array_equal(out, exact)
        spread = numpy.zeros((50, 2))
        distance.quad(QUAD, x, y, out=spread[:, 1])
        numpy.testing.assert_array_equal(spread, numpy.stack([0 * exact, exact], 1))
        both = numpy.concatenate([x, [9.0]])
        distance.quad(QUAD, both[:50], y, out=both[1:])  # overlaps
        numpy.testing.assert_array_equal(both[1:], exact)
        here = x.copy()
        self.assertIs(distance.quad(QUAD, here, y, out=here), here)
        numpy.testing.assert_array_equal(here, exact)
        double = numpy.empty(50)
        distance.quad(QUAD, x.astype("f4"), y.astype("f4"), out=double)
        narrow = numpy.empty(50, "f4")
        distance.quad(QUAD, x, y, out=narrow)  # NumPy's same_kind
        numpy.testing.assert_allclose(narrow, exact, rtol=1e-6)

    def test_copy_nothing_that_lies_in_one_piece(self):
        x, y, out = (numpy.zeros(10**6, "f4") for _ in range(3))
        face, picture = toon().pose(), numpy.empty((512, 512, 4), numpy.uint8)
        tracemalloc.start()
        distance.quad(QUAD, x, y, out=out)
        face.render((512, 512), out=picture)
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        self.assertLess(most, 10**5)

    def test_refuse_what_is_none(self):
        x, y = self.x, self.y
        read_only = numpy.empty(50)
        read_only.flags.writeable = False
        for call, raised, words in (
                (lambda: distance.quad(QUAD, x, y, out=read_only), mien.Error, "read-only"),
                (lambda: distance.quad(QUAD, x, y, out=numpy.empty(49)), mien.Error, "shape"),
                (lambda: distance.quad(QUAD, x, y, out=numpy.empty(50, int)), TypeError, "int64"),
                (lambda: distance.quad(QUAD, x, y, out=[0] * 50), TypeError, "list"),
                (lambda: distance.quad(QUAD, x, y[:7]), mien.Error, "broadcast"),
                (lambda: distance.quad(QUAD[:2], x, y), mien.Error, r"expected 3 points, an array \(3, 2\) or \(6,\), got \(2, 2\)"),
                (lambda: distance.quad(numpy.transpose(QUAD), x, y), mien.Error, r"got \(2, 3\)"),  # a row of x and a row of y
                (lambda: distance.quad("curve", x, y), TypeError, "points"),
                (lambda: distance.quad(QUAD, x + 1j, y), TypeError, "complex"),
                (lambda: distance.quad(QUAD, ["a"], y), TypeError, "real"),
                (lambda: distance.ellipse((0, 0), (1, -1), x, y), mien.Error, "negative"),
                (lambda: distance.ellipse((0, 0), (1, 1), x, y, axis=(0, 0)), mien.Error, "direction"),
                (lambda: distance.tapered(QUAD, (1, 1, -1), x, y), mien.Error, "negative")):
            with self.assertRaisesRegex(raised, words):
                call()


class Feet(unittest.TestCase):
    def test_agree_with_distances_and_differences(self):
        x, y = numpy.random.default_rng(5).random((2, 40, 25)) * 3 - 1
        widths, step = (0.1, 0.2, 0.05), 1e-6
        for feet, of in ((lambda x, y: distance.feet.quad(QUAD, x, y), lambda x, y: distance.quad(QUAD, x, y)),
                         (lambda x, y: distance.feet.tapered(QUAD, widths, x, y), lambda x, y: distance.tapered(QUAD, widths, x, y)),
                         (lambda x, y: distance.feet.ellipse((0.5, 0.5), (1, 2), x, y, axis=(1, 1)),
                          lambda x, y: distance.ellipse((0.5, 0.5), (1, 2), x, y, axis=(1, 1)))):
            nearest, following = feet(x, y)
            self.assertEqual((nearest.t.shape, nearest.normal.shape, nearest.piece.dtype), ((40, 25), (40, 25, 2), numpy.int32))
            numpy.testing.assert_allclose(nearest.distance, of(x, y), atol=1e-14)
            numpy.testing.assert_allclose(numpy.hypot(*numpy.moveaxis(nearest.normal, -1, 0)), 1, atol=1e-14)
            gradient = numpy.stack([of(x + step, y) - of(x - step, y), of(x, y + step) - of(x, y - step)], -1) / (2 * step)
            close = numpy.abs(gradient - nearest.normal).max(-1) < 1e-5
            self.assertGreater(close.mean(), 0.99)  # but for ridges
            there = following.piece >= 0
            self.assertTrue(there.any() and not there.all())
            self.assertTrue((numpy.abs(following.distance[there]) >= numpy.abs(nearest.distance[there])).all())
            self.assertTrue(numpy.isposinf(following.distance[~there]).all() and not following.normal[~there].any())

    def test_tell_the_point_on_the_curve(self):
        x, y = numpy.random.default_rng(6).random((2, 40, 25)) * 3 - 1
        points = numpy.array(QUAD, float)

        def curve(t):
            t = t[..., None]
            return (1 - t) ** 2 * points[0] + 2 * t * (1 - t) * points[1] + t * t * points[2]
        for foot in distance.feet.quad(QUAD, x, y):
            there = foot.piece >= 0
            numpy.testing.assert_allclose(foot.point[there], curve(foot.t)[there], atol=1e-12)
            self.assertTrue(numpy.isnan(foot.point[~there]).all())
        for feet, of in ((distance.feet.tapered(QUAD, (0.1, 0.2, 0.05), x, y), lambda at: distance.tapered(QUAD, (0.1, 0.2, 0.05), *at)),
                         (distance.feet.ellipse((0.5, 0.5), (1, 2), x, y, axis=(1, 1)), lambda at: distance.ellipse((0.5, 0.5), (1, 2), *at, axis=(1, 1))),
                         (distance.feet.lines([[(0, 0), (1, 1)]], x, y, half_width=0.1), lambda at: distance.feet.line((0, 0), (1, 1), *at, half_width=0.1).nearest.distance)):
            self.assertTrue((feet.nearest.distance < 0).any())
            numpy.testing.assert_allclose(of(numpy.moveaxis(feet.nearest.point, -1, 0)), 0, atol=1e-12)  # on the outline
        ellipse = distance.feet.ellipse((0, 0), (2, 1), 0, 0.25).nearest
        numpy.testing.assert_allclose((ellipse.point, ellipse.normal), ((0, 1), (0, 1)), atol=1e-15)  # inside it points to the foot
        numpy.testing.assert_allclose(distance.feet.quad(QUAD, 1.0, [2.0]).nearest.normal @ (0, 1) > 0, True)
        for place, shape in ((1, (2,)), ([1, 2], (2, 2)), ([], (0, 2))):
            self.assertEqual(distance.feet.quad(QUAD, place, 2).nearest.point.shape, shape)

    def test_are_shown_short(self):
        many = distance.feet.quad(QUAD, numpy.zeros((40, 25)), 1)
        self.assertEqual(repr(many.nearest), "<mien.distance.feet.Foot of 40 x 25 places: piece, t, distance, normal, bend, point>")
        self.assertLess(len(repr(many)), 250)
        one = repr(distance.feet.line((0, 0), (2, 0), 1, 1))
        self.assertIn("piece 0, t 0.5, distance 1>", one)
        self.assertIn("next=<mien.distance.feet.Foot: piece -1", one)

    def test_of_lists_tell_the_piece(self):
        square = [[(0, 0), (2, 0)], [(2, 0), (2, 2)], [(2, 2), (0, 2)], [(0, 2), (0, 0)]]
        x, y = numpy.linspace(0.1, 0.9, 5), 1.0
        nearest, following = distance.feet.lines(square, x, y)
        self.assertEqual(nearest.piece.tolist(), [3] * 5)
        numpy.testing.assert_allclose(nearest.distance, x)
        self.assertEqual(distance.feet.lines(square, -1, -1).next.piece, -1)  # the corner is one foot
        self.assertEqual(distance.feet.lines(square, 1, 1, half_width=0.25).nearest.distance, 0.75)
        quads = [QUAD, [[0, 3], [1, 4], [2, 3]]]
        self.assertEqual(distance.feet.quads(quads, 1, 3).nearest.piece, 1)
        self.assertEqual(distance.feet.tapereds(quads, [[0.1] * 3] * 2, 1, 3).nearest.piece, 1)
        self.assertEqual(distance.feet.quads([], [1, 2], 3).nearest.piece.tolist(), [-1, -1])
        self.assertEqual(numpy.shape(distance.feet.quad(QUAD, 1, 2).nearest.distance), ())
        self.assertEqual(distance.feet.quad(QUAD, [], []).nearest.normal.shape, (0, 2))
        self.assertEqual(distance.feet.quad(QUAD, numpy.float32([1, 2]), 3).nearest.distance.dtype, numpy.float64)

    def test_refuse_in_a_sentence(self):
        for call, error, words in (
                (lambda: distance.feet.quad(QUAD[:2], 1, 1), mien.Error, r"expected 3 points, an array \(3, 2\) or \(6,\), got \(2, 2\)"),
                (lambda: distance.feet.quads([[1, 2]], 1, 1), mien.Error, "curves: expected an array"),
                (lambda: distance.feet.lines([[[1, 2, 3]]], 1, 1), mien.Error, "segments"),
                (lambda: distance.feet.tapereds([QUAD], [[1, 1, 1]] * 2, 1, 1), mien.Error, "half_widths"),
                (lambda: distance.feet.quad(QUAD, [1, 2], [1, 2, 3]), mien.Error, "broadcast"),
                (lambda: distance.feet.line((0, 0), (1, 1), 1, 1, half_width=-1), mien.Error, "negative"),
                (lambda: distance.feet.ellipse((0, 0), (1, 1), 1, 1, axis=(0, 0)), mien.Error, "direction"),
                (lambda: distance.feet.quad("curve", 1, 1), TypeError, "points")):
            with self.assertRaisesRegex(error, words):
                call()


class Package(unittest.TestCase):
    def test_has_the_version_of_the_library(self):
        said = subprocess.run([MIEN, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(mien.__version__, said)

    def test_prototypes_are_those_of_the_headers(self):
        """Every function with as many arguments as its header says, every struct field by field."""
        for header, status, plain in (("bind/c/mien_c.h", mien._library._STATUS, mien._library._PLAIN),
                                      ("bind/c/image/mien_image_c.h", mien._library._IMAGE_STATUS, mien._library._IMAGE_PLAIN)):
            text = re.sub(r"/\*.*?\*/", "", (ROOT / header).read_text(encoding="utf-8"), flags=re.S)
            declared = dict(re.findall(r"MIEN_C_API[\w\s*]*?\b(mien_\w+)\((.*?)\);", text, flags=re.S))
            for name, takes in [*status.items(), *((name, takes) for name, (_, takes) in plain.items())]:
                arguments = [one for one in re.split(r",(?![^(]*\))", declared[name]) if one.strip() != "void"]
                self.assertEqual(len(arguments), len(takes) + (name in status), name)
                for said, argument in zip(takes, arguments, strict=False):
                    wanted = {ctypes.c_int32: "int32_t", ctypes.c_size_t: "size_t", ctypes.c_double: "double",
                              ctypes.c_char_p: "const char*"}.get(said)
                    self.assertTrue(wanted is None or wanted in argument or (wanted == "size_t" and "uint64_t" in argument), (name, argument))
            for struct_, fields in re.findall(r"typedef struct (\w+) \{(.*?)\}", text, flags=re.S):
                wanted = [name for one in re.findall(r"\w[\w*]* ([^;]+);", fields) for name in re.findall(r"(\w+)(?:\[\d\])?(?:,|$)", one)]
                mirror = {"mien_name": "NameRecord"}.get(struct_, struct_[5:].title().replace("_", ""))
                self.assertEqual([name for name, _ in getattr(mien._library, mirror)._fields_], wanted)

    def test_says_where_it_looked(self):
        said = subprocess.run([sys.executable, "-c", "import sys; sys.path.insert(0, sys.argv[1]); import mien", str(ROOT / "bind/python")],
                              env={"MIEN_LIBRARY": "/nowhere", "PYTHONDONTWRITEBYTECODE": "1"}, capture_output=True, text=True)
        if said.returncode:  # one may be installed
            self.assertIn("ImportError: mien needs libmien_c.so.0; MIEN_LIBRARY", said.stderr)

    def test_examples_in_its_documentation_run(self):
        for module in (mien, distance, distance.feet, people):
            failed, tried = doctest.testmod(module)
            self.assertFalse(failed)
        page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```(python|py)\n(.*?)^```$", page, flags=re.S | re.M)
        self.assertGreater(len(blocks), 20)
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(sys.modules, stand_ins()):
            for name in ("faces", "examples"):
                os.symlink(ROOT / name, pathlib.Path(folder, name))
            os.chdir(folder)
            try:
                names = {}
                for _, block in blocks:
                    wants = {"needs Pillow": "PIL", "FaceWidget": "traitlets"}
                    if "lab.check" in block and not pathlib.Path(mien.lab._own_program()).is_file():
                        continue
                    if "scheduler:8786" in block:
                        continue  # there is no cluster here; dask_test.py starts one
                    if any(word in block and not importlib.util.find_spec(name) for word, name in wants.items()):
                        continue
                    exec(compile(block, "a page's example", "exec"), names)
            finally:
                os.chdir(here)

    def test_is_typed(self):
        self.assertTrue((ROOT / "bind/python/mien/py.typed").is_file())


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
