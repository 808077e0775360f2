#!/usr/bin/env python3
"""The pictures of the docs and the script that draws them: pictures_test.py MIEN"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MIEN = sys.argv.pop()


def pictures(*words):
    return subprocess.run([ROOT / "tools/pictures", "--mien", MIEN, *words], capture_output=True, text=True)


class Pictures(unittest.TestCase):
    def test_are_those_that_the_pages_show(self):
        pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
        shown = {name for page in pages for name in re.findall(r"pictures/([\w-]+)\.png", page.read_text(encoding="utf-8"))}
        drawn = pictures("--list").stdout.split()
        self.assertEqual(sorted(shown), sorted(drawn))
        self.assertEqual(sorted(file.stem for file in (ROOT / "docs/pictures").iterdir()), sorted(drawn))

    def test_are_drawn_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            ran = pictures("--out", folder, "eyes-look.png", "morph_heat")
            self.assertEqual((ran.returncode, ran.stdout), (0, "eyes-look\nmorph_heat\n"), ran.stderr)
            for name in ("eyes-look", "morph_heat"):
                made, kept = (pathlib.Path(at, name + ".png").read_bytes()[:24] for at in (folder, ROOT / "docs/pictures"))
                self.assertEqual(made, kept)  # up to width and height

    def test_of_other_names_are_refused_in_a_sentence(self):
        with tempfile.TemporaryDirectory() as folder:
            ran = pictures("--out", folder, "toon", "eyes-lock")
            self.assertEqual((ran.returncode, ran.stderr), (1, 'tools/pictures: no picture named "eyes-lock"; did you mean "eyes-look"?\n'))
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])

    def test_say_what_mien_says(self):
        ran = pictures("--out", "/none", "toon")
        self.assertEqual(ran.returncode, 1)
        self.assertTrue(ran.stderr.startswith("tools/pictures: toon: mien: /none/toon.png: "), ran.stderr)


if __name__ == "__main__":
    unittest.main()
