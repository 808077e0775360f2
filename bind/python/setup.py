"""The version, which stands in version.h, and the wheel's tag: for one system if libraries lie in the package, else for all."""
import pathlib
import re
import sysconfig

from setuptools import setup
from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
HEADER = next(path for path in (HERE / "version.h", HERE.parents[1] / "version.h") if path.is_file())
VERSION = ".".join(re.findall(r"#define MIEN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", HEADER.read_text(encoding="utf-8")))


class Wheel(bdist_wheel):
    """No code of Python's own is compiled: one wheel serves every Python of a system."""

    def get_tag(self):
        platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
        return ("py3", "none", platform if list((HERE / "mien").glob("*.so*")) else "any")


setup(version=VERSION, cmdclass={"bdist_wheel": Wheel})
