#!/usr/bin/env python3
"""docs/python.ipynb is the page of Python, cell by cell, with what its cells give: notebook_test.py SOURCE

Exit 77 where it cannot be run for want of Jupyter's nbconvert."""
import base64
import importlib.util
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

source = pathlib.Path(sys.argv[1])


def made(*words):
    """The notebook that tools/notebook makes."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "made.ipynb")
        subprocess.run([sys.executable, source / "tools/notebook", *words, file], check=True)
        return json.loads(file.read_text(encoding="utf-8"))["cells"]


def said(cell):
    return {key: cell[key] for key in ("cell_type", "id", "source")}


def kinds(cell):
    """Of what kinds its outputs are: texts and pictures may differ a little between machines."""
    return [sorted(output.get("data", {output["output_type"]: 0})) for output in cell.get("outputs", ())]


kept = json.loads((source / "docs/python.ipynb").read_text(encoding="utf-8"))["cells"]
if list(map(said, kept)) != list(map(said, made("--bare"))):
    sys.exit("docs/python.ipynb is not what tools/notebook makes of docs/python.md: run it")
pictures = [base64.b64decode(output["data"]["image/png"]) for cell in kept for output in cell.get("outputs", ()) if "image/png" in output.get("data", {})]
assert len(pictures) >= 5, f"{len(pictures)} cells show a face"
assert all(min(struct.unpack(">II", one[16:24])) >= 64 for one in pictures)
assert not any(output["output_type"] in ("error", "stream") and output.get("name") != "stdout" for cell in kept for output in cell.get("outputs", ()))
assert all(word not in json.dumps(kept) for word in ("/tmp/", "/home/")), "the notebook tells of the machine it was made on"
if not all(importlib.util.find_spec(name) for name in ("nbconvert", "ipykernel", "numpy", "PIL")):
    print("needs jupyter-nbconvert, python3-ipykernel, python3-numpy and python3-pil: tools/setup --dev")
    sys.exit(77)
for cell, again in zip(kept, made(), strict=True):
    assert kinds(cell) == kinds(again), f"{cell['id']} gives {kinds(again)}, and the notebook keeps {kinds(cell)}: run tools/notebook"
