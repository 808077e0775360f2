#!/usr/bin/env python3
"""What .ci/run promises: each step runs, whatever became of those before it; those that failed are named at the end, and fail it.

    ci_test.py
"""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

RUN = pathlib.Path(__file__).resolve().parents[2] / ".ci/run"
STEPS = ["tools/test", "tools/portable web --short", "tools/portable arm64 --short"]


class Ci(unittest.TestCase):
    def ran(self, failing):
        """The exit code, the steps that ran, and the last lines of standard error, where those in `failing` fail."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / ".ci").mkdir(), (root / "tools").mkdir()
            shutil.copy(RUN, root / ".ci/run")
            for name in ("test", "portable"):
                tool = root / "tools" / name
                cases = "".join(f'  "{step}") echo noise >&2; exit 3 ;;\n' for step in failing)
                tool.write_text(f'#!/bin/sh\nstep="tools/{name}${{1:+ $*}}"\necho "$step"\ncase "$step" in\n{cases}  *) exit 0 ;;\nesac\n')
                tool.chmod(0o755)
            ran = subprocess.run([root / ".ci/run"], capture_output=True, text=True)
            return ran.returncode, ran.stdout.splitlines(), ran.stderr.splitlines()

    def test_all_steps_pass(self):
        self.assertEqual(self.ran([]), (0, STEPS, []))

    def test_each_failure_is_told_and_fails_the_run(self):
        for failing in ([STEPS[0]], [STEPS[1]], [STEPS[2]], STEPS):
            code, steps, said = self.ran(failing)
            self.assertEqual(steps, STEPS, failing)
            self.assertEqual(said[-len(failing):], [f"ci: failed: {step}" for step in failing])
            self.assertNotEqual(code, 0)


if __name__ == "__main__":
    unittest.main()
