"""Builds the Python module with CMake: pip install . --no-build-isolation."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent
# An existing build of the libraries, such as build/release, saves minutes.
BUILD = Path(os.environ.get("PENDULAR_BUILD", ROOT / "build" / "python"))


class BuildWithCMake(build_ext):
    """Configures, builds and installs the component python of CMakeLists.txt."""

    def build_extension(self, ext: Extension) -> None:
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        if "PENDULAR_BUILD" not in os.environ:
            subprocess.run(
                ["cmake", "-S", ROOT, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release",
                 "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=24", "-DPENDULAR_BUILD_TESTS=OFF",
                 "-DPENDULAR_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"],
                check=True,
            )
        subprocess.run(["cmake", "--build", BUILD, "--target", "pendular_package",
                        f"-j{os.cpu_count()}"], check=True)
        # The folder of packages of a build is relative to its prefix: a prefix of its own, whose
        # only package is moved to where pip wants it.
        prefix = Path(self.build_temp).resolve() / "prefix"
        subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", prefix],
                       check=True)
        installed = next(prefix.rglob("pendular/__init__.py")).parent
        self.copy_tree(str(installed), str(package))


class WithExtension(Distribution):
    """Package whose files all come from CMake."""

    def has_ext_modules(self) -> bool:
        return True


setup(
    version=re.search(r"VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text().split("project(")[1])[1],
    packages=[],
    ext_modules=[Extension("pendular._core", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
    distclass=WithExtension,
)
