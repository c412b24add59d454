# SPDX-License-Identifier: GPL-3.0-or-later
"""What users install: by pip in a virtual environment, and the .deb. ctest says where the build folder is."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

BUILD = os.environ.get("SPHERICAL_PARAMETERIZATION_BUILD", "")
PROGRAM = "import spherical_parameterization as sp; print(sp.__file__, sp.parameterize(*sp.icosphere(2)).is_valid)"
PREPARED = "import spherical_parameterization as sp; p, t = sp.icosphere(3); print(len(sp.prepare(p, t[1:]).points))"

pytestmark = pytest.mark.skipif(not BUILD, reason="SPHERICAL_PARAMETERIZATION_BUILD is not set")


def run(*command: object, **environment: str) -> str:
    names = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(  # not where ctest runs: Python would find the build folder's package there
        [*map(str, command)], env={**names, **environment}, capture_output=True, text=True, cwd=tempfile.gettempdir()
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_pip(tmp_path: Path) -> None:
    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv")
    python = tmp_path / "venv/bin/python3"
    source = Path(__file__).parent.parent
    run(python, "-m", "pip", "install", "--no-build-isolation", "--no-index", source)
    where, is_valid = run(python, "-c", PROGRAM).split()
    assert where.startswith(str(tmp_path)) and is_valid == "True"
    modules = [file.name.partition(".")[0] for file in Path(where).parent.glob("*.so")]
    assert modules == ["_core"]  # what is under the GPL comes separately
    run(python, "-m", "pip", "install", "--no-build-isolation", "--no-index", source / "preparation")
    assert run(python, "-c", PREPARED).split() == ["642"]


@pytest.mark.skipif(not shutil.which("dpkg-deb"), reason="not on Debian")
def test_deb(tmp_path: Path) -> None:
    run("cpack", "--config", Path(BUILD) / "CPackConfig.cmake", "-G", "DEB", "-B", tmp_path, "-D", "CPACK_COMPONENTS_ALL=python")
    (package,) = tmp_path.glob("python3-spherical-parameterization_*.deb")
    run("dpkg-deb", "--extract", package, tmp_path / "root")
    depends = run("dpkg-deb", "--field", package, "Depends")
    assert "python3-numpy" in depends and "libtbb" in depends and "libcgal-dev" not in depends
    folder = tmp_path / "root/usr/lib/python3/dist-packages"
    where, is_valid = run(sys.executable, "-c", PROGRAM, PYTHONPATH=str(folder)).split()
    assert where.startswith(str(folder)) and is_valid == "True"
    assert run(sys.executable, "-c", PREPARED, PYTHONPATH=str(folder)).split() == ["642"]
