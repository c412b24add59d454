# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for the tests, and the tool that maps are compared with."""

from __future__ import annotations

import contextlib
import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp

Tool = Callable[..., Path]


def ellipsoid(level: int = 4) -> tuple[np.ndarray, np.ndarray]:
    points, triangles = sp.icosphere(level)
    return points * [1, 2, 3], triangles


def bumpy(level: int = 4, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """A star-shaped body with waves, another one for every seed."""
    points, triangles = sp.icosphere(level)
    frequencies = np.random.default_rng(seed).normal(size=(4, 3)) * 3
    radius = 1 + 0.1 * np.sin(points @ frequencies.T).sum(axis=1)
    return points * radius[:, None], triangles


def quads(*corners: np.ndarray) -> np.ndarray:
    """Two triangles for each quadrangle, given by arrays of its four corners."""
    a, b, c, d = map(np.ravel, corners)
    return np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def tube(rings: int = 300, sides: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """A closed tube, too long for a harmonic map in double precision."""
    number = np.arange(rings * sides).reshape(rings, sides)
    beside = np.roll(number, -1, axis=1)
    ring, side = np.divmod(number.ravel(), sides)
    angle = 2 * np.pi * side / sides
    points = np.column_stack([np.cos(angle), np.sin(angle), 0.5 * ring])
    walls = quads(number[:-1], beside[:-1], beside[1:], number[1:])
    bottom = [[number.size, j, i] for i, j in zip(number[0], beside[0])]
    top = [[number.size + 1, i, j] for i, j in zip(number[-1], beside[-1])]
    return np.vstack([points, [0, 0, -0.5], [0, 0, 0.5 * rings]]), np.concatenate([walls, bottom, top])


def torus(n: int = 16, m: int = 8) -> tuple[np.ndarray, np.ndarray]:
    number = np.arange(n * m).reshape(n, m)
    below = np.roll(number, -1, axis=0)
    i, j = np.divmod(number.ravel(), m)
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    points = np.column_stack([(2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)])
    return points, quads(number, below, np.roll(below, -1, axis=1), np.roll(number, -1, axis=1))


def double_areas(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    a, b, c = points[triangles].swapaxes(0, 1)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1)


def cotangents(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Of the angle at each corner, (m, 3)."""
    p = points[triangles]
    a, b = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
    return (a * b).sum(axis=2) / np.linalg.norm(np.cross(a, b), axis=2)


def rotation(seed: int) -> np.ndarray:
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return q * np.linalg.det(q)


@contextlib.contextmanager
def refused(code: str, match: str | None = None) -> Iterator[None]:
    """As pytest.raises(), of a MeshError of this code."""
    with pytest.raises(sp.MeshError, match=match) as caught:
        yield
    assert caught.value.code == code


@pytest.fixture
def program() -> str:
    """The command-line tool, named by SPHERICAL_PARAMETERIZATION_TOOL; ctest sets that."""
    if not os.environ.get("SPHERICAL_PARAMETERIZATION_TOOL"):
        pytest.skip("SPHERICAL_PARAMETERIZATION_TOOL is not set")
    return os.environ["SPHERICAL_PARAMETERIZATION_TOOL"]


@pytest.fixture
def tool(program: str, tmp_path: Path) -> Tool:
    """Runs a command of the tool on a mesh, in.ply of tmp_path; returns its output file."""

    def run(command: str, points: np.ndarray, triangles: np.ndarray, *options: str, out: str = "out.off") -> Path:
        sp.write_mesh(tmp_path / "in.ply", points, triangles)
        subprocess.run([program, command, tmp_path / "in.ply", "-o", tmp_path / out, *options], check=True, capture_output=True)
        return tmp_path / out

    return run
