#!/usr/bin/env python3
"""tools/check_rooms.py finds each kind of breach in a small house it is planted in, and nothing in a sound one."""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parents[2] / "tools/check_rooms.py"
SOUND = {
    "cmake/public_headers.txt": "# LIBRARY NAME PATH\nmien mien.h mien.h\nmien api.h lib/base/api.h\nmien render.h render/render.h\n",
    "mien.h": "#include <mien/render.h>\n",
    "lib/base/api.h": "#pragma once\n",
    "lib/geom/box.h": "#include <mien/api.h>\n",
    "lib/face/face.h": '#include "lib/geom/box.h"\n',
    "lib/face/a/b_private.h": "\n",
    "lib/face/c.cpp": '#include "lib/face/a/b_private.h"\n',
    "sdf/shape/shape.h": '#include "lib/geom/box.h"\n',
    "sdf/from_face/maker.h": '#include "lib/face/face.h"\n#include "sdf/shape/shape.h"\n',
    "render/render.h": "#include <mien/api.h>\n",
    "render/draw.cpp": '#include "sdf/shape/shape.h"\n#include <mien/render.h>\n',
    "bind/c/mien_c.h": "\n",
    "bind/c/face.cpp": '#include "bind/c/mien_c.h"\n#include <mien/render.h>\n#include "lib/face/face.h"\n',
    "bind/c/image/write.cpp": '#include <mien_c.h>\n#include "bind/c/mien_c.h"\n',
    "tests/bind/c/scenes.c": "#include <mien_c.h>\n",
    "tests/untested.txt": "".join(f"{header}  planted\n" for header in (
        "lib/base/api.h", "lib/face/face.h", "sdf/shape/shape.h", "sdf/from_face/maker.h", "render/render.h")),
    "tests/lib/geom/box_test.cpp": '#include "lib/geom/box.h"\n#include "tests/support/ascii.h"\n',
    "tests/support/ascii.h": "\n",
}
# What is planted where, and a piece of the sentence that must name it.
PLANTED = [
    ("lib/geom/box.cpp", "#include \"sdf/shape/shape.h\"\n", "lib/geom/box.cpp:1: lib/geom may not include sdf/shape"),
    ("lib/base/a.cpp", "\n#include \"lib/geom/box.h\"\n", "lib/base/a.cpp:2: lib/base may not include lib/geom"),
    ("sdf/shape/a.cpp", "#include \"lib/face/face.h\"\n", "sdf/shape knows nothing of lib/face"),
    ("render/a.cpp", "#include \"lib/face/face.h\"\n", "render knows nothing of lib/face"),
    ("render/a.cpp", "#include \"sdf/from_face/maker.h\"\n", "render knows nothing of sdf/from_face"),
    ("render/a.cpp", "#include <mien/mien.h>\n", "render may not include mien.h"),
    ("render/a.cpp", "#include \"lib/geom/none.h\"\n", "there is no lib/geom/none.h"),
    ("render/a.cpp", '#include "render.h"\n', "own includes are written by their path"),
    ("render/a.cpp", '#include "render/render.h"\n', "render/render.h is public: <mien/render.h>"),
    ("render/a.cpp", "#include <mien/shape.h>\n", "<mien/shape.h> is not in cmake/public_headers.txt"),
    ("render/render.h", '#include "sdf/shape/shape.h"\n', "a public header may not include sdf/shape/shape.h"),
    ("lib/rig/a.cpp", '#include "lib/face/a/b_private.h"\n', "is private to lib/face"),
    ("lib/geom/a.cpp", '#include "tests/support/ascii.h"\n', "is for tests, benches and fuzzers"),
    ("cmake/public_headers.txt", "mien gone.h lib/gone.h\nmien api.h lib/base/api.h\nmien render.h render/render.h\n", "there is no lib/gone.h"),
    ("lib/face/a.cpp", "#include <nlohmann/json.hpp>\n", "belongs in lib/file/json/json_tree.cpp"),
    ("lib/math/a_private.h", "#include <Eigen/Core>\n", "belongs in a .cpp of lib/math"),
    ("sdf/shape/a.cpp", "#include <hwy/highway.h>\n", "belongs in an -inl.h or _simd.cpp"),
    ("sdf/shape/a-inl.h", "#include <hwy/contrib/math/math-inl.h>\n", "belongs in no file: its mathematics fuse multiply-adds"),
    ("sdf/shape/a-inl.h", "  return hn::MulAdd(x, y, z);\n", "multiply-adds go through sdf/distance/lanes/fma-inl.h"),
    ("sdf/shape/a-inl.h", "  return hn::NegMulAdd(x, y, z);\n", "Fused, FusedFrom, FusedLess"),
    ("sdf/shape/a-inl.h", "  return hn::Mul(x, y);  // hn::MulAdd would fuse\n", None),
    ("sdf/distance/lanes/fma-inl.h", "  return hn::MulAdd(x, y, z);\n", None),
    ("render/a.cpp", "#include <oneapi/tbb/parallel_for.h>\n", "belongs in lib/base/parallel.cpp"),
    ("render/a.cpp", "#include <OpenImageIO/imageio.h>\n", "belongs in render/image"),
    ("render/a.cpp", "#include <CLI/CLI.hpp>\n", "belongs in tools/mien/cli"),
    ("render/a.cpp", "  std::cout << 1;\n", "a library prints nothing"),
    ("sdf/shape/a.cpp", "  std::abort();\n", "and ends nothing"),
    ("sdf/shape/a.cpp", "  std::fprintf(stderr, text);\n", "a library prints nothing"),
    ("sdf/shape/a.cpp", "  fputs(text, stderr);\n", "a library prints nothing"),
    ("lib/geom/a.cpp", "  std::snprintf(text, 9, form);\n", None),
    ("render/a.cpp", "  thread_local std::vector<double> scratch;\n", "scratch belongs to an object of the thread's"),
    ("render/a.cpp", "int a = 1;  // not thread_local\n", None),
    ("tests/lib/geom/box_test.cpp", "  ::kill(child, SIGTERM);\n", "kill(-1) ends every process"),
    ("render/a.cpp", '#include "bind/c/mien_c.h"\n', "render may not include bind/c"),
    ("lib/geom/a.cpp", "#include <mien_c.h>\n", "belongs in bind"),
    ("tools/mien/a.cpp", "#include <mien_image_c.h>\n", "belongs in bind"),
    ("bind/c/a.cpp", '#include "tools/mien/a.h"\n', "bind/c may not include tools"),
    ("bind/c/a.h", "/* so:\n *\n *   printf(text);\n */\n", None),
    ("bind/c/a.cpp", "#include <nlohmann/json.hpp>\n", "belongs in lib/file/json/json_tree.cpp"),
    ("bind/c/a.cpp", '  std::printf("here");\n', "a library prints nothing"),
    ("examples/a.c", "#include <mien_c.h>\n", None),
    ("lib/attic/a.cpp", "\n", None),
    ("lib/attic/a.cpp", "#include <mien/api.h>\n", "lib/attic is not a room"),
    ("sdf/shape/new.h", "\n", "has no test tests/sdf/shape/new_test.cpp"),
    ("tests/sdf/gone_test.cpp", "\n", "mirrors no source file sdf/gone.h or .cpp"),
    ("bench/sdf/gone_bench.cpp", "\n", "mirrors no source file sdf/gone.h or .cpp"),
    ("tests/render/render_test.cpp", "\n", "render/render.h has a test now"),
    ("tests/untested.txt", "lib/base/gone.h  was here\n", "there is no lib/base/gone.h"),
    ("tests/untested.txt", "lib/base/api.h\n", "needs a reason"),
    ("README.md", "see /wor" + "k/main\n", "a path of one machine"),
    ("lib/geom/a.cpp", "// Proof: docs/non" + "e.md.\n", "lib/geom/a.cpp:1: there is no docs/none.md"),
    ("docs/a.md", "\n[b](no" + "ne.md#part)\n", "docs/a.md:2: there is no none.md"),
    ("CMakeLists.txt", "add_library(all lib/face/c.cpp bind/c/face.cpp ${PROJECT_SOURCE_DIR}/bind/c/image/write.cpp)  # render/draw.cpp\n",
     "render/draw.cpp:1: no CMakeLists.txt names it"),
    ("CMakeLists.txt", "add_library(all lib/face/c.cpp bind/c/face.cpp bind/c/image/*.cpp ./render/draw.cpp)\n",
     "tests/lib/geom/box_test.cpp:1: no CMakeLists.txt names it"),
    ("faces/zel" + "da.json", "{}\n", "trade mark"),
]


def breaches(files):
    files = {"CMakeLists.txt": "\n".join(name for name in files if name.endswith(".cpp")), **files}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        run = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
        return run.returncode, run.stdout + run.stderr


def main():
    failed = 0
    for name, text, sentence in [("lib/base/none.cpp", "\n", None), *PLANTED]:
        code, said = breaches({**SOUND, name: text})
        if code != (sentence is not None) or (sentence or "in order") not in said:
            print(f"planted in {name}: {text!r}\nexpected: {sentence}\nsaid: {said}")
            failed += 1
    print(f"{len(PLANTED) + 1 - failed} of {len(PLANTED) + 1} as expected")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
