#!/usr/bin/env python3
"""The pictures of the docs and the script that draws them: pictures_test.py MIEN"""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MIEN = sys.argv.pop()


def channels(path):
    """Width, channels a pixel, and the channels of a PNG of 8 bits, without a palette."""
    data, at, packed = path.read_bytes(), 8, b""
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert depth == 8 and kind in (2, 6), f"{path}: mien writes no such PNG"
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += 12 + size
    pixel, raw, rows = {2: 3, 6: 4}[kind], zlib.decompress(packed), [bytes(width * 4)]
    stride = width * pixel
    for y in range(height):
        way, row, above = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)]), rows[-1]
        for x in range(stride):
            a, b, c = (row[x - pixel], above[x], above[x - pixel]) if x >= pixel else (0, above[x], 0)
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]  # Paeth's
            row[x] = (row[x] + (0, a, b, (a + b) // 2, nearest)[way]) & 255
        rows.append(bytes(row))
    return width, pixel, b"".join(rows[1:])


def pictures(*words):
    return subprocess.run([ROOT / "tools/pictures", "--mien", MIEN, *words], capture_output=True, text=True)


class Pictures(unittest.TestCase):
    def test_are_those_that_the_pages_show(self):
        pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
        shown = {name for page in pages for name in re.findall(r"pictures/([\w-]+)\.png", page.read_text(encoding="utf-8"))}
        drawn = pictures("--list").stdout.split()
        self.assertEqual(sorted(shown), sorted(drawn))
        self.assertEqual(sorted(file.stem for file in (ROOT / "docs/pictures").iterdir()), sorted(drawn))

    def test_are_what_this_build_draws(self):
        """Some of them, to a level: instruction sets may differ by one. `tools/pictures` draws all anew."""
        names = ("eyes-look", "eyes-blink", "morph_heat", "clay", "debug_looks", "error_map")
        with tempfile.TemporaryDirectory() as folder:
            ran = pictures("--out", folder, names[0] + ".png", *names[1:])
            self.assertEqual((ran.returncode, ran.stdout.split()), (0, list(names)), ran.stderr)
            for name in names:
                made, kept = (channels(pathlib.Path(at, name + ".png")) for at in (folder, ROOT / "docs/pictures"))
                self.assertEqual(made[:2], kept[:2], name)
                self.assertLessEqual(max(abs(a - b) for a, b in zip(made[2], kept[2], strict=True)), 1, name)

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
