#!/usr/bin/env python3
"""The wheel is made offline, has all that it stands on inside, and draws where nothing else of mien is; so does what pip makes of the source
distribution: wheel_test.py BUILD SOURCE

Exit 77 where the system's Python has no pip, setuptools, wheel or NumPy."""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

MISSING = [name for name in ("pip", "setuptools", "wheel", "numpy") if not importlib.util.find_spec(name)]
if MISSING:
    print(f"needs {', '.join('python3-' + name for name in MISSING)}: tools/setup --dev")
    sys.exit(77)
SOURCE, BUILD = pathlib.Path(sys.argv.pop()), pathlib.Path(sys.argv.pop())
sys.path.insert(0, str(SOURCE / "bind/python"))
sys.dont_write_bytecode = True
import native  # noqa: E402

# Nobody is asked for anything: a package index that is looked for is not there.
OFFLINE = {**os.environ, "PIP_INDEX_URL": "http://127.0.0.1:9/", "PIP_RETRIES": "0", "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1"}
for name in ("MIEN_LIBRARY", "MIEN_COMMAND", "PYTHONPATH"):
    OFFLINE.pop(name, None)
DRAWS = """
import sys, mien
from mien import _command, _library
posed = mien.sample("toon").pose(time=1.25)
posed.save("a.png", 64); mien.from_seed("ada").animate("a.gif", frames=2, size=32); mien.chernoff({"a": [1, 2]}, cell=32)
mapped = {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}
print(posed.render(64).std() > 0, _library.lib._name, _library.image()._name, _command.found())
print(*sorted(path for path in mapped if any(name in path for name in ("/libtbb", "/libfmt", "/libhwy", "/libdeflate"))))
"""


