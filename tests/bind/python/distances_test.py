#!/usr/bin/env python3
"""Distances and feet: distances_test.py MIEN ROOT"""
import os
import pathlib
import sys
import tracemalloc
import unittest

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
from mien import distance

ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = sys.argv.pop()
TOON = ROOT / "faces/compat/toon.face.json"


def toon():
    return mien.read_face(TOON)


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


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
