# SPDX-License-Identifier: GPL-3.0-or-later
"""Types, docstrings, doctests, licences."""

import doctest
import importlib
import inspect
import os
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import spherical_parameterization as sp

PACKAGE = Path(sp.__file__).parent
MODULES = [m.name for m in pkgutil.iter_modules([str(PACKAGE)]) if not m.name.startswith("_")]


def test_types(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    config = Path(__file__).parent.parent / "pyproject.toml"
    command = [sys.executable, "-m", "mypy", "--config-file", config, "--cache-dir", tmp_path, "-p", PACKAGE.name]
    done = subprocess.run(command, cwd=PACKAGE.parent, env={**os.environ, "PYTHONPATH": ""}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("module", MODULES)
def test_doctests(module: str) -> None:
    failures, _ = doctest.testmod(importlib.import_module(f"{PACKAGE.name}.{module}"))
    assert failures == 0


FUNCTIONS = [name for name in sp.__all__ if inspect.isfunction(getattr(sp, name))]
FUNCTIONS += [f"{c.__name__}.{name}" for c in (sp.Locator, sp.Resampling) for name in vars(c) if name[0] != "_"]
FUNCTIONS += [f"collection.{name}" for name in ("map", "read", "map_file", "signature_file")]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_docstrings(name: str) -> None:
    """A docstring; no parameter is missing or unknown."""
    validate = pytest.importorskip("numpydoc.validate").validate
    errors = validate(f"{PACKAGE.name}.{name}")["errors"]
    assert not [error for error in errors if error[0] in ("GL08", "PR01", "PR02", "RT01")]


def test_classes_have_docstrings() -> None:
    assert all(inspect.getdoc(getattr(sp, name)) for name in sp.__all__ if not name.startswith("_"))


def test_nothing_that_is_gpl() -> None:
    """No header and no source of the core is under the GPL alone."""
    build = PACKAGE.parent.parent
    kinds = ("python/CMakeFiles/*_core.dir/src", "src/CMakeFiles/*_files.dir/*", "CMakeFiles/*compiled.dir/compiled")
    lists = [file for kind in kinds for file in build.glob(f"{kind}/*.d")]
    if not lists:
        pytest.skip("not in a build folder of CMake")
    files = set()
    for d in lists:
        folder = next(parent.parent for parent in d.parents if parent.name == "CMakeFiles")  # where the compiler ran
        files |= {(folder / name).resolve() for name in re.findall(r"\s(\S+/(?:CGAL|compiled|src)/\S+)", d.read_text())}
    assert len(files) > 100
    for file in filter(Path.exists, files):  # others are of a build before
        spdx = re.search(r"SPDX-License-Identifier: (.*)", file.read_text())
        licence = spdx.group(1) if spdx else ""
        assert not re.match(r"(?<!L)GPL", licence), f"{file}: {licence}"


def test_reference_is_up_to_date() -> None:
    """The chapter of the manual is what the docstrings say."""
    pytest.importorskip("numpydoc")
    import make_reference

    chapter = Path(__file__).parents[2] / "doc/python_reference.md"
    assert chapter.read_text() == make_reference.page() + "\n", f"run {make_reference.__doc__}"
