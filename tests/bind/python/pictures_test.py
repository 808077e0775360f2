#!/usr/bin/env python3
"""Pictures: pictures_test.py MIEN ROOT"""
import json
import os
import pathlib
import signal
import struct
import sys
import tempfile
import threading
import time
import unittest
import zlib

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien

ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = sys.argv.pop()
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


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
