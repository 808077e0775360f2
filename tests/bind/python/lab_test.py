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
        self.assertTrue(all(row.nan == 3 for row in nothing))

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


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
