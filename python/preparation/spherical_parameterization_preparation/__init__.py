# SPDX-License-Identifier: GPL-3.0-or-later
"""The command-line tool as pip installs it: beside this file, so that it finds the libraries that come with it."""

import os
import sys
from pathlib import Path


def run_tool() -> None:
    """Becomes the tool."""
    tool = Path(__file__).with_name("spherical-parameterization")
    os.execv(tool, [str(tool), *sys.argv[1:]])
