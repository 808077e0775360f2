#!/usr/bin/env python3
"""The house's rules that a machine can check; docs/architecture.md says why they are.

    tools/check_rooms.py [ROOT]     names each breach as FILE:LINE: SENTENCE; exit 1 if there is one

1. Includes point left: a file includes its own room and those before it in ORDER.
2. Each heavy dependency has one home.
3. Public headers are those of cmake/public_headers.txt, included as <mien/NAME>, and include no others of the house. The
   house's own are included by their path, "lib/rig/eye/lid.h"; `x_private.h` from its own room only.
4. Every test, bench and fuzzer mirrors a source file; every header has a test. Those that have none yet are in
   tests/untested.txt, each with its reason; that list may only shrink.
5. The libraries print nothing, end no program and keep nothing for each thread; no file speaks of the machine it was written on.
6. Links between pages, and pages that code refers to, are there.
7. Every .cpp is compiled: a CMakeLists.txt names it, or by its stem, as in a foreach.
"""
import fnmatch
import pathlib
import posixpath
import re
import sys

# The rooms in the order a face goes through them. A file standing alone is a room of its own.
ORDER = """
    version.h
    lib/base  lib/math  lib/geom  lib/picture  lib/face  lib/rig  lib/file/json  lib/parts  lib/file
    sdf/shape  sdf/distance  sdf/csg  sdf/scene  sdf/outline  sdf/arrange  sdf  sdf/from_face  sdf/from_mesh  sdf/from_text
    render/image.h  render/render_stats.h  render/view  render/cover  render/blend  render/shade  render/reference  render/rows  render/effect  render  render/device  render/inspect  render/svg
    mien.h  write.h  render/image  bind/c  bind/web  tools
""".split()
FACES = ("lib/face", "lib/rig", "lib/file", "lib/parts")
MAKERS = ("sdf/from_face", "sdf/from_mesh", "sdf/from_text")
KNOWS_NO = {"sdf": FACES, "render": FACES + MAKERS}  # what a floor does not know, although it stands left of it
EXCEPT = MAKERS                                      # the rooms of sdf that know what they make scenes from

HOMES = {  # what is included -> where it may be, and how that is said
    r"nlohmann/": (r"lib/file/json/json_tree\.cpp$", "lib/file/json/json_tree.cpp"),
    r"(unsupported/)?Eigen/": (r"lib/math/.*\.cpp$", "a .cpp of lib/math"),
    r"hwy/contrib/": (r"(?!)", "no file: its mathematics fuse multiply-adds by themselves, outside the rule of sdf/distance/lanes/fma-inl.h"),
    r"hwy/": (r".*(-inl\.h|_simd\.cpp)$", "an -inl.h or _simd.cpp"),
    r"(oneapi/)?tbb/": (r"lib/base/parallel\.cpp$", "lib/base/parallel.cpp"),
    r"OpenImageIO/": (r"render/image/", "render/image"),
    r"(libdeflate|tiff(io)?)\.h": (r"render/image/", "render/image"),
    r"ft2build\.h|freetype/": (r"sdf/from_text/|tools/accuracy/methods/", "sdf/from_text; the laboratory judges its distance fields"),
    r"csv\.h": (r"tools/mien/data/", "tools/mien/data"),
    r"event2/": (r"tools/mien/http/", "tools/mien/http"),
    r"gif_lib\.h|webp/": (r"tools/mien/film/", "tools/mien/film"),
    r"nettle/": (r"tools/mien/output/", "tools/mien/output"),
    r"espeak-ng/": (r"tools/say/", "tools/say: its licence is the GPL, and mien-say alone is under it"),
    r"CLI/": (r"tools/mien/cli/|tools/accuracy/main\.cpp$", "tools/mien/cli"),
    r"tiny_obj_loader": (r"lib/file/", "lib/file"),
    r"boost/|mpfr": (r"tools/", "tools, tests or bench"),
    r"mien_(image_)?c\.h": (r"(bind|examples)/", "bind, tests and examples: the house behind it does not know it"),
}

FUSES = "sdf/distance/lanes/fma-inl.h"  # the one rule, for the same bits everywhere
LIBRARIES = ("lib/", "sdf/", "render/", "bind/")

MIRRORS = {"tests": "_test.cpp", "bench": "_bench.cpp", "fuzz": "_fuzz.cpp"}
NOT_MIRRORS = ("tests/support/", "fuzz/support/", "tests/golden/", "tests/exactness/", "tests/portable/", "tests/install/", "tests/embed/", "tests/bind/", "tests/house/", "tests/tools/",
               "bench/support/", "bench/whole/")

