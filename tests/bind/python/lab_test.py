#!/usr/bin/env python3
"""The laboratory, for solvers in Python: lab_test.py PROGRAM

PROGRAM exports cases as mien-accuracy does."""
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

PROGRAM = sys.argv.pop()


def sampled(points, x, y):
    """What many write first: the nearest of a hundred points."""
    t = numpy.linspace(0, 1, 100)[:, None]
    curve = (1 - t) ** 2 * points[0] + 2 * t * (1 - t) * points[1] + t**2 * points[2]
    return numpy.hypot(curve[:, 0] - x, curve[:, 1] - y).min()


class Lab(unittest.TestCase):
    def test_passes_who_is_right(self):
        table = mien.lab.check(distance.quad, count=20, program=PROGRAM)
        self.assertGreater(len(table), 10)
        for row in table:
            self.assertEqual((row.cases, row.wrong, row.nan), (20, 0, 0), row.family)
            self.assertLessEqual(row.p999, row.worst)
            self.assertLessEqual(row.worst, 4)  # DistancesContract::kDoubleError
        self.assertIn("0 of", str(table))

    def test_names_who_is_wrong(self):
        table = mien.lab.check(sampled, count=20, program=PROGRAM)
        self.assertGreater(sum(row.wrong for row in table), 100)
        worst = max(table, key=lambda row: row.worst)
        case = numpy.array(worst.worst_case)
        self.assertNotEqual(sampled(case[:6].reshape(3, 2), *case[6:]), distance.quad(case[:6], *case[6:]))
        nothing = mien.lab.check(lambda points, x, y: numpy.nan * x, count=3, program=PROGRAM)
        self.assertTrue(all((row.nan, row.wrong) == (3, 3) for row in nothing))
        self.assertIn(f"{3 * len(nothing)} of {3 * len(nothing)} wrong", str(nothing))
        some = mien.lab.check(lambda points, x, y: distance.quad(points, x, y) if x[0] > 0 else numpy.inf, count=20, program=PROGRAM)
        self.assertEqual(sum(row.wrong for row in some), sum(row.nan for row in some))
        self.assertGreater(sum(row.wrong for row in some), 20)

    def test_tells_its_bars(self):
        last = str(mien.lab.check(distance.quad, count=2, program=PROGRAM)).splitlines()[-1]
        for words in ("1e-6 of the curve's size", "2 ulp of float32", "2^-52 S", "float64 is 4"):
            self.assertIn(words, last)
        self.assertIn("float64 is 8", str(mien.lab.check_feet(distance.feet.quad, count=2, program=PROGRAM)).splitlines()[-1])
        for function in (mien.lab.check, mien.lab.check_feet):
            for name in ("solver", "count", "seed", "program", "cases"):
                self.assertRegex(function.__doc__, rf"(?m)^    [\w, ]*\b{name}\b.*  ")

    def test_refuses_what_is_no_answer(self):
        for answer, said in ((None, "got None: is a return missing"), ("1.5", "'1.5'"), (1j, "1j"), (True, "True"), ([], "got 0"), ([None], "None"), (object(), "object"), ({"d": 1}, "'d'")):
            with self.assertRaisesRegex(mien.Error, f"solver: expected one distance for one place, .*{said}"):
                mien.lab.check(lambda points, x, y: answer, count=1, program=PROGRAM)
        nearest, following = distance.feet.quad([[0, 0], [1, 1], [2, 0]], [0.5], [1])
        for answer, said in ((None, "two feet, .*None: is a return missing"), (nearest, "two feet"), ((nearest,), "two feet"), (5, "two feet"), ((None, None), "a foot with t, distance and normal, got None"),
                             ((nearest, 5), "a foot with t, distance and normal, got 5"), ((nearest, following._replace(t=None)), "one t of a foot.*None"),
                             ((nearest._replace(normal=[1]), following), "one normal of a foot, 2 numbers,.* got 1"), ((nearest._replace(distance=[]), following), "one distance of a foot.* got 0")):
            with self.assertRaisesRegex(mien.Error, f"solver: expected {said}"):
                mien.lab.check_feet(lambda points, x, y: answer, count=1, program=PROGRAM)
        with self.assertRaisesRegex(TypeError, "solver: expected a function"):
            mien.lab.check(5, count=1, program=PROGRAM)
        with self.assertRaises(ZeroDivisionError):  # a solver's own faults are its own
            mien.lab.check(lambda points, x, y: 1 / 0, count=1, program=PROGRAM)
        lost = mien.lab.check_feet(lambda points, x, y: (nearest._replace(distance=numpy.nan), following), count=2, program=PROGRAM)
        self.assertEqual([row.wrong for row in lost], [row.cases for row in lost])

    def test_judges_feet(self):
        table = mien.lab.check_feet(distance.feet.quad, count=20, program=PROGRAM)
        self.assertGreater(len(table), 10)
        for row in table:
            self.assertEqual((row.cases, row.wrong, row.wrong_next), (20, 0, 0), row.family)
            self.assertLessEqual(row.distance, 8)  # FeetContract::kDistance
            self.assertLess(row.normal, 1e-10)

        def spoiled(change):
            def solver(points, x, y):
                return change(*distance.feet.quad(points, x, y))
            table = mien.lab.check_feet(solver, count=20, program=PROGRAM)
            return sum(row.wrong for row in table), sum(row.wrong_next for row in table), max(row.normal for row in table)
        nothing = distance.feet.quad([[0, 0], [0, 0], [0, 0]], 0, 0).next
        self.assertGreater(spoiled(lambda nearest, following: (nearest, nothing))[1], 50)
        self.assertGreater(spoiled(lambda nearest, following: (nearest, nearest))[1], 100)
        self.assertGreater(spoiled(lambda nearest, following: (following, nearest))[0], 100)
        self.assertGreater(spoiled(lambda nearest, following: (nearest._replace(normal=-nearest.normal), following))[2], 1)
        self.assertIn("0 of", str(table))

    def test_says_what_is_missing(self):
        with self.assertRaisesRegex(mien.Error, "cannot be run"):
            mien.lab.check(sampled, program="no-such-laboratory")
        with self.assertRaisesRegex(mien.Error, "solver: expected one distance for one place, got 3"):
            mien.lab.check(lambda points, x, y: [1, 2, 3], count=3, program=PROGRAM)
        with self.assertRaisesRegex(mien.Error, "count|seed|exit"):
            mien.lab.check(sampled, count=-5, program=PROGRAM)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.csv")
            file.write_text("a,b\n")
            with self.assertRaisesRegex(mien.Error, "a.csv: is not a file of"):
                mien.lab.check(sampled, cases=file)
            heading = "family,x0,y0,x1,y1,x2,y2,x,y,distance,rest\n"
            for text, said in (("", "has no cases"), ("axis,1,2\n", "case 1: expected 11 cells, got 3"), ("axis" + ",odd" * 10 + "\n", "case 1: expected numbers in hexadecimal")):
                file.write_text(heading + text)
                with self.assertRaisesRegex(mien.Error, f"a.csv.*{said}"):
                    mien.lab.check(sampled, cases=file)
            with self.assertRaisesRegex(FileNotFoundError, "no.csv"):
                mien.lab.check(sampled, cases=pathlib.Path(folder, "no.csv"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
