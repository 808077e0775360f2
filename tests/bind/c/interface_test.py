#!/usr/bin/env python3
"""What libmien_c exports is what its header declares, all of it is tested, and nothing else is seen: interface_test.py LIBRARY HEADER"""
import pathlib
import re
import subprocess
import sys
import unittest

HEADER = pathlib.Path(sys.argv.pop())
LIBRARY = sys.argv.pop()
HERE = pathlib.Path(__file__).resolve().parent


def said(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def without_comments(path):
    return re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.S)


class Interface(unittest.TestCase):
    declared = set(re.findall(r"\b(mien_\w+)\(", "".join(re.findall(r"MIEN_C_API.*?;", without_comments(HEADER), flags=re.S))))

    def test_is_what_the_header_declares(self):
        lines = [line.split() for line in said("nm", "-D", "--defined-only", LIBRARY).splitlines()]
        self.assertGreater(len(self.declared), 3)
        self.assertEqual({name for _, kind, name in lines if kind != "A"}, {f"{name}@@MIEN_C_0" for name in self.declared})
        self.assertEqual([name for _, kind, name in lines if kind == "A"], ["MIEN_C_0"])

    def test_has_a_version_of_its_own(self):
        abi = re.search(r"#define MIEN_C_ABI (\d+)", (HEADER.parents[0 if HEADER.name == "mien_c.h" else 1] / "mien_c.h").read_text())[1]
        name = re.search(r"lib\w+", LIBRARY)[0] if "/" not in LIBRARY else re.search(r"lib\w+(?=\.so)", LIBRARY)[0]
        self.assertIn(f"[{name}.so.{abi}]", said("readelf", "-d", LIBRARY))

    def test_drags_nothing_large_along(self):
        needs = re.findall(r"NEEDED.*\[(.*)\]", said("readelf", "-d", LIBRARY))
        self.assertTrue(needs)
        self.assertFalse([need for need in needs if re.search("(?i)openimageio|tiff|libmien\\.so|libmien_image\\.so", need)])

    def test_is_tested_function_by_function(self):
        called = set(re.findall(r"\b(mien_\w+)\(", "".join(without_comments(path) for path in HERE.glob("*.c"))))
        self.assertEqual(self.declared - called, set())

    def test_header_is_plain_c(self):
        text = without_comments(HEADER)
        self.assertFalse(re.findall(r"\bbool\b|\.\.\.|\benum \w+ \w+;|//", text))
        for struct in re.findall(r"typedef struct \w+ \{(.*?)\}", text, flags=re.S):
            self.assertRegex(struct, r"^\s*uint32_t size;")


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
