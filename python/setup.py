# SPDX-License-Identifier: LGPL-3.0-or-later
"""Builds the compiled core with CMake, for pip: see pyproject.toml. preparation/setup.py runs it for its own module."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

here = Path(__file__).resolve().parent
root = here / "source" if (here / "source").exists() else here.parent  # a source distribution, or the repository
module = globals().get("MODULE", "core")
version_file = root / "include/CGAL/Spherical_parameterization/version.h"
sources = (
    "CMakeLists.txt", "LICENSE", "LICENSE.GPL", "cmake", "compiled", "doc/man", "include", "kernels",
    "python/CMakeLists.txt", "python/setup.py", "python/src", "src", "web/viewer",
)


class CMakeBuild(build_ext):
    """Builds one target in a folder of its own, or in the one that the environment names, where much may be built. The tool
    is under the GPL, too, and goes with the module that is.
    """

    def build_extension(self, extension: Extension) -> None:
        folder = Path(os.environ.get("SPHERICAL_PARAMETERIZATION_BUILD", Path.cwd() / "build" / "cmake")).resolve()
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        built = {f"spherical_parameterization_{module}": (folder / "python/spherical_parameterization" / target.name, target)}
        if module == "preparation":
            tool = "spherical-parameterization"
            built[tool] = (folder / "src" / tool, target.parent.parent / "spherical_parameterization_preparation" / tool)
        # -U: the folder may have been another Python's
        configure = ["cmake", "-S", root, "-B", folder, "-U", "*Python3*", "-U", "PYTHON*", "-U", "pybind11*"]
        configure += [f"-DPython3_EXECUTABLE={sys.executable}", "-DCGAL_SP_WITH_PYTHON=ON"]
        if not (folder / "CMakeCache.txt").exists():
            off = ("BUILD_TESTING", "WITH_EXAMPLES", "WITH_INSTALL", *(["WITH_TOOL"] if len(built) == 1 else []))
            configure += [f"-DCGAL_SP_{option}=OFF" for option in off]
        try:
            import pybind11

            configure.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:  # CMake knows where Debian has it
            pass
        subprocess.run(configure, check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        subprocess.run(["cmake", "--build", folder, "--target", *built, "--parallel", jobs], check=True)
        for source, place in built.values():
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, place)


class SourceDistribution(sdist):
    """With all that CMake needs, in a folder `source` laid out as the repository is."""

    def make_release_tree(self, base_dir: str, files: list[str]) -> None:
        super().make_release_tree(base_dir, files)
        for name in sources:
            place = Path(base_dir, "source", name)
            place.parent.mkdir(parents=True, exist_ok=True)
            if (root / name).is_dir():
                shutil.copytree(root / name, place, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copy(root / name, place)


for name in ("LICENSE", "LICENSE.GPL"):  # from the project's folder setuptools puts them into wheels
    shutil.copy(root / name, ".")
version = re.search(r'VERSION "(.*)"', version_file.read_text()).group(1)
setup(
    version=version,
    install_requires=["numpy"] if module == "core" else [f"spherical-parameterization=={version}"],
    ext_modules=[Extension(f"spherical_parameterization._{module}", [])],
    cmdclass={"build_ext": CMakeBuild, "sdist": SourceDistribution},
)
