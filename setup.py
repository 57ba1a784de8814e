"""The build step of `pip install .`: CMake compiles the C++ side of the package and gathers the shipped files."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"project\(bitrock VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildWithCMake(build_ext):
    """Compiles only what the module needs; CMake's own variables (CMAKE_CXX_COMPILER_LAUNCHER, ...) count as usual."""

    def run(self):
        build = Path(self.build_temp).resolve()
        staged = build / "staged"
        subprocess.check_call([
            "cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
            "-DBITROCK_TESTS=OFF", "-DBITROCK_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}",
        ])  # fmt: skip
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.check_call(["cmake", "--build", build, "--target", "bitrock_python", "-j", jobs])
        shutil.rmtree(staged, ignore_errors=True)
        for component in ("python", "data"):
            subprocess.check_call(["cmake", "--install", build, "--prefix", staged, "--component", component])
        package = ROOT / "python" / "bitrock" if self.inplace else Path(self.build_lib).resolve() / "bitrock"
        shutil.copytree(staged / "lib/python3/dist-packages/bitrock", package, dirs_exist_ok=True)
        shutil.copytree(staged / "share/bitrock", package / "data", dirs_exist_ok=True)


setup(
    version=VERSION,
    packages=["bitrock"],
    package_dir={"bitrock": "python/bitrock"},
    package_data={"bitrock": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("bitrock._native", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
)
