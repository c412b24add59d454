# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for the tests, and the tool that maps are compared with."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp


def ellipsoid(level: int = 4) -> tuple[np.ndarray, np.ndarray]:
    points, triangles = sp.icosphere(level)
    return points * [1, 2, 3], triangles


def bumpy(level: int = 4, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """A star-shaped body with waves, another one for every seed."""
    points, triangles = sp.icosphere(level)
    frequencies = np.random.default_rng(seed).normal(size=(4, 3)) * 3
    radius = 1 + 0.1 * np.sin(points @ frequencies.T).sum(axis=1)
    return points * radius[:, None], triangles


def tube(rings: int = 300, sides: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """A closed tube, too long for a harmonic map in double precision."""
    ring, side = np.divmod(np.arange(rings * sides), sides)
    angle = 2 * np.pi * side / sides
    points = np.column_stack([np.cos(angle), np.sin(angle), 0.5 * ring])
    a = (ring * sides + side)[: (rings - 1) * sides]
    b = (ring * sides + (side + 1) % sides)[: (rings - 1) * sides]
    walls = [np.column_stack([a, b, b + sides]), np.column_stack([a, b + sides, a + sides])]
    first, last = np.arange(sides), np.arange(sides) + (rings - 1) * sides
    bottom, top = len(points), len(points) + 1
    caps = [
        np.column_stack([np.full(sides, bottom), np.roll(first, -1), first]),
        np.column_stack([np.full(sides, top), last, np.roll(last, -1)]),
    ]
    points = np.vstack([points, [0, 0, -0.5], [0, 0, 0.5 * rings]])
    return points, np.concatenate(walls + caps)


class Tool:
    """The command-line tool, named by SPHERICAL_PARAMETERIZATION_TOOL; ctest sets that."""

    def __init__(self, folder: Path) -> None:
        self.program = os.environ.get("SPHERICAL_PARAMETERIZATION_TOOL", "")
        self.folder = folder

    def run(self, command: str, points: np.ndarray, triangles: np.ndarray, *options: str, out: str = "out.off") -> Path:
        """Runs a command on a mesh; returns its output file."""
        if not self.program:
            pytest.skip("SPHERICAL_PARAMETERIZATION_TOOL is not set")
        mesh = self.folder / "in.ply"
        sp.write_mesh(mesh, points, triangles)
        output = self.folder / out
        subprocess.run([self.program, command, mesh, "-o", output, *options], check=True, capture_output=True)
        return output


@pytest.fixture
def tool(tmp_path: Path) -> Tool:
    return Tool(tmp_path)
