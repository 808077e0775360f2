#!/usr/bin/env python3
"""docs/solvers.md is what tools/solvers makes of it, and the fixtures have the sums it says: solvers_test.py SOURCE BUILD PROGRAM

PROGRAM exports cases as mien-accuracy does; the page is remade where BUILD has mien-accuracy itself."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

SOURCE, BUILD, PROGRAM = map(pathlib.Path, sys.argv[1:])
PAGE = SOURCE / "docs/solvers.md"
CPU = pathlib.Path("/proc/cpuinfo")
FUSES = not CPU.exists() or re.search(r"\bfma\b|\basimd\b", CPU.read_text())


def words_of(text):
    """Without what was measured: only what stands in every run."""
    text = re.sub(r"\d+: [^|\n]+|none ", "0 ", text)  # which cases a field reaches depends on how many there are
    return re.sub(r"(\d[\d.e+-]*|∞)", "0", re.sub(r" \*\*\d+\*\*", "", re.sub(r"^(\| (?:mien|numpy|closed|complex|Newton|bisection|subdivision)[^|]*f\d\d \|).*", r"\1", text, flags=re.M)))


class Solvers(unittest.TestCase):
    def test_fixtures_have_the_sums_of_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, SOURCE / "tools/solvers", "--fixtures", folder, "--program", PROGRAM], check=True, stdout=subprocess.DEVNULL)
            array = numpy.load(pathlib.Path(folder, "hard_cases.npy"))
            self.assertEqual((array.shape, array.dtype), ((10000, 11), numpy.float64))
            self.assertEqual(sorted(set(array[:, 0])), list(range(25)))
            self.assertTrue((array[:, 9] >= 0).all() and (abs(array[:, 10]) <= numpy.spacing(array[:, 9])).all())
            self.assertIn("CC0", pathlib.Path(folder, "LICENSE").read_text())
            sums = pathlib.Path(folder, "SHA256SUMS").read_text()
            if not FUSES:
                self.skipTest("the C library's last digits are others without fused multiply-add")
            for line in sums.splitlines():
                self.assertIn(line, PAGE.read_text(encoding="utf-8"))

    def test_the_page_is_the_tools(self):
        if not (BUILD / "tools/accuracy/mien-accuracy").exists():
            self.skipTest("needs the build with -DMIEN_BUILD_ACCURACY=ON")
        page = PAGE.read_text(encoding="utf-8")
        seed = re.search(r"By `tools/solvers --count \d+ --seed (\d+)`", page)[1]
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder, "page.md")
            shutil.copy(PAGE, made)
            subprocess.run([sys.executable, SOURCE / "tools/solvers", "--count", "40", "--seed", seed, "--build", BUILD, "--page", made], check=True)
            self.assertEqual(words_of(made.read_text(encoding="utf-8")), words_of(page))

    def test_a_field_keeps_what_its_bytes_can(self):
        rows = re.findall(r"^\| \d+ px, spread \d+ \| \S+ \| \S+ \| (\d+) \| (\d+) \| ([\d.]+) \| ([\d.]+) \|", PAGE.read_text(encoding="utf-8"), re.M)
        self.assertEqual(len(rows), 3)
        for cases, within, worst, mean in rows:
            self.assertLess(int(cases) / 20, int(within))
            self.assertGreaterEqual(float(worst), 0.5)
            self.assertLess(float(mean), 2)

    def test_mien_is_right_on_the_page(self):
        rows = re.findall(r"^\| (mien[^|]*) \| ([\d.]+) \| [^|]* \| [\d.]+ \| (\d+) \| (\d+) \|", PAGE.read_text(encoding="utf-8"), re.M)
        self.assertEqual(len(rows), 4)
        for name, worst, bad, nan in rows:
            self.assertEqual((bad, nan), ("0", "0"), name)
            self.assertLessEqual(float(worst), 4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