# Spelled so that this file does not contain what it looks for.
PATHS = r"(?<![\w.])/(?:hom[e]|roo[t]|wor[k])/\w"  # of one machine
PRINTS = r"\bstd::(cout|cerr|clog)\b|\bfmt::print\b|(?<![\w.>])(f?printf|f?put[sc]|putchar|perror|fwrite|vf?printf)\s*\(|\b(std::)?(abort|terminate|_?exit)\s*\("
FRANCHISES = r"(?i)wind.?wake[r]|zeld[a]\b|ninten[d]o|\bhal[o] ?4"
FRANCHISES_IN = ("docs/sources.md", "THIRD_PARTY.md")  # where sources are credited by their titles

TEXT = {".h", ".cpp", ".c", ".py", ".md", ".txt", ".json", ".cmake", ".in", ".sh", ".yml", ""}


def room_of(path):
    """The room a path belongs to: itself if it stands alone, else its folder or one above; None if in no room."""
    while path and path not in ORDER:
        path = path.rpartition("/")[0]
    return path or None


def code_of(line):
    """A line without its comments; one of a comment of C's stars is none."""
    return re.sub(r"//.*|^\s*/?\*( .*)?$", "", line)


class House:
    def __init__(self, root):
        self.root = root
        self.breaches = []
        self.public = {}  # NAME of <mien/NAME> -> where it is
        listed = root / "cmake/public_headers.txt"
        for line in listed.read_text().splitlines() if listed.is_file() else ():
            if line.strip() and not line.startswith("#"):
                _, public, path = line.split()
                self.public[public] = path
        self.files = sorted(p.relative_to(root).as_posix() for p in root.rglob("*") if p.is_file() and self.ours(p))

    def ours(self, path):
        parts = path.relative_to(self.root).parts
        return parts[0] not in ("build", "out") and not (parts[0].startswith(".git") and parts[0] != ".github")

    def lines(self, name):
        return (self.root / name).read_text(encoding="utf-8", errors="replace").splitlines()

    def breach(self, name, line, sentence):
        self.breaches.append(f"{name}:{line}: {sentence}")

    def check(self):
        for name in self.files:
            if re.match(r"(lib|sdf|render|bind|tools|tests|bench|fuzz|examples)/.*\.(h|c|cpp)$|[a-z]+\.h$", name):
                self.check_code(name)
            if pathlib.Path(name).suffix in TEXT:
                self.check_words(name)
                self.check_links(name)
        self.check_mirrors()
        self.check_compiled()
        for public, path in self.public.items():
            if path not in self.files:
                self.breach("cmake/public_headers.txt", 1, f"there is no {path} for <mien/{public}>")
        return self.breaches

    def check_code(self, name):
        for number, line in enumerate(self.lines(name), 1):
            if found := re.match(r'\s*#\s*include\s*(<[^>]+>|"[^"]+")', line):
                self.check_include(name, number, found[1][1:-1], quoted=found[1][0] == '"')
            if name.startswith(LIBRARIES) and name != FUSES and re.search(r"\bhn::(Neg)?Mul(Add|Sub)\b", code_of(line)):
                self.breach(name, number, f"multiply-adds go through {FUSES}: Fused, FusedFrom, FusedLess")
            if name.startswith(LIBRARIES) and re.search(PRINTS, code_of(line)):
                self.breach(name, number, "a library prints nothing and ends nothing")
            if name.startswith(LIBRARIES) and name != "lib/base/watch.h" and re.search(r"\bthread_local\b", code_of(line)):
                self.breach(name, number, "scratch belongs to an object of the thread's, which ends with the work")
            if re.search(r"\bkill\(", line) and name != "tests/support/process/end_process.h":
                self.breach(name, number, "kill(-1) ends every process there is: use tests/support/process/end_process.h")

    def check_include(self, name, number, include, quoted):
        in_mirror = name.split("/")[0] in MIRRORS
        for dependency, (home, said) in HOMES.items():
            if re.match(dependency, include) and not in_mirror and not re.match(home, name):
                self.breach(name, number, f"{include} belongs in {said}")
        private = include.endswith("_private.h") and "/" not in include
        if not quoted and include.startswith("mien/"):
            target = self.public.get(include.removeprefix("mien/"))
            if not target:
                self.breach(name, number, f"<{include}> is not in cmake/public_headers.txt")
                return
        elif quoted and "/" in include and not include.startswith("hwy/"):
            target = include
            if target in self.public.values():
                public = next(key for key, path in self.public.items() if path == target)
                self.breach(name, number, f"{target} is public: <mien/{public}>")
            if name in self.public.values():
                self.breach(name, number, f"a public header may not include {target}, which is not installed")
        elif quoted and not include.startswith("hwy/"):
            target = f"{name.rpartition('/')[0]}/{include}"
            if not private:
                self.breach(name, number, f'own includes are written by their path, not "{include}"')
        else:
            return
        if not (self.root / target).is_file():
            self.breach(name, number, f"there is no {target}")
        if target.split("/")[0] in MIRRORS:
            if not in_mirror:
                self.breach(name, number, f"{target} is for tests, benches and fuzzers")
            return
        if target.endswith("_private.h") and room_of(target) != room_of(name) and not in_mirror:
            self.breach(name, number, f"{target} is private to {room_of(target)}")
        if target.endswith("-inl.h") and not name.endswith(("_simd.cpp", "-inl.h")) and not in_mirror:
            self.breach(name, number, f"{target} is for _simd.cpp files")
        here, there = room_of(name), room_of(target)
        if here is None:
            if not in_mirror and not name.startswith("examples/"):
                folder = name.rpartition("/")[0]
                self.breach(name, number, f"{folder} is not a room; add it to ORDER in tools/check_rooms.py")
        elif there is None:
            self.breach(name, number, f"{target} is in no room")
        elif ORDER.index(there) > ORDER.index(here):
            self.breach(name, number, f"{here} may not include {there}: includes point left")
        elif here not in EXCEPT and there in KNOWS_NO.get(here.split("/")[0], ()):
            self.breach(name, number, f"{here} knows nothing of {there}")

    def check_words(self, name):
        for number, line in enumerate(self.lines(name), 1):
            if found := re.search(PATHS, line):
                self.breach(name, number, f"'{found[0]}' is a path of one machine")
        if name not in FRANCHISES_IN:
            for number, line in enumerate([name, *self.lines(name)]):
                if found := re.search(FRANCHISES, line):
                    self.breach(name, number, f"'{found[0]}' is somebody's trade mark")

    def check_links(self, name):
        if name.startswith("tests/house/"):  # plants breaches
            return
        for number, line in enumerate(self.lines(name), 1):
            links = {(self.root / page, page) for page in re.findall(r"\bdocs/[\w/-]+\.(?:md|json|png)\b", line)}
            if name.endswith(".md"):
                folder = (self.root / name).parent
                links |= {(folder / link, link) for link in re.findall(r"\]\(([\w./-]+)(?:#[\w-]*)?\)", line) if "." in link}
            for path, link in sorted(links):
                if not path.exists():
                    self.breach(name, number, f"there is no {link}")

    def check_mirrors(self):
        untested = {}
        if "tests/untested.txt" in self.files:
            for number, line in enumerate(self.lines("tests/untested.txt"), 1):
                if line.strip() and not line.startswith("#"):
                    header, _, reason = line.partition("  ")
                    untested[header] = number
                    if not reason.strip():
                        self.breach("tests/untested.txt", number, "each header needs a reason, after two spaces")
        for name in self.files:
            top = name.split("/")[0]
            if top in MIRRORS and name.endswith((".cpp", ".h")) and not name.startswith(NOT_MIRRORS):
                stem = name.removeprefix(top + "/").removesuffix(MIRRORS[top])
                if not any(f"{stem}{end}" in self.files for end in (".h", "_private.h", "-inl.h", ".cpp")):
                    self.breach(name, 1, f"mirrors no source file {stem}.h or .cpp")
            if top in ("lib", "sdf", "render") and name.endswith(".h") and not name.endswith("-inl.h"):
                test = f"tests/{name.removesuffix('.h').removesuffix('_private')}_test.cpp"
                tested = test in self.files or name.endswith("_private.h")
                if not tested and name not in untested:
                    self.breach(name, 1, f"has no test {test}")
                if tested and name in untested:
                    self.breach("tests/untested.txt", untested[name], f"{name} has a test now: take it out")
        for header in untested.keys() - set(self.files):
            self.breach("tests/untested.txt", untested[header], f"there is no {header}: take it out")

    def check_compiled(self):
        named, words = set(), set()
        for name in self.files:
            if name.endswith(("CMakeLists.txt", ".cmake")):
                folder = (self.root / name).parent.as_posix()
                text = re.sub(r"#.*", "", "\n".join(self.lines(name)))
                for word in re.findall(r"[^\s()\"]+", text.replace("${PROJECT_SOURCE_DIR}", self.root.as_posix())):
                    word = word.replace("${CMAKE_CURRENT_SOURCE_DIR}", folder)
                    words.add(word)
                    named.add(posixpath.normpath(posixpath.join(folder, word)))
        patterns = [word for word in named if "*" in word]
        for name in (name for name in self.files if name.endswith(".cpp")):
            path = (self.root / name).as_posix()
            parts = re.sub(r"(_bench|_fuzz)?\.cpp$", "", name).split("/")
            by_stem = name.startswith(("bench/", "fuzz/")) and any("/".join(parts[i:]) in words for i in range(1, len(parts)))
            if path not in named and path.removesuffix(".cpp") not in named and not by_stem and not any(fnmatch.fnmatch(path, pattern) for pattern in patterns):
                self.breach(name, 1, "no CMakeLists.txt names it: nothing compiles it")


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
    breaches = House(root).check()
    print("\n".join(breaches) if breaches else "the rooms are in order")
    return bool(breaches)


if __name__ == "__main__":
    sys.exit(main())
