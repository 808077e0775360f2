#!/usr/bin/env python3
"""The package itself, and the examples in its documentation: package_test.py MIEN ROOT"""
import csv
import ctypes
import doctest
import importlib
import importlib.util
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
import mien._library
from mien import distance, people

ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = MIEN = sys.argv.pop()


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
