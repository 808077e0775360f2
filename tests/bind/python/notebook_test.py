#!/usr/bin/env python3
"""docs/python.ipynb is the page of Python, cell by cell, and runs: notebook_test.py SOURCE

Exit 77 where it cannot be run for want of Jupyter's nbconvert."""
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile

source = pathlib.Path(sys.argv[1])
book = source / "docs/python.ipynb"
with tempfile.TemporaryDirectory() as folder:
    made = pathlib.Path(folder, "made.ipynb")
    subprocess.run([sys.executable, source / "tools/notebook", made], check=True)
    if made.read_bytes() != book.read_bytes():
        sys.exit("docs/python.ipynb is not what tools/notebook makes of docs/python.md: run it")
    if not all(importlib.util.find_spec(name) for name in ("nbconvert", "ipykernel", "numpy")):
        print("needs jupyter-nbconvert, python3-ipykernel and python3-numpy: tools/setup --dev")
        sys.exit(77)

    # Where it is run are the faces and the examples; what it writes stays there.
    for shown in ("faces", "examples"):
        os.symlink(source / shown, pathlib.Path(folder, shown))
    home = {**os.environ, "HOME": folder, "JUPYTER_DATA_DIR": folder, "IPYTHONDIR": folder}

    def run(notebook):
        return subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output", "run.ipynb", notebook],
                              cwd=folder, env=home, capture_output=True, text=True)

    ran = run(made)
    if ran.returncode:
        sys.exit(ran.stderr)
    cells = [cell for cell in json.loads(pathlib.Path(folder, "run.ipynb").read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
    assert cells and all(cell["execution_count"] for cell in cells), "not every cell was run"
    assert any("image/png" in output.get("data", {}) for cell in cells for output in cell["outputs"]), "no face shows itself"

    # And it can fail.
    broken = json.loads(made.read_text(encoding="utf-8"))
    broken["cells"][-2]["source"] = ["mien.no_such_thing"]
    broken["cells"][-2] = {**cells[0], "source": ["mien.no_such_thing"], "outputs": []}
    made.write_text(json.dumps(broken), encoding="utf-8")
    assert run(made).returncode, "a broken cell is not seen"
