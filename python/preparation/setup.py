# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds spherical_parameterization._preparation, which is under the GPL, as ../setup.py builds the core."""

import runpy
from pathlib import Path

runpy.run_path(str(Path(__file__).resolve().parent.parent / "setup.py"), init_globals={"MODULE": "preparation"})
