#!/usr/bin/env python3
"""The annotations of the Python package hold: types_test.py PACKAGE CACHE    exit 77 where there is no mypy"""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile

package, cache = sys.argv[1:]
if not importlib.util.find_spec("mypy") or not importlib.util.find_spec("numpy"):
    print("needs python3-mypy and python3-numpy: tools/setup --dev")
    sys.exit(77)


def mypy(*arguments):
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", cache, *arguments], capture_output=True, text=True)


checked = mypy(package)
print(checked.stdout, checked.stderr)
# And they can fail: a user who gives what is none is told.
with tempfile.TemporaryDirectory() as folder:
    user = pathlib.Path(folder, "user.py")
    user.write_text("import mien\nwidth: str = mien.read_face('a').pose(time='noon').render(64).shape[0]\n")
    told = mypy(str(user)).stdout
    print(told)
    sees = '"time"' in told and '"str"' in told
sys.exit(checked.returncode or not sees)
