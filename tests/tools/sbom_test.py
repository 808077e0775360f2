"""tools/sbom, of the command alone: sbom_test.py MIEN SOURCE"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, MIEN = pathlib.Path(sys.argv.pop()), pathlib.Path(sys.argv.pop())


def sbom(folder):
    return subprocess.run([SOURCE / "tools/sbom", folder], capture_output=True, text=True, env=os.environ | {"SOURCE_DATE_EPOCH": "86400"})


@unittest.skipUnless(shutil.which("dpkg-query"), "needs a Debian")
class Bill(unittest.TestCase):
    def test_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(MIEN, folder)
            (pathlib.Path(folder) / "note.txt").write_text("no part of it")
            done = sbom(folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(sbom(folder).stdout, done.stdout)
        told = json.loads(done.stdout)
        self.assertEqual((told["spdxVersion"], told["creationInfo"]["created"]), ("SPDX-2.3", "1970-01-02T00:00:00Z"))
        self.assertEqual([file["fileName"] for file in told["files"]], ["./mien"])
        sums = {one["algorithm"]: one["checksumValue"] for one in told["files"][0]["checksums"]}
        self.assertEqual(sums["SHA256"], hashlib.sha256(MIEN.read_bytes()).hexdigest())
        packages = {package["name"]: package for package in told["packages"]}
        for name in ("mien", "libfmt9", "libc6", "libglm-dev", "nlohmann-json3-dev"):
            self.assertIn(name, packages)
            self.assertTrue(packages[name]["versionInfo"], name)
        known = {"SPDXRef-DOCUMENT", *(one["SPDXID"] for one in told["packages"] + told["files"])}
        self.assertEqual(len(known), 1 + len(told["packages"]) + len(told["files"]))
        for relation in told["relationships"]:
            self.assertLessEqual({relation["spdxElementId"], relation["relatedSpdxElement"]}, known)
        of = lambda name: {one["relationshipType"] for one in told["relationships"] if one["relatedSpdxElement"] == packages[name]["SPDXID"]}
        self.assertEqual((of("libfmt9"), of("libglm-dev"), of("mien")), ({"DYNAMIC_LINK"}, {"STATIC_LINK"}, {"DESCRIBES"}))

    def test_of_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            done = sbom(folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no built files", done.stderr)


if __name__ == "__main__":
    unittest.main()
