#!/usr/bin/env python3
"""THIRD_PARTY.md names every library that the build looks for and every file that others made; somebody holds mien's own copyright."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CREDITS = (ROOT / "THIRD_PARTY.md").read_text(encoding="utf-8")
SAID_AS = {"hwy": "highway", "tiff": "libtiff", "oiio": "openimageio", "deflate": "libdeflate", "gtest": "googletest", "benchmark": "google benchmark",
           "eigen3": "eigen", "nlohmann_json": "json for modern c++", "tbb": "onetbb", "freetype2": "freetype"}
NO_LIBRARIES = {"pkgconfig", "threads", "python3", "mien"}


def files(*ends):
    folders = ("bench", "bind", "cmake", "faces", "fuzz", "lib", "render", "sdf", "tests", "tools")
    return [p for folder in folders for p in sorted((ROOT / folder).rglob("*")) if p.name.endswith(ends)] + [ROOT / "CMakeLists.txt"]


class Credits(unittest.TestCase):
    def test_name_every_library(self):
        text = "\n".join(p.read_text(encoding="utf-8") for p in files("CMakeLists.txt", ".cmake") if "install" not in p.parts)
        found = {name.lower() for name in re.findall(r"(?:find_package|pkg_check_modules)\((\w+)", text)} - NO_LIBRARIES
        self.assertGreater(len(found), 12)
        for name in sorted(found):
            self.assertIn(SAID_AS.get(name, name), CREDITS.lower())
        imported = "\n".join(p.read_text(encoding="utf-8") for p in files(".py"))
        for name in re.findall(r"^ +(?:import|from) (numpy|jsonschema)", imported, re.M):
            self.assertIn(name, CREDITS.lower())

    def test_name_every_file_that_others_made(self):
        for path in files(".js", ".h", ".cpp", ".json", "LICENSE"):
            if "Copyright (c)" in path.read_text(encoding="utf-8", errors="replace")[:2000]:
                self.assertIn(str(path.relative_to(ROOT)), CREDITS)

    def test_say_whose_mien_is(self):
        self.assertRegex((ROOT / "README.md").read_text(encoding="utf-8"), r"Copyright \d{4} \w")


if __name__ == "__main__":
    unittest.main()
