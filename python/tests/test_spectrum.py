# SPDX-License-Identifier: GPL-3.0-or-later
"""Eigenfunctions of the Laplacian, against scipy."""

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy, cotangents, double_areas


def laplacian(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Of the mesh itself, dense."""
    matrix = np.zeros((len(points), len(points)))
    i, j = np.roll(triangles, -1, axis=1), np.roll(triangles, 1, axis=1)  # the ends of the edge across each corner
    for ends in ((i, j), (j, i)):
        np.add.at(matrix, ends, -cotangents(points, triangles) / 2)
    return matrix - np.diag(matrix.sum(1))


def test_pairs_are_those_of_scipy() -> None:
    linalg = pytest.importorskip("scipy.linalg")
    points, triangles = bumpy(3, 5)
    points = 7 * points
    pairs = sp.laplacian_eigenpairs(points, triangles, 40)
    masses = np.bincount(triangles.ravel(), np.repeat(double_areas(points, triangles), 3), len(points)) / 6
    assert np.allclose(pairs.masses, masses)
    expected, functions = linalg.eigh(laplacian(points, triangles), np.diag(masses), subset_by_index=(0, 39))
    assert np.allclose(pairs.values, expected, atol=1e-9)  # all edges of this mesh are Delaunay
    assert np.allclose(pairs.functions.T @ (masses[:, None] * pairs.functions), np.eye(40), atol=1e-9)
    times = [0.5, 5.0]
    heat = np.stack([(np.exp(-t * expected) * functions**2).sum(1) for t in times], 1)
    assert np.allclose(pairs.heat_kernel_signature(times), heat)


def test_signatures_do_not_know_position_and_orientation() -> None:
    points, triangles = bumpy(3, 6)
    turned = points[:, [1, 2, 0]] + 3
    a, b = (sp.laplacian_eigenpairs(p, triangles, 30) for p in (points, turned))
    wave = a.wave_kernel_signature(20)
    assert wave.shape == (len(points), 20) and (wave > 0).all()
    assert np.allclose(wave, b.wave_kernel_signature(20), rtol=1e-5)
    assert np.allclose(wave.T @ a.masses, 1)  # of each energy, over the surface
    assert np.allclose(2 * a.values, sp.laplacian_eigenpairs(points / np.sqrt(2), triangles, 30).values, atol=1e-9)


def test_what_is_wrong_is_said() -> None:
    points, triangles = bumpy(2, 7)
    for number in (0, len(points) + 1):
        with pytest.raises(ValueError, match="number"):
            sp.laplacian_eigenpairs(points, triangles, number)
    with pytest.raises(sp.MeshError):
        sp.laplacian_eigenpairs(points, triangles[1:], 3)
    pairs = sp.laplacian_eigenpairs(points, triangles, 3)
    with pytest.raises(ValueError, match="times"):
        pairs.heat_kernel_signature([-1.0])
    with pytest.raises(ValueError, match="energies"):
        pairs.wave_kernel_signature(1)
