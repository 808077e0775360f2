#!/usr/bin/env python3
"""tools/freeze_edition makes editions, and tools/check_editions.py finds every change of a frozen one."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
HASHES = "faces 10 0x1\npictures fused 10 0x2\npictures unfused 10 0x3\n"


class Editions(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.write("Z/topology.json", '{"format": "mien-topology", "edition": "Z"}')
        self.write("Z/hair/bob.part.json", '{"name": "bob"}')

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return self.root / "parts" / name

    def write(self, name, text):
        self.path(name).parent.mkdir(parents=True, exist_ok=True)
        self.path(name).write_text(text)

    def ran(self, tool, *words):
        run = subprocess.run([sys.executable, TOOLS / tool, *words], capture_output=True, text=True)
        return run.returncode, run.stdout + run.stderr

    def freeze(self, sign, *more):
        code, said = self.ran("freeze_edition", sign, "--no-hashes", "--root", self.root, *more)
        if code == 0:
            with open(self.path(f"{sign}.lock"), "a") as lock:
                lock.write(HASHES)
        return code, said

    def refused(self, sign, sentence):
        before = sorted(self.root.rglob("*"))
        code, said = self.freeze(sign)
        self.assertEqual((code, said.count("\n")), (1, 1), said)
        self.assertIn(sentence, said)
        self.assertEqual(sorted(self.root.rglob("*")), before)

    def check(self):
        return self.ran("check_editions.py", self.root)

    def breach(self, sentence):
        code, said = self.check()
        self.assertEqual(code, 1)
        self.assertIn(sentence, said)

    def test_a_frozen_edition_is_in_order(self):
        self.assertEqual(self.check()[0], 0)
        self.assertEqual(self.freeze("A")[0], 0)
        self.assertEqual(self.check(), (0, "1 frozen editions, each as it was frozen\n"))
        self.assertIn('"edition": "A"', self.path("A/topology.json").read_text())
        self.write("Z/hair/bob.part.json", "the trial edition may change")
        self.assertEqual(self.check()[0], 0)

    def test_every_change_is_found(self):
        self.freeze("A")
        shutil.copytree(self.root, self.root / "sound", dirs_exist_ok=True)
        bob = "A/hair/bob.part.json"
        plant = {
            "parts/A/hair/bob.part.json:1: edition A is frozen, and this file was changed": lambda: self.write(bob, '{"name": "bob" }'),
            "this file of it is gone": lambda: self.path(bob).unlink(),
            "a new part is of the next edition": lambda: self.write("A/hair/wig.part.json", "{}"),
            "edition A is not locked": lambda: self.path("A.lock").unlink(),
            "edition A is gone": lambda: shutil.rmtree(self.path("A")),
            "no hash of pictures fused": lambda: self.write("A.lock", self.path("A.lock").read_text().replace("pictures fused", "")),
        }
        for sentence, fault in plant.items():
            fault()
            self.breach(sentence)
            shutil.rmtree(self.root / "parts")
            shutil.copytree(self.root / "sound/parts", self.root / "parts")
            self.assertEqual(self.check()[0], 0)

    def test_the_next_edition_has_what_is_new(self):
        self.freeze("A")
        self.refused("B", "has nothing that edition A has not")
        self.write("Z/hair/wig.part.json", '{"name": "wig"}')
        self.assertEqual(self.freeze("B")[0], 0)
        self.assertEqual([path.name for path in self.path("B").rglob("*.json")], ["wig.part.json"])
        self.assertEqual(self.check()[0], 0)
        self.write("Z/hair/cap.part.json", "{}")
        self.assertEqual(self.freeze("C")[0], 0)
        self.assertEqual([path.name for path in self.path("C").rglob("*.json")], ["cap.part.json"])

    def test_what_cannot_be_is_refused(self):
        self.refused("Z", "Z is the trial edition")
        self.refused("I", "an edition's sign is one of")
        self.freeze("B")
        self.refused("A", "edition B is frozen already")
        self.write("Z/hair/bob.part.json", '{"name": "bob", "number": 2}')
        self.refused("C", "hair/bob.part.json. A better part is a new one")
        self.assertEqual(self.freeze("C", "--anew")[0], 0)
        self.assertEqual(len(list(self.path("C").rglob("*.json"))), 2)

    def test_pictures_are_drawn_again_of_what_is_frozen_alone(self):
        for sign, more, sentence in [("A", ["--no-hashes"], "leave out --no-hashes"), ("A", ["--build", "."], "is no configured build folder")]:
            code, said = self.ran("freeze_edition", sign, "--pictures", "--root", self.root, *more)
            self.assertEqual((code, said.count("\n")), (1, 1), said)
            self.assertIn(sentence, said)
        (self.root / "CMakeCache.txt").write_text("")
        code, said = self.ran("freeze_edition", "A", "--pictures", "--root", self.root, "--build", ".")
        self.assertEqual((code, said), (1, "freeze_edition: there is no frozen edition A\n"))

    def test_without_a_build_nothing_is_frozen(self):
        code, said = self.ran("freeze_edition", "A", "--root", self.root)
        self.assertEqual(code, 1)
        self.assertIn("no configured build folder", said)
        self.assertFalse(self.path("A").exists())


if __name__ == "__main__":
    unittest.main()
