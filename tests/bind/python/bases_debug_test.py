#!/usr/bin/env python3
"""Bases of animations and debug pictures in Python, against NumPy and the command: bases_debug_test.py MIEN SOURCE"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zlib

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien

ROOT = pathlib.Path(sys.argv.pop())
COMMAND = sys.argv.pop()
TOON = ROOT / "faces/compat/toon.face.json"
RANDOM = numpy.random.default_rng(7)


def run(*words):
    subprocess.run([COMMAND, *map(str, words)], check=True, stdout=subprocess.DEVNULL)


class Bases(unittest.TestCase):
    def test_are_numpys(self):
        frames = RANDOM.normal(size=(12, 5, 3)) * numpy.linspace(3, 1, 15).reshape(5, 3)
        basis = mien.fit_basis(frames, components=4)
        self.assertEqual((basis.shape, len(basis), basis.of_face), ((12, 5, 3), 4, False))
        rows = frames.reshape(12, 15)
        _, singular, v = numpy.linalg.svd(rows - rows.mean(0), full_matrices=False)
        numpy.testing.assert_allclose(basis.mean.ravel(), rows.mean(0), atol=1e-12)
        numpy.testing.assert_allclose(basis.variances, singular[:4] ** 2 / 11, rtol=1e-9)
        numpy.testing.assert_allclose(abs((basis.components.reshape(4, 15) * v[:4]).sum(1)), 1, atol=1e-9)
        numpy.testing.assert_allclose(basis.decode(), basis.mean + numpy.tensordot(basis.weights, basis.components, 1), atol=1e-12)
        numpy.testing.assert_allclose(basis.encode(frames), basis.weights, atol=1e-9)
        numpy.testing.assert_allclose(basis.decode([[2.0]])[0], basis.mean + 2 * basis.components[0], atol=1e-12)
        self.assertEqual(len(mien.fit_basis(rows, variance=1e-9)), 1)
        self.assertLess(abs(mien.fit_basis(frames, max_error=0.5).decode() - frames).max(), 0.5)

    def test_pose_faces_as_the_command_does(self):
        face = mien.read_face(TOON)
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = pathlib.Path(folder, "ours.basis"), pathlib.Path(folder, "theirs.basis")
            basis = face.fit_basis(40, fps=20, first=10, components=6)
            basis.save(ours)
            run("pca", "fit", TOON, "--frames", "10-49", "--fps", "20", "--components", "6", "-o", theirs)
            numpy.testing.assert_array_equal(mien.read_basis(theirs).components, basis.components)
            self.assertEqual(ours.read_bytes(), theirs.read_bytes())
            again = mien.read_basis(ours)
            self.assertEqual((again.fps, again.begin, again.of_face, again.shape[0]), (20, 0.5, True, 40))
            with ours.open("rb") as file:
                self.assertEqual(json.loads(numpy.load(file).tobytes())["vertices"], face.vector.size)
            picture = pathlib.Path(folder, "p.png")
            run("render", TOON, "--basis", ours, "--weights=0.1,-0.2", "--size", "64x36", "-o", picture)
            got = face.pose(basis=again, weights=[0.1, -0.2]).render((64, 36))
            self.assertEqual(unpacked(picture), got[..., :3].tobytes())
            whole = face.fit_basis(40, fps=20, first=10, components=40)
            numpy.testing.assert_allclose(face.pose(basis=whole, time=1.0).vector, face.pose(time=1.0).vector, atol=1e-9)

    def test_fail_in_sentences(self):
        face, numbers = mien.read_face(TOON), mien.fit_basis([[0.0, 1], [1, 3]], components=1)
        for call, words in ((lambda: face.pose(basis=numbers), "not of a face"), (lambda: face.pose(weights=[1]), "weights"),
                            (lambda: mien.fit_basis([[0.0, 1], [1, 3]]), "one of them"), (lambda: mien.fit_basis([1.0, 2], components=1), "frames"),
                            (lambda: mien.fit_basis([[0.0, 1], [1, 3]], components=3), ""), (lambda: numbers.decode([1.0]), "weights"),
                            (lambda: mien.fit_basis([[numpy.nan, 1], [1, 3]], components=1), "finite"), (lambda: numbers.encode([[1.0]]), "frames"),
                            (lambda: face.fit_basis(0, components=1), "count"), (lambda: face.fit_basis(3, fps=0, components=1), "fps"),
                            (lambda: mien.read_basis("nowhere.basis"), "nowhere")):
            with self.assertRaisesRegex(mien.Error, words):
                call()


class Debug(unittest.TestCase):
    def test_pictures_are_the_commands(self):
        face = mien.read_face(TOON)
        posed = face.pose(time=1.25)
        with tempfile.TemporaryDirectory() as folder:
            for which in ("outlines", "regions", "fragments", "looks", "distance", "normals"):
                picture = pathlib.Path(folder, which + ".png")
                run("render", TOON, "--time", "1.25", "--debug", which, "--size", "64x36", "-o", picture)
                got = posed.debug(which, (64, 36))
                self.assertEqual(got.shape, (36, 64, 4))
                self.assertEqual(unpacked(picture), got[..., :3].tobytes(), which)
                numpy.testing.assert_array_equal(posed.debug(which, (64, 36), region=(9, 8, 20, 5), threads=1), got[8:13, 9:29])

    def test_what_moves_a_face(self):
        face = mien.from_code("A66CB-AA5S0-14")
        plain = face.render(40)
        for which in ("muscles", "points", "morph"):
            self.assertTrue((face.pose(emotions={"joy": 1}).debug(which, 40) != plain).any(), which)
        for call, words in ((lambda: mien.read_face(TOON).pose().debug("muscles"), "no muscles"), (lambda: face.pose().debug("outline"), "outlines")):
            with self.assertRaisesRegex(mien.Error, words):
                call()


def unpacked(path):
    """The red, green and blue of an opaque PNG of 8 bits."""
    raw, at, packed = pathlib.Path(path).read_bytes(), 8, b""
    width, height, _, kind = int.from_bytes(raw[16:20], "big"), int.from_bytes(raw[20:24], "big"), raw[24], raw[25]
    while at < len(raw):
        size = int.from_bytes(raw[at:at + 4], "big")
        packed += raw[at + 8:at + 8 + size] if raw[at + 4:at + 8] == b"IDAT" else b""
        at += 12 + size
    bytes_, channels = zlib.decompress(packed), {2: 3, 6: 4}[kind]
    out, above = [], bytearray(width * channels)
    for y in range(height):
        kind, row = bytes_[y * (width * channels + 1)], bytearray(bytes_[y * (width * channels + 1) + 1:(y + 1) * (width * channels + 1)])
        for x in range(len(row)):
            left, corner = (row[x - channels], above[x - channels]) if x >= channels else (0, 0)
            guess = left + above[x] - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - above[x]), 1, above[x]), (abs(guess - corner), 2, corner))[2]
            row[x] = (row[x] + (0, left, above[x], (left + above[x]) // 2, paeth)[kind]) & 255
        out.append(row)
        above = row
    return numpy.frombuffer(b"".join(out), numpy.uint8).reshape(height, width, channels)[..., :3].tobytes()


class Devices(unittest.TestCase):
    def test_formats_are_the_picture(self):
        face = mien.read_face(TOON)
        rgba, size = face.render((40, 30)).astype(int), (40, 30)
        bgrx = face.for_device("bgrx", size)
        numpy.testing.assert_array_equal(bgrx[..., 2::-1], rgba[..., :3])
        self.assertTrue((bgrx[..., 3] == 255).all())
        packed, swapped = face.for_device("rgb565", size), face.for_device("rgb565_swapped", size)
        self.assertEqual((packed.shape, packed.dtype), ((30, 40), numpy.uint16))
        numpy.testing.assert_array_equal(packed.byteswap(), swapped)
        nearest = face.for_device("rgb565", size, dither=False).astype(int)
        for shift, top, channel in ((11, 31, 0), (5, 63, 1), (0, 31, 2)):
            off = (nearest >> shift & top) / top - rgba[..., channel] / 255
            self.assertLess(abs(off).max(), .5 / top + 1 / 255)
        bits = numpy.unpackbits(face.for_device("mono", size), axis=1)
        light = face.render(size, dtype="float32")[..., :3] @ [.2126, .7152, .0722]
        self.assertAlmostEqual(bits.mean(), light.mean(), delta=.01)
        numpy.testing.assert_array_equal(numpy.unpackbits(face.for_device("mono", size, region=(16, 8, 24, 9)), axis=1), bits[8:17, 16:40])

    def test_misuse(self):
        face = mien.read_face(TOON)
        with self.assertRaisesRegex(mien.Error, "rgb565"):
            face.for_device("rgb566")
        with self.assertRaises(mien.Cancelled):
            face.for_device("mono", 64, progress=lambda done: False)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
