"""What of mien is no Python: libraries, the command, and what they stand on, beside each other in mien/native.

They come out of a build of mien: the one that MIEN_BUILD names, or one that is made here, of the sources in source/, as a source
distribution has them. What every Linux has of the age that the wheel's tag names (PEP 600) is left out; the rest goes in, with its licences.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig

HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = ("libmien_c.so.0", "libmien_image_c.so.0")
MODULES = ("mien-films-*.so", "mien-tiff-*.so", "mien-exr-jpeg-*.so")
ALONE = ("mien-tiff-", "mien-exr-jpeg-")  # their two hundred libraries are the system's, where it has them
TARGETS = ("mien_c", "mien_image_c", "mien_command", "mien_film_module", "mien_tiff_module", "mien_oiio_module",
           "mien-accuracy")
# What every system of that age has (PEP 600; the rest of its list is of windows and sound).
EVERYWHERE = re.compile(r"(ld-linux.*|linux-vdso|libc|libm|libdl|libpthread|librt|libutil|libstdc\+\+|libgcc_s)\.so.*")
# The first version of the C library that came with a compiler whose C++ library has such symbols.
GLIBC_OF_GLIBCXX = ((28, 31), (29, 34), (30, 35), (31, 38), (32, 38), (33, 39))


def run(*command, **how):
    done = subprocess.run([str(one) for one in command], capture_output=True, text=True, **how)
    if done.returncode:
        sys.exit(f"wheel: {command[0]}: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def built():
    """A build's folder."""
    if os.environ.get("MIEN_BUILD"):
        return pathlib.Path(os.environ["MIEN_BUILD"])
    if not (HERE / "source/CMakeLists.txt").is_file():
        sys.exit("wheel: MIEN_BUILD names no build of mien, and source/ is not here: tools/wheel makes wheels and source distributions")
    return build(HERE / "source", HERE / "build-mien")


def build(source, into):
    """Builds what a wheel holds. Its command has no server for the studio: libevent would ask for a newer C library than all else."""
    run("cmake", "-S", source, "-B", into, "-G", "Ninja", "-Wno-dev", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
        "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", "-DMIEN_BUILD_TESTS=OFF", "-DMIEN_BUILD_SERVER=OFF",
        "-DMIEN_BUILD_ACCURACY=ON", *os.environ.get("MIEN_CMAKE", "").split())
    run("cmake", "--build", into, "--target", *TARGETS, "--parallel", os.environ.get("MIEN_JOBS", str(os.cpu_count() or 1)))
    return into


def find_beside(file):
    """Of the places where a built file looks for libraries, only its own folder stays: others are of this machine, and CMake fills the rest
    with colons, which stand for the folder that a program happens to run in."""
    raw = file.read_bytes()
    short = re.sub(rb"\$ORIGIN:[^\0]*\0", lambda found: b"$ORIGIN".ljust(len(found[0]), b"\0"), raw)
    file.write_bytes(short)
    places = re.findall(r"R(?:UN)?PATH.*\[(.*)\]", run("readelf", "-d", "-W", file))
    if places not in ([], ["$ORIGIN"]):
        sys.exit(f"wheel: {file.name} looks for libraries in {', '.join(places)}, and should in its own folder alone")


def stands_on(file):
    """The system's libraries that a file needs, and those need, by name."""
    told = run("ldd", file)
    if missing := re.findall(r"(\S+) => not found", told):
        sys.exit(f"wheel: {file} needs {', '.join(missing)}, which is not here")
    found = dict(re.findall(r"(\S+) => (/\S+)", told))
    return {name: pathlib.Path(path) for name, path in found.items() if not EVERYWHERE.fullmatch(name) and "mien" not in name}


def licences(libraries, folder):
    """The licences of libraries of the system's go where they go."""
    folder.mkdir()
    # Files of a merged /usr have the names that they had before.
    asked = {str(name) for path in libraries for one in (path, path.resolve()) for name in (one, str(one).removeprefix("/usr"))}
    told = subprocess.run(["dpkg", "-S", *sorted(asked)], capture_output=True, text=True).stdout if shutil.which("dpkg") else ""
    package_of = {path: package for package, path in re.findall(r"^([^:\s]+)\S*: (/\S+)$", told, flags=re.M)}
    for path in libraries:
        names = [str(name) for one in (path, path.resolve()) for name in (one, str(one).removeprefix("/usr"))]
        package = next((package_of[name] for name in names if name in package_of), "")
        text = pathlib.Path("/usr/share/doc", package, "copyright")
        if not package or not text.is_file():
            sys.exit(f"wheel: the licence of {path} is not found, and nobody may be given the library without it")
        shutil.copy(text, folder / f"{package}.txt")


def gather(into, folder):
    """Puts everything of a build into a folder; the files by which a system is judged."""
    into.mkdir(parents=True)
    libraries = [folder / name for name in LIBRARIES]
    if not libraries[0].is_file():
        sys.exit(f"wheel: {folder} has no {LIBRARIES[0]}: it is built with -DMIEN_BUILD_C=ON")
    programs = [path for path in (folder / "mien", folder / "tools/accuracy/mien-accuracy") if path.is_file()]
    modules = [path for pattern in MODULES for path in folder.glob(pattern)]
    own = [path for path in (*libraries, *programs, *modules) if path.is_file()]
    for path in own:
        shutil.copy(path, into / path.name)
        run("strip", "--strip-unneeded", into / path.name)
        find_beside(into / path.name)
    judged = [into / path.name for path in own if not path.name.startswith(ALONE)]
    libraries = {name: path for file in own if not file.name.startswith(ALONE) for name, path in stands_on(file).items()}
    for name, path in libraries.items():
        judged.append(into / name)
        shutil.copy(path, judged[-1])
    licences(list(libraries.values()), into / "licences")
    return judged


def tag(files):
    """The wheel's platform: how old a Linux may be, by the symbols that the files need."""
    glibc = 17
    for file in files:
        told = run("readelf", "-V", "-W", file)
        glibc = max([glibc, *(int(minor) for minor in re.findall(r"\bGLIBC_2\.(\d+)", told))])
        newest = max([0, *(int(minor) for minor in re.findall(r"\bGLIBCXX_3\.4\.(\d+)", told))])
        glibc = max([glibc, *(age for symbols, age in GLIBC_OF_GLIBCXX if symbols <= newest)])
    machine = sysconfig.get_platform().partition("-")[2].replace("-", "_").replace(".", "_")
    return f"manylinux_2_{glibc}_{machine}"
