# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds what is under the GPL, spherical_parameterization._preparation and the tool, as ../setup.py builds the core."""

import runpy
from pathlib import Path

here = Path(__file__).resolve().parent
of_core = here / "source/python/setup.py"  # in a source distribution
runpy.run_path(str(of_core if of_core.exists() else here.parent / "setup.py"), init_globals={"MODULE": "preparation"})
