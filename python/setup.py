# SPDX-License-Identifier: LGPL-3.0-or-later
"""Builds the compiled core with CMake, for pip: see pyproject.toml. preparation/setup.py runs it for its own module."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

here = Path(__file__).resolve().parent
root = here.parent
module = globals().get("MODULE", "core")
version_file = root / "include/CGAL/Spherical_parameterization/version.h"


class CMakeBuild(build_ext):
    """Builds one target in a folder of its own, or in the one that the environment names, where much may be built."""

    def build_extension(self, extension: Extension) -> None:
        folder = Path(os.environ.get("SPHERICAL_PARAMETERIZATION_BUILD", here / "build" / "cmake")).resolve()
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        configure = ["cmake", "-S", root, "-B", folder, "-DCGAL_SP_WITH_PYTHON=ON"]
        if not (folder / "CMakeCache.txt").exists():
            off = ("BUILD_TESTING", "WITH_TOOL", "WITH_EXAMPLES", "WITH_INSTALL")
            configure += [f"-DPython3_EXECUTABLE={sys.executable}", *(f"-DCGAL_SP_{option}=OFF" for option in off)]
        try:
            import pybind11

            configure.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:  # CMake knows where Debian has it
            pass
        subprocess.run(configure, check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        subprocess.run(
            ["cmake", "--build", folder, "--target", f"spherical_parameterization_{module}", "--parallel", jobs], check=True
        )
        target.parent.mkdir(parents=True, exist_ok=True)
        built = folder / "python" / "spherical_parameterization" / target.name
        target.write_bytes(built.read_bytes())


setup(
    version=re.search(r'VERSION "(.*)"', version_file.read_text()).group(1),
    ext_modules=[Extension(f"spherical_parameterization._{module}", [])],
    cmdclass={"build_ext": CMakeBuild},
)
