# SPDX-License-Identifier: GPL-3.0-or-later
"""What users install: wheels, source distributions, the .deb. ctest says where the build folder is."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import Tool, bumpy

BUILD = os.environ.get("SPHERICAL_PARAMETERIZATION_BUILD", "")
SOURCE = Path(__file__).parents[2]
PROJECTS = ["python", "python/preparation"]
PROGRAM = "import spherical_parameterization as sp; print(sp.__file__, sp.parameterize(*sp.icosphere(2)).is_valid)"
PREPARED = "import spherical_parameterization as sp; p, t = sp.icosphere(3); print(len(sp.prepare(p, t[1:]).points))"
MAPPED = """
import numpy, spherical_parameterization as sp
numpy.save("sphere.npy", sp.parameterize(*sp.read_mesh("in.ply")).sphere)
print(*{line.split()[-1] for line in open("/proc/self/maps") if ".so" in line})
"""

pytestmark = pytest.mark.skipif(not BUILD, reason="SPHERICAL_PARAMETERIZATION_BUILD is not set")


def run(*command: object, cwd: str | Path = tempfile.gettempdir(), **environment: str) -> str:
    names = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(  # not where ctest runs: Python would find the build folder's package there
        [*map(str, command)], env={**names, **environment}, capture_output=True, text=True, cwd=cwd
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.skipif(not shutil.which("patchelf") or not shutil.which("dpkg-query"), reason="not on Debian, or no patchelf")
def test_wheels(tmp_path: Path, tool: Tool) -> None:
    """Made of what is built, they are installed and work without a compiler, and with the libraries that they bring along."""
    for project in PROJECTS:
        options = ["--no-build-isolation", "--no-index", "--no-deps", "--wheel-dir", tmp_path / "built"]
        run(sys.executable, "-m", "pip", "wheel", *options, SOURCE / project)
    for wheel in (tmp_path / "built").iterdir():
        with zipfile.ZipFile(wheel) as archive:
            assert {"LICENSE", "LICENSE.GPL"} <= {Path(name).name for name in archive.namelist()}
        run(sys.executable, SOURCE / "scripts/repair_wheel.py", wheel, tmp_path / "wheels")
    core, preparation = sorted((tmp_path / "wheels").iterdir())
    assert all("-manylinux_2_" in wheel.name and wheel.stat().st_size < 8e6 for wheel in (core, preparation))

    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv")  # for numpy
    commands = tmp_path / "venv/bin"

    def run_there(name: str, *arguments: object) -> str:
        return run(commands / name, *arguments, cwd=tmp_path, PATH=str(commands))

    run_there("pip", "install", "--no-index", core)
    sphere = tool("map", *bumpy(5))
    libraries = [Path(name) for name in run_there("python3", "-c", MAPPED).split()]
    assert np.array_equal(np.load(tmp_path / "sphere.npy"), sp.read_mesh(sphere)[0])
    ours = [file for file in libraries if re.match("lib(tbb|OpenCL|boost_iostreams)", file.name)]
    assert ours and all(file.is_relative_to(tmp_path) for file in ours)
    modules = [file.name.partition(".")[0] for file in (tmp_path / "venv").glob("lib/python3*/site-packages/spherical*/*.so")]
    assert modules == ["_core"] and not (commands / "spherical-parameterization").exists()  # what is under the GPL is separate

    run_there("pip", "install", "--no-index", preparation)
    assert run_there("python3", "-c", PREPARED).split() == ["642"]
    run_there("spherical-parameterization", "map", "in.ply", "-o", "of_wheel.off")
    assert (tmp_path / "of_wheel.off").read_bytes() == sphere.read_bytes()


@pytest.mark.parametrize("project", PROJECTS)
def test_source_distribution(project: str, tmp_path: Path) -> None:
    """CMake accepts it, and whatever the compiler has read of the repository is in it."""
    run(sys.executable, "setup.py", "-q", "sdist", "--dist-dir", tmp_path, cwd=SOURCE / project)
    (archive,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(archive) as tar:
        tar.extractall(tmp_path)
    (source,) = tmp_path.glob("*/source")
    off = [f"-DCGAL_SP_{option}=OFF" for option in ("BUILD_TESTING", "WITH_EXAMPLES", "WITH_INSTALL")]  # as setup.py does
    run("cmake", "-S", source, "-B", tmp_path / "build", "-DCGAL_SP_WITH_PYTHON=ON", *off)

    targets = ["CGAL_Spherical_parameterization_compiled", "spherical_parameterization_files", "spherical_parameterization_core"]
    if project == "python/preparation":
        targets += ["CGAL_Spherical_parameterization_preparation", "spherical_parameterization_preparation"]
        targets += ["spherical_parameterization_tool", "spherical-parameterization"]
    for target in targets:
        (folder,) = Path(BUILD).glob(f"**/CMakeFiles/{target}.dir")
        words = {word for d in folder.rglob("*.d") for word in re.findall(r"[^\s\\]+", d.read_text().partition(":")[2])}
        read = {(folder.parents[1] / word).resolve() for word in words}  # relative to where the compiler ran
        ours = [file.relative_to(SOURCE) for file in read if file.is_relative_to(SOURCE) and not file.is_relative_to(BUILD) and file.exists()]
        assert ours and not [file for file in ours if not (source / file).exists()]


@pytest.mark.skipif(not shutil.which("dpkg-deb"), reason="not on Debian")
def test_deb(tmp_path: Path) -> None:
    run("cpack", "--config", Path(BUILD) / "CPackConfig.cmake", "-G", "DEB", "-B", tmp_path, "-D", "CPACK_COMPONENTS_ALL=python")
    (package,) = tmp_path.glob("python3-spherical-parameterization_*.deb")
    run("dpkg-deb", "--extract", package, tmp_path / "root")
    depends = run("dpkg-deb", "--field", package, "Depends")
    assert "python3-numpy" in depends and "libtbb" in depends and "libcgal-dev" not in depends
    version, following = (f"3.{sys.version_info.minor + later}" for later in (0, 1))
    assert f"python3 (>= {version}), python3 (<< {following})" in depends
    texts = (tmp_path / "root/usr/share/doc/python3-spherical-parameterization").iterdir()
    assert {file.name for file in texts} >= {"LICENSE", "LICENSE.GPL"}
    folder = tmp_path / "root/usr/lib/python3/dist-packages"
    where, is_valid = run(sys.executable, "-c", PROGRAM, PYTHONPATH=str(folder)).split()
    assert where.startswith(str(folder)) and is_valid == "True"
    assert run(sys.executable, "-c", PREPARED, PYTHONPATH=str(folder)).split() == ["642"]


def test_version() -> None:
    """The copies of the version, of which include/CGAL/Spherical_parameterization/version.h has the first."""
    major, minor, patch = map(int, sp.__version__.split("."))
    header = (SOURCE / "include/CGAL/Spherical_parameterization/version.h").read_text()
    assert f"VERSION_NR {10000 * major + 100 * minor + patch}\n" in header
    assert f"\nversion: {sp.__version__}\n" in (SOURCE / "CITATION.cff").read_text()
    assert json.loads((SOURCE / "packaging/vcpkg/vcpkg.json").read_text())["version"] == sp.__version__


def test_recipes(tmp_path: Path) -> None:
    """What can be checked without the programs that the recipes are for: see packaging/README.md."""
    jinja2, yaml = pytest.importorskip("jinja2"), pytest.importorskip("yaml")
    recipes = SOURCE / "packaging"
    functions = {
        "load_file_regex": lambda load_file, regex_pattern, from_recipe_dir: re.search(
            regex_pattern, (recipes / "conda" / load_file).read_text()
        ),
        "compiler": "compiler_{}".format,
        "stdlib": "stdlib_{}".format,
        "pin_subpackage": lambda name, exact: name,
    }
    recipe = (recipes / "conda/meta.yaml").read_text()
    assert not re.search(r"^[^#\n]*\[[^][\n]+\]$", recipe, flags=re.M)  # a list to YAML, a selector to conda-build
    conda = yaml.safe_load(jinja2.Template(recipe).render(PYTHON="python", **functions))
    assert conda["package"]["version"] == sp.__version__ and len(conda["outputs"]) == 2
    assert all(isinstance(name, str) for output in conda["outputs"] for names in output["requirements"].values() for name in names)
    conan = recipes / "conan/conanfile.py"
    compile(conan.read_text(), conan, "exec")
    assert "wheels" in yaml.safe_load((SOURCE / ".github/workflows/wheels.yml").read_text())["jobs"]
    called = ["check_features", "cmake_configure", "cmake_install", "cmake_config_fixup", "fixup_pkgconfig", "copy_tools"]
    lines = [f"function(vcpkg_{name})\nendfunction()" for name in [*called, "install_copyright"]]
    lines += ["cmake_minimum_required(VERSION 3.18)", "set(FEATURES tool)", f"set(CURRENT_PACKAGES_DIR {tmp_path}/vcpkg)"]
    (tmp_path / "run.cmake").write_text("\n".join([*lines, f"include({recipes}/vcpkg/portfile.cmake)\n"]))
    run("cmake", "-P", tmp_path / "run.cmake")
