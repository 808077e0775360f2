#!/usr/bin/env python3
"""The wheel is made offline, holds what it needs, and draws where nothing else of mien is: wheel_test.py BUILD SOURCE

Exit 77 where the system's Python has no pip, setuptools, wheel or NumPy."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

MISSING = [name for name in ("pip", "setuptools", "wheel", "numpy") if not importlib.util.find_spec(name)]
if MISSING:
    print(f"needs {', '.join('python3-' + name for name in MISSING)}: tools/setup --dev")
    sys.exit(77)
SOURCE, BUILD = pathlib.Path(sys.argv.pop()), pathlib.Path(sys.argv.pop())
# Nobody is asked for anything: a package index that is looked for is not there.
OFFLINE = {**os.environ, "PIP_INDEX_URL": "http://127.0.0.1:9/", "PIP_RETRIES": "0"}
for name in ("MIEN_LIBRARY", "PYTHONPATH"):
    OFFLINE.pop(name, None)


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        made = subprocess.run([sys.executable, SOURCE / "tools/wheel", BUILD, "-o", cls.folder.name], capture_output=True, text=True, env=OFFLINE)
        if made.returncode:
            raise AssertionError(made.stderr)
        cls.wheel = pathlib.Path(made.stdout.strip())

    def test_is_for_every_python_of_this_system(self):
        self.assertRegex(self.wheel.name, r"^mien-\d+\.\d+\.\d+-py3-none-linux_\w+\.whl$")
        names = zipfile.ZipFile(self.wheel).namelist()
        for name in ("mien/__init__.py", "mien/lab.py", "mien/py.typed", "mien/libmien_c.so.0", "mien/libmien_image_c.so.0", "mien/LICENSE"):
            self.assertIn(name, names)
        self.assertFalse([name for name in names if "__pycache__" in name or name.startswith("build/")])

    def test_draws_alone(self):
        there = pathlib.Path(self.folder.name, "there")
        subprocess.run([sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "-q", "--no-index", "--no-deps", "--target", there,
                        self.wheel], check=True, env=OFFLINE)
        program = ("import sys, mien; from mien import _library\n"
                   "posed = mien.read_face(sys.argv[1]).pose(time=1.25)\n"
                   "posed.save(sys.argv[2], 64); posed.save(sys.argv[2] + '.tif', 64)\n"
                   "print(posed.render(64).std() > 0, _library.lib._name, _library.image()._name)")
        picture = pathlib.Path(self.folder.name, "a.png")
        said = subprocess.run([sys.executable, "-c", program, SOURCE / "faces/compat/toon.face.json", picture], capture_output=True, text=True,
                              env={**OFFLINE, "PYTHONPATH": str(there)}, cwd=there)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertEqual(said.stdout.split(), ["True", f"{there}/mien/libmien_c.so.0", f"{there}/mien/libmien_image_c.so.0"])
        self.assertGreater(picture.stat().st_size, 100)

    def test_leaves_the_source_alone(self):
        here = {path.name for path in (SOURCE / "bind/python").iterdir()}
        self.assertFalse(here & {"build", "dist", "mien.egg-info"})

    def test_says_what_is_missing(self):
        with tempfile.TemporaryDirectory() as empty:
            said = subprocess.run([sys.executable, SOURCE / "tools/wheel", empty], capture_output=True, text=True, env=OFFLINE)
            self.assertNotEqual(said.returncode, 0)
            self.assertRegex(said.stderr, "wheel: ")
        bare = subprocess.run([sys.executable, "-S", SOURCE / "tools/wheel", BUILD], capture_output=True, text=True, env=OFFLINE)
        self.assertRegex(bare.stderr, "^wheel: .* has no pip, setuptools, wheel: tools/setup --dev .*\n$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
