#!/usr/bin/env python3
"""A C library's binary interface is the one kept in a file: functions, structs, and the values of constants.

    abi_test.py ABIDW ABIDIFF LIBRARY HEADER KEPT            tests
    abi_test.py ABIDW ABIDIFF LIBRARY HEADER KEPT --write    keeps what is there now: cmake --build … --target mien_keep_abi

LIBRARY has debug information. What programs rely on may grow, which is kept by --write, but never change: exit bit 8 of abidiff is
a change that breaks them.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ABIDW, ABIDIFF, LIBRARY, HEADER, KEPT = sys.argv[1:6]
HEADER = str(pathlib.Path(HEADER).resolve())
BREAKS = 8


def described():
    """The interface as abidw tells it, and the header's constants, in comments."""
    told = subprocess.run([ABIDW, "--header-file", HEADER, "--drop-private-types", "--exported-interfaces-only", "--no-show-locs",
                           "--no-comp-dir-path", "--no-corpus-path", "--no-elf-needed", LIBRARY],
                          capture_output=True, text=True, check=True).stdout
    told = re.sub(r" path='[^']*/", " path='", told)  # of the source, on one machine
    return told + "".join(f"<!-- {name} = {value} -->\n" for name, value in constants(pathlib.Path(HEADER).read_text(encoding="utf-8")))


def constants(text):
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return re.findall(r"\b(MIEN_\w+) = (-?\d+)", text) + re.findall(r"#define (MIEN_\w+) (\d+|\(.+\))$", text, re.M)


def kept_constants(text):
    return re.findall(r"<!-- (\w+) = (.+) -->", text)


def difference(old, new):
    """abidiff's exit code and words for two descriptions."""
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder, name) for name in ("old.abi", "new.abi")]
        for file, text in zip(files, (old, new)):
            file.write_text(text, encoding="utf-8")
        ran = subprocess.run([ABIDIFF, *files], capture_output=True, text=True)
        return ran.returncode, ran.stdout + ran.stderr


class BinaryInterface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.now, cls.kept = described(), pathlib.Path(KEPT).read_text(encoding="utf-8")

    def test_is_the_kept_one(self):
        code, words = difference(self.kept, self.now)
        self.assertFalse(code & BREAKS, f"programs that were linked to {LIBRARY} would break:\n{words}")
        self.assertEqual(code, 0, "another interface. Where it has only grown, by functions and by fields at the end of a struct, keep it: "
                                  f"cmake --build … --target mien_keep_abi\n{words}")

    def test_keeps_the_values_of_constants(self):
        now = dict(constants(pathlib.Path(HEADER).read_text(encoding="utf-8")))
        for name, value in kept_constants(self.kept):
            self.assertEqual(now.get(name), value, f"programs were built with another {name}")
        self.assertEqual(now, dict(kept_constants(self.kept)), "constants have grown; keep them: cmake --build … --target mien_keep_abi")

    def test_is_described_at_all(self):
        declared = re.findall(r"MIEN_C_API.*?\b(mien_\w+)\(", pathlib.Path(HEADER).read_text(encoding="utf-8"), re.S)
        for name in set(declared):
            self.assertTrue(f"<function-decl name='{name}'" in self.now, f"{name} is not described")
        for struct in re.findall(r"typedef struct (\w+) \{", pathlib.Path(HEADER).read_text(encoding="utf-8")):
            # Or abidiff would take it for a handle, of which anything may be behind.
            self.assertTrue(f"<class-decl name='{struct}' size-in-bits" in self.now, f"{struct} is declared, not described")

    def test_sees_a_function_that_is_gone(self):
        name = re.search(r"<function-decl name='(mien_\w+)'", self.kept)[1]
        without = re.sub(rf" *<elf-symbol name='{name}'.*\n", "", self.kept)
        without = re.sub(rf" *<function-decl name='{name}'.*?</function-decl>\n", "", without, flags=re.S)
        code, words = difference(self.kept, without)
        self.assertTrue(code & BREAKS, words)
        self.assertIn(name, words)

    def test_sees_a_field_that_has_moved(self):
        struct = re.search(r"<class-decl name='(mien_\w+)' size-in-bits.*?</class-decl>", self.kept, re.S)
        self.assertIsNotNone(struct)
        # The second field is where the third one was: a field has been put between.
        moved = struct[0].replace("layout-offset-in-bits='32'", "layout-offset-in-bits='64'")
        self.assertNotEqual(moved, struct[0])
        code, words = difference(self.kept, self.kept.replace(struct[0], moved))
        self.assertNotEqual(code, 0)
        self.assertIn(struct[1], words)


if __name__ == "__main__":
    if sys.argv[6:] == ["--write"]:
        pathlib.Path(KEPT).write_text(described(), encoding="utf-8")
    else:
        unittest.main(argv=sys.argv[:1])