def made(*words):
    ran = subprocess.run([sys.executable, SOURCE / "tools/wheel", *words], capture_output=True, text=True, env=OFFLINE)
    if ran.returncode:
        raise AssertionError(ran.stderr)
    return pathlib.Path(ran.stdout.strip())


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.wheel = made(BUILD, "-o", cls.folder.name)

    def installed(self, wheel, name):
        there = pathlib.Path(self.folder.name, name)
        subprocess.run([sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "-q", "--no-index", "--no-deps", "--target", there,
                        wheel], check=True, env=OFFLINE)
        return there

    def test_is_for_every_python_of_systems_that_are_new_enough(self):
        self.assertRegex(self.wheel.name, r"^mien-\d+\.\d+\.\d+-py3-none-manylinux_2_\d\d_\w+\.whl$")
        names = zipfile.ZipFile(self.wheel).namelist()
        for name in ("mien/__init__.py", "mien/lab.py", "mien/py.typed", "mien/widget.js", "mien/native/libmien_c.so.0", "mien/native/libmien_image_c.so.0",
                     "mien/native/mien", "mien/native/mien-accuracy", "mien/native/libtbb.so.12", "mien/native/licences/libtbb12.txt", "mien/share/mien/faces/toon.face.json", "mien/LICENSE"):
            self.assertIn(name, names)
        self.assertFalse([name for name in names if "__pycache__" in name or name.startswith(("build/", "native.py")) or "purelib" in name or "compat" in name])
        bundled = [name for name in names if re.search(r"native/lib.*\.so", name) and "mien_" not in name]
        self.assertTrue(len(bundled) > 5 and not [name for name in bundled if re.search(r"lib(c|m|stdc\+\+|gcc_s)\.so", name)])
        # What this machine's own C library is older than pip would not install.
        self.assertLessEqual(int(re.search(r"manylinux_2_(\d+)", self.wheel.name)[1]), int(os.confstr("CS_GNU_LIBC_VERSION").rpartition(".")[2]))

    def test_draws_alone(self):
        there = self.installed(self.wheel, "there")
        inside = there / "mien/native"
        for file in inside.iterdir():
            if file.name.startswith(("libmien", "mien")):
                places = re.findall(r"R(?:UN)?PATH.*\[(.*)\]", subprocess.run(["readelf", "-d", "-W", file], capture_output=True, text=True).stdout)
                self.assertIn(places, ([], ["$ORIGIN"]), file.name)
        ran = subprocess.run([sys.executable, "-W", "error", "-c", DRAWS], capture_output=True, text=True, env={**OFFLINE, "PYTHONPATH": str(there)}, cwd=self.folder.name)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        first, libraries = ran.stdout.splitlines()
        self.assertEqual(first.split(), ["True", f"{inside}/libmien_c.so.0", f"{inside}/libmien_image_c.so.0", f"{inside}/mien"])
        self.assertEqual(libraries.split(), [str(inside / name) for name in ("libdeflate.so.0", "libfmt.so.9", "libhwy.so.1", "libtbb.so.12")])
        told = subprocess.run(["ldd", inside / "mien"], capture_output=True, text=True, env=OFFLINE).stdout
        outside = [name for name, path in re.findall(r"(\S+) => (\S+)", told) if not path.startswith(str(inside))]
        self.assertFalse([name for name in outside if not native.EVERYWHERE.fullmatch(name)], told)
        judged = subprocess.run([sys.executable, "-c", "import mien; print(mien.lab.check(mien.distance.quad, count=3))"], capture_output=True, text=True,
                                env={**OFFLINE, "PYTHONPATH": str(there)}, cwd=self.folder.name)
        self.assertRegex(judged.stdout, r"\n0 of \d+ wrong", judged.stderr)
        said = subprocess.run([sys.executable, "-m", "mien", "render", "toon", "-o", "b.png", "--size", "32"], cwd=self.folder.name, capture_output=True, text=True,
                              env={**OFFLINE, "PYTHONPATH": str(there)})
        self.assertEqual(said.returncode, 0, said.stderr)

    def test_comes_out_of_the_source_distribution_too(self):
        source = made("--source", "-o", self.folder.name)
        with tarfile.open(source) as archive:
            names = archive.getnames()
            archive.extractall(self.folder.name)
        top = source.name[:-len(".tar.gz")]
        for name in ("PKG-INFO", "pyproject.toml", "setup.py", "native.py", "mien/__init__.py", "source/CMakeLists.txt", "source/lib/base/parallel.cpp", "source/LICENSE"):
            self.assertIn(f"{top}/{name}", names)
        self.assertFalse([name for name in names if "__pycache__" in name or "/build/" in name or "/tests/" in name])
        # What is left out is named here: a new folder of sources is missed.
        left_out = {"CHANGELOG.md", "CITATION.cff", "CMakePresets.json", "CONTRIBUTING.md", "README.md", "SECURITY.md", "bench", "build", "docs", "examples", "fuzz", "out", "tests"}
        for path in SOURCE.iterdir():
            if path.name not in left_out and not path.name.startswith("."):
                self.assertIn(f"{top}/source/{path.name}", names)
        # CMake finds every file that a build asks for. The build itself would take a quarter of an hour; pip is given one that is there.
        here = pathlib.Path(self.folder.name, top)
        configured = subprocess.run(["cmake", "-S", here / "source", "-B", here / "tried", "-G", "Ninja", "-Wno-dev", "-DMIEN_BUILD_TESTS=OFF", "-DMIEN_BUILD_SERVER=OFF",
                                     "-DCMAKE_BUILD_TYPE=Release"], capture_output=True, text=True)
        self.assertEqual(configured.returncode, 0, configured.stderr)
        ran = subprocess.run([sys.executable, "setup.py", "-q", "build_py", "-d", "laid"], cwd=here, capture_output=True, text=True, env={**OFFLINE, "MIEN_BUILD": str(BUILD)})
        self.assertEqual(ran.returncode, 0, ran.stderr)
        laid = {file.relative_to(here / "laid").as_posix() for file in (here / "laid").rglob("*") if file.is_file()}
        self.assertEqual(laid, {name for name in zipfile.ZipFile(self.wheel).namelist() if "dist-info" not in name})

    def test_tells_of_what_age_it_is(self):
        """Of files whose symbols are known: this machine's libraries."""
        self.assertRegex(native.tag([]), "^manylinux_2_17_")
        self.assertNotRegex(native.tag([shutil.which("ls")]), "^manylinux_2_17_")

    def test_leaves_the_source_alone(self):
        here = {path.name for path in (SOURCE / "bind/python").iterdir()}
        self.assertFalse(here & {"build", "dist", "mien.egg-info", "build-mien"})

    def test_says_what_is_missing(self):
        with tempfile.TemporaryDirectory() as empty:
            said = subprocess.run([sys.executable, SOURCE / "tools/wheel", empty, "-o", empty], capture_output=True, text=True, env=OFFLINE)
            self.assertNotEqual(said.returncode, 0)
            self.assertRegex(said.stderr, "wheel: .*has no libmien_c.so.0: it is built with -DMIEN_BUILD_C=ON")
            # A file that looks for libraries where it must not.
            wrong = pathlib.Path(empty, "libmien_c.so.0")
            shutil.copy(BUILD / "libmien_c.so.0", wrong)
            raw = wrong.read_bytes()
            self.assertIn(b"$ORIGIN:", raw)
            wrong.write_bytes(raw.replace(b"$ORIGIN:", b"/ORIGIN:", 1))
            with self.assertRaisesRegex(SystemExit, "looks for libraries in /ORIGIN:, and should in its own folder alone"):
                native.find_beside(wrong)
        bare = subprocess.run([sys.executable, "-S", SOURCE / "tools/wheel", BUILD], capture_output=True, text=True, env=OFFLINE)
        self.assertRegex(bare.stderr, "^wheel: .* has no pip, setuptools, wheel: tools/setup --dev .*\n$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
