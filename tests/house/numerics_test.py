#!/usr/bin/env python3
"""docs/numerics.md is what tools/numerics makes of it: its own words, its own headings, and only figures come from the laboratory."""
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/numerics.md"


def block(text):
    return re.search(r"<!-- errors: made by tools/numerics -->\n(.*?)<!-- end of errors -->", text, re.S)[1]


def words_of(text):
    """Without what the laboratory printed."""
    return re.sub(r"```\n.*?```", "```\n```", text, flags=re.S)


class Numerics(unittest.TestCase):
    def remade(self, folder, *options):
        """The page remade with a laboratory that prints two rows and a set that equals another."""
        laboratory = pathlib.Path(folder, "tools/accuracy/mien-accuracy")
        laboratory.parent.mkdir(parents=True)
        laboratory.write_text("#!/bin/sh\nprintf '%s\\n' 'axis  fast AVX2  5  1.5' 'axis  fast SSE4  5  2.5' 'axis  fast SSSE3  5  2.5'\n")
        laboratory.chmod(0o755)
        page = pathlib.Path(folder, "page.md")
        shutil.copy(PAGE, page)
        subprocess.run([ROOT / "tools/numerics", "--build", folder, "--page", page, "--only", "errors", *options], check=True)
        return page.read_text(encoding="utf-8")

    def test_the_page_is_the_tools(self):
        page = PAGE.read_text(encoding="utf-8")
        options = re.search(r"By `tools/numerics --only errors (--count \d+ --seed \d+)`", block(page))[1].split()
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(words_of(self.remade(folder, *options)), words_of(page))

    def test_rows_that_differ_by_their_set_alone_are_one(self):
        with tempfile.TemporaryDirectory() as folder:
            made = block(self.remade(folder, "--count", "8"))
            self.assertIn("axis  fast AVX2  5  1.5\naxis  fast SSE4  5  2.5  = SSSE3\n", made)
            self.assertIn("a short form; the long one is", made)


if __name__ == "__main__":
    unittest.main()
