#!/usr/bin/env python3
"""tools/wrap_pages wraps words and nothing else, once; and the README stays short."""
import pathlib
import runpy
import unittest

WRAP = pathlib.Path(__file__).resolve().parents[2] / "tools/wrap_pages"
wrapped = runpy.run_path(str(WRAP))["page"]
LONG = " ".join(["word"] * 40)


class Pages(unittest.TestCase):
    def test_words_are_wrapped_once(self):
        text = f"{LONG}\n{LONG}\n\n* item {LONG}\n  {LONG}\n* `{LONG[:99]}` {LONG}\n1. {LONG}\n"
        new = wrapped(text)
        self.assertLessEqual(max(map(len, new.splitlines())), 120)
        self.assertEqual(new.split(), text.split())
        self.assertIn("`" + LONG[:99] + "`", new)
        self.assertEqual(wrapped(new), new)
        self.assertEqual([line[:6] for line in new.splitlines() if line[:1] in ("*", "1")], ["* item", "* `wor", "1. wor"])

    def test_other_lines_stay(self):
        text = f"# {LONG}\n\n| {LONG} |\n|---|\n\n```sh\n{LONG}\n```\n\n    {LONG}\n\n![{LONG}](a.png)\n"
        self.assertEqual(wrapped(text), text)

    def test_the_readme_fits_two_screens(self):
        self.assertLessEqual(WRAP.parent.parent.joinpath("README.md").stat().st_size, 6 * 1024)


if __name__ == "__main__":
    unittest.main()
