#!/usr/bin/env python3
"""tools/check_lengths.py measures functions and files as they are, and names what is too long."""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parents[2] / "tools/check_lengths.py"


def function(lines, name="draw"):
    return f"int {name}(int x) {{\n" + "  ++x;\n" * (lines - 2) + "}\n"


# What of C++ is one function, of how many lines.
KINDS = [
    ("void f() {}\n", 1),
    ("template <class T = int>\nvoid f(T t = {},\n       int n = 3) {\n  if (n) {\n    t();\n  }\n}\n", 7),
    ("struct A : B {\n  A() : B{1}, b_{2} {\n    go([&](int i) { return i; });\n  }\n  int b_ = 0;\n};\n", 3),
    ("struct A {\n  bool operator==(const A&) const = default;\n  auto end() const -> int {\n    return 1;\n  }\n};\n", 3),
    ("namespace mien {\n/// A comment {\nHWY_INLINE int f(const char* s) noexcept {\n  return s == \"}\";\n}\n}\n", 3),
    ("const int kTable[] = {1, 2};\nconst Box2 kBox{{0, 0}, {1, 1}};\nenum class Side { left };\nint f() {\n  struct L {\n    int g() { return 1; }\n  };\n  return 2;\n}\n", 6),
]
# A file's text, and what is said of it.
FAULTS = [
    ("lib/a.cpp", function(10), "half of all functions have at most 10 lines"),
    ("lib/a.cpp", "".join(function(3, f"f{i}") for i in range(8)) + function(26) * 2, "nine of ten functions have at most 26"),
    ("lib/a.cpp", function(9), None),
    ("tests/a_test.cpp", "\n" * 401, "tests/a_test.cpp:1: has 401 lines and does not say why"),
    ("tests/a_test.cpp", "// Longer than other files: a table.\n" + "\n" * 401, None),
    ("tests/a_test.cpp", function(60), None),
]


def check(name, text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, name)
        path.parent.mkdir()
        path.write_text(text)
        run = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def main():
    failed = 0
    for text, lines in KINDS:
        _, said = check("lib/a.cpp", text)
        if f"1 functions: median {lines} lines" not in said:
            print(f"{text}\nexpected one function of {lines} lines, said: {said}")
            failed += 1
    for name, text, sentence in FAULTS:
        code, said = check(name, text)
        if code != (sentence is not None) or (sentence or "") not in said:
            print(f"{name}: {text[:60]!r}\nexpected: {sentence}\nsaid: {said}")
            failed += 1
    print(f"{len(KINDS) + len(FAULTS) - failed} of {len(KINDS) + len(FAULTS)} as expected")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
