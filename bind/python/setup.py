"""The version, which stands in version.h; mien's libraries and command, by native.py; and the wheel's tag, which tells what they need."""
import pathlib
import re
import shutil
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import native  # noqa: E402

PLACES = (HERE, HERE / "source", HERE.parents[1])
HEADER = next(place / "version.h" for place in PLACES if (place / "version.h").is_file())
VERSION = ".".join(re.findall(r"#define MIEN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", HEADER.read_text(encoding="utf-8")))
TAG = []


class WithNative(build_py):
    """The package, and beside it what is no Python."""

    def run(self):
        super().run()
        package = pathlib.Path(self.build_lib, "mien")
        shutil.rmtree(package / "native", ignore_errors=True)
        judged = native.gather(package / "native", native.built())
        TAG[:] = [native.tag(judged)]
        root = HEADER.parent
        for name in ("LICENSE", "THIRD_PARTY.md"):
            shutil.copy(root / name, package / name)
        share = package / "share/mien"  # where the command looks for sample faces, too
        shutil.copytree(root / "faces", share / "faces", ignore=shutil.ignore_patterns("compat"), dirs_exist_ok=True)
        if (root / "web").is_dir():
            shutil.copytree(root / "web", share / "web", dirs_exist_ok=True)


class Wheel(bdist_wheel):
    """No code of Python's own is compiled: one wheel serves every Python of a system."""

    def get_tag(self):
        return ("py3", "none", TAG[0] if TAG else "any")


class OfAPlatform(Distribution):
    """What is in it runs on one kind of machine."""

    def has_ext_modules(self):
        return True


setup(version=VERSION, distclass=OfAPlatform, cmdclass={"build_py": WithNative, "bdist_wheel": Wheel})
