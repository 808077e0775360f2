#!/usr/bin/env python3
"""Morph targets, effects, statistics and the newer distances in Python, against NumPy: morphs_effects_test.py SOURCE"""
import pathlib
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
from mien import distance

ROOT = pathlib.Path(sys.argv.pop())
TOON = ROOT / "faces/compat/toon.face.json"
CURVE = [[0, 0], [0.5, 1], [1, 0]]


class Morphs(unittest.TestCase):
    def setUp(self):
        text = TOON.read_text(encoding="utf-8")
        self.rest, self.other = mien.read_face_text(text), mien.read_face_text(text.replace('"skin": "#f6c3a0"', '"skin": "#204a87"'))

    def test_go_from_rest_to_target(self):
        face = self.rest.with_morphs_text(self.rest.morphs_text({"blue": self.other}))
        self.assertTrue(face.names["blue"].is_pose)
        self.assertNotIn("blue", self.rest.names)
        rest, target = self.rest.vector, self.other.vector
        self.assertFalse((rest == target).all())
        numpy.testing.assert_array_equal(face.vector, rest)
        numpy.testing.assert_array_equal(face.pose(set={"blue": 1}).vector, target)
        numpy.testing.assert_allclose(face.pose(set={"blue": 0.25}).vector, rest + 0.25 * (target - rest), atol=1e-12)

    def test_come_from_files_and_fail_in_sentences(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.morphs.json")
            file.write_text(self.rest.morphs_text({"blue": self.other}), encoding="utf-8")
            face = self.rest.with_morphs(file)
            self.assertIn("blue", face.names)
            for call, words in ((lambda: face.with_morphs(file), "blue"), (lambda: self.rest.with_morphs(folder + "/b.json"), "b.json"),
                                (lambda: self.rest.with_morphs_text("{", "mine"), "^mine:1"),
                                (lambda: self.rest.morphs_text({"not a name!": self.other}), "not a name"),
                                (lambda: self.rest.morphs_text({"a": mien.read_face(ROOT / "faces/compat/bruno.face.json")}), "a")):
                with self.assertRaisesRegex(mien.Error, words):
                    call()


class Effects(unittest.TestCase):
    def test_a_mosaic_is_the_means_of_its_tiles(self):
        posed = mien.read_face(TOON).pose(time=1.25)
        plain = posed.render((160, 80), dtype="float32")
        means = plain.reshape(8, 10, 16, 10, 4).mean((1, 3))
        tiled = posed.render((160, 80), dtype="float32", effects=["mosaic:16"])
        numpy.testing.assert_allclose(tiled, means.repeat(10, 0).repeat(10, 1), atol=1e-5)
        numpy.testing.assert_array_equal(posed.render((160, 80), dtype="float32", effects=[]), plain)
        self.assertEqual(posed.render((160, 80), effects=["mosaic:16", "grid:4"]).dtype, numpy.uint8)

    def test_are_those_of_the_face_if_it_is_asked(self):
        text = TOON.read_text(encoding="utf-8")
        face = mien.read_face_text(text.replace('"palette"', '"effects": ["mosaic:16"], "palette"', 1))
        numpy.testing.assert_array_equal(face.render((160, 80), effects=True), mien.read_face(TOON).render((160, 80), effects=["mosaic:16"]))
        numpy.testing.assert_array_equal(face.render((160, 80)), mien.read_face(TOON).render((160, 80)))

    def test_refuse_what_is_none(self):
        posed = mien.read_face(TOON).pose()
        for effects, raised, words in ((["blur:3"], mien.Error, "blur"), (["mosaic:500"], mien.Error, "500 tiles"), ("grid:4", TypeError, "list")):
            with self.assertRaisesRegex(raised, words):
                posed.render((160, 80), effects=effects)
        with self.assertRaises(mien.Cancelled):
            posed.render((160, 80), effects=["grid:4"], progress=lambda _: False)


class Statistics(unittest.TestCase):
    def test_tell_what_a_picture_took(self):
        renderer, posed = mien.Renderer(), mien.read_face(TOON).pose()
        self.assertEqual(renderer.stats.pixels, 0)
        posed.render((160, 80), renderer=renderer)
        stats = renderer.stats
        self.assertEqual(stats.pixels, 160 * 80)
        self.assertEqual(stats.fill_pixels + stats.varied_pixels + stats.edge_pixels, stats.pixels)
        self.assertGreater(stats.roots, 1000)
        self.assertIs(stats.cancelled, False)


class Distances(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(2)
        self.x, self.y = random.uniform(-1, 2, 60), random.uniform(-1, 2, 60)

    def test_to_a_parabola(self):
        u = numpy.linspace(-4, 4, 80001)
        by = numpy.array([numpy.hypot(0.5 + u - a, u * u - b).min() for a, b in zip(self.x, self.y)])
        by[self.y > (self.x - 0.5) ** 2] *= -1
        numpy.testing.assert_allclose(distance.parabola((0.5, 0), (0, 3), 1, self.x, self.y), by, atol=1e-4)
        single = distance.parabola((0.5, 0), (0, 3), 1, self.x.astype("f4"), self.y.astype("f4"))
        self.assertEqual(single.dtype, numpy.float32)
        numpy.testing.assert_allclose(single, by, atol=1e-4)
        with self.assertRaisesRegex(mien.Error, "axis"):
            distance.parabola((0, 0), (0, 0), 1, self.x, self.y)

    def test_to_the_nearest_of_many(self):
        curves = [CURVE, [[0, 2], [1, 2], [2, 2]], [[-1, -1], [-1, 0], [-1, 1]]]
        by = numpy.min([distance.quad(one, self.x, self.y) for one in curves], axis=0)
        found = distance.quads(curves, self.x[:, None], self.y[:, None])
        self.assertEqual((found.dtype, found.shape), (numpy.float32, (60, 1)))
        numpy.testing.assert_allclose(found[:, 0], by, atol=2e-6)
        self.assertTrue(numpy.isinf(distance.quads([], self.x, self.y)).all())
        with self.assertRaisesRegex(mien.Error, "n, 3, 2"):
            distance.quads([1, 2, 3], self.x, self.y)

    def test_accurately_and_on_grids(self):
        x, y = self.x.astype("f4"), self.y.astype("f4")
        exact = distance.quad(CURVE, x.astype("f8"), y.astype("f8"))
        ulp = numpy.spacing(exact.astype("f4")).astype("f8")
        self.assertLess(numpy.max(numpy.abs(distance.quad(CURVE, x, y, accurate=True) - exact) / numpy.maximum(ulp, 1.2e-8)), 0.9)
        grid = distance.quad_on_grid(CURVE, (-0.5, -0.25), 0.0625, 40, 20)
        j, i = numpy.mgrid[:20, :40]
        numpy.testing.assert_allclose(grid, distance.quad(CURVE, -0.5 + 0.0625 * i, -0.25 + 0.0625 * j), atol=1e-6)
        self.assertEqual(distance.quad_on_grid(CURVE, (0, 0), 1, 0, 5).shape, (5, 0))
        with self.assertRaisesRegex(mien.Error, "negative"):
            distance.quad_on_grid(CURVE, (0, 0), 1, -1, 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
