#!/usr/bin/env python3
"""tools/check_names.py finds a name that two files define, and nothing where each has its own."""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parents[2] / "tools/check_names.py"
# What a second file holds beside lib/a.h, and whether that is a breach.
FIRST = "namespace mien {\nstruct Side { int x; };\ninline constexpr int kSides = 2;\nclass Poser {\n  struct Scratch;\n};\ninline double larger(double a, double b) {\n  return a > b ? a : b;\n}\n}\n"
SECOND = [
    ("namespace mien {\nenum class Side { left };\n}\n", "lib/b.cpp:2: mien::Side is defined at lib/a.h:2 too"),
    ("namespace mien {\ninline constexpr int kSides{3};\n}\n", "mien::kSides is defined"),
    ("namespace mien { namespace {\nstruct Side {};\n} }\n", None),
    ("namespace mien::command {\nstruct Side {};\n}\n", None),
    ("namespace mien {\nstruct Side;\nvoid draw(struct Side* side);\n}\n", None),
    ("namespace mien {\n// struct Side {\nconst char* kText = \"struct Side {\";\n}\n", None),
    ("namespace mien {\nvoid draw() {\n  struct Side {};\n}\nstruct Poser::Scratch {};\n}\n", None),
    ("namespace mien {\nvoid draw() {\n  struct Mine {};\n}\nstruct Side final : Base<int> {};\n}\n", "mien::Side is defined"),
    ("namespace mien {\ninline double larger(double x, double y = 0) {\n  return 0;\n}\n}\n", "mien::larger(double, double) is defined"),
    ("namespace mien {\ninline double larger(int x, double y) {\n  return 0;\n}\n}\n", None),
]


def main():
    failed = 0
    for text, sentence in SECOND:
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "lib").mkdir()
            pathlib.Path(folder, "lib/a.h").write_text(FIRST)
            pathlib.Path(folder, "lib/b.cpp").write_text(text)
            run = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
        said = run.stdout + run.stderr
        if run.returncode != (sentence is not None) or (sentence or "each defined once") not in said:
            print(f"in a second file: {text!r}\nexpected: {sentence}\nsaid: {said}")
            failed += 1
    print(f"{len(SECOND) - failed} of {len(SECOND)} as expected")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
