"""tools/release on a small tree of its own: release_test.py SOURCE"""
import hashlib
import importlib.machinery
import importlib.util
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(sys.argv.pop())
LOADER = importlib.machinery.SourceFileLoader("release", str(SOURCE / "tools/release"))
release = importlib.util.module_from_spec(importlib.util.spec_from_loader("release", LOADER))
LOADER.exec_module(release)
CHANGELOG = "# Changelog\n\n## [Unreleased]\n\n### Added\n\n* A mouth.\n\n## [0.1.0] - 2026-01-02\n\n* A face.\n"


class Release(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name).resolve()
        for file in ("version.h", *(file for file, _ in release.PLACES)):
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / file, self.root / file)
        (self.root / ".gitignore").write_text("/build/\n")
        (self.root / "CHANGELOG.md").write_text(CHANGELOG)
        self.git("init", "-q")
        self.git("config", "user.name", "somebody")
        self.git("config", "user.email", "somebody@localhost")
        self.commit()
        self.steps = release.STEPS

    def tearDown(self):
        release.STEPS = self.steps
        self.folder.cleanup()

    def git(self, *words):
        return subprocess.run(["git", *words], cwd=self.root, check=True, capture_output=True, text=True).stdout.strip()

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-qm", "as it is")

    def prepared(self):
        release.prepare(self.root, "9.8.7", "2026-05-04")
        self.commit()

    def test_this_tree_is_of_one_version(self):
        version = release.version_of_header((SOURCE / "version.h").read_text())
        for file, pattern in release.PLACES:
            self.assertEqual(release.re.search(pattern, (SOURCE / file).read_text())[1], version, file)

    def test_prepared_is_ready(self):
        self.prepared()
        self.assertEqual(list(release.faults(self.root, "9.8.7")), [])
        text = (self.root / "CHANGELOG.md").read_text()
        self.assertEqual(release.notes(text, "9.8.7"), "### Added\n\n* A mouth.")
        self.assertEqual(release.notes(text, "0.1.0"), "* A face.")
        self.assertIn("## [Unreleased]\n\n## [9.8.7] - 2026-05-04\n", text)
        release.prepare(self.root, "9.8.7", "2026-05-05")  # again: nothing
        self.assertEqual((self.root / "CHANGELOG.md").read_text(), text)

    def test_each_fault_is_named(self):
        self.prepared()
        self.assertIn("no version", *release.faults(self.root, "9.8"))
        self.assertTrue(any("version.h is of 9.8.7" in one for one in release.faults(self.root, "9.9.0")))
        for file, pattern in release.PLACES:
            path = self.root / file
            text = path.read_text()
            path.write_text(text.replace("9.8.7", "9.8.6"))
            self.assertTrue(any(one.startswith(f"{file} is of 9.8.6") for one in release.faults(self.root, "9.8.7")), file)
            self.assertTrue(any("not committed" in one for one in release.faults(self.root, "9.8.7")))
            path.write_text(text)
        (self.root / "CHANGELOG.md").write_text(CHANGELOG)
        self.commit()
        self.assertIn("no entries", *release.faults(self.root, "9.8.7"))
        self.git("tag", "v9.8.7")
        self.assertTrue(any("there is a tag" in one for one in release.faults(self.root, "9.8.7")))

    def test_files_hashes_notes_and_a_tag(self):
        self.prepared()
        release.STEPS = (("a test", ["true"], ()), ("a file", ["sh", "-c", "mkdir -p build/x; echo new >build/x/a.deb"], ("build/x/*.deb",)))
        (self.root / "build/x").mkdir(parents=True)
        (self.root / "build/x/old.deb").write_text("old")
        release.release(self.root, "9.8.7")
        folder = self.root / "build/releases/9.8.7"
        self.assertEqual(sorted(file.name for file in folder.iterdir()), ["SHA256SUMS", "a.deb", "notes.md"])
        self.assertEqual((folder / "SHA256SUMS").read_text(), hashlib.sha256(b"new\n").hexdigest() + "  a.deb\n")
        self.assertEqual(self.git("tag", "-l", "--format=%(contents:body)%(contents:subject)", "v9.8.7").count("A mouth"), 1)

    def test_what_fails_is_not_tagged(self):
        self.prepared()
        for step, words in ((["false"], "failed"), (["true"], "no build/y"), (["sh", "-c", "mkdir -p build/y; touch build/y/a; echo >>version.h"], "changed the tree")):
            release.STEPS = (("a step", step, ("build/y/*",)),)
            with self.assertRaisesRegex(SystemExit, words):
                release.release(self.root, "9.8.7")
            self.assertEqual(self.git("tag"), "")


if __name__ == "__main__":
    unittest.main()
