# SPDX-License-Identifier: LGPL-3.0-or-later
"""Eigenfunctions of the Laplace-Beltrami operator."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, OneLine, check, doubles, index_triples, vectors


@dataclass(frozen=True, eq=False, repr=False)
class Eigenpairs(OneLine):
    """The smallest eigenvalues of the Laplacian of a surface and their functions; see `laplacian_eigenpairs()`."""

    values: Doubles  #: (k,), ascending, in units of 1 / length**2; the first one is 0
    functions: Doubles  #: (n, k), in units of 1 / length; `functions.T @ (masses[:, None] * functions)` is the unit matrix
    masses: Doubles  #: (n,), a third of the areas of the faces of every vertex

    def __post_init__(self) -> None:
        shapes = [np.shape(array) for array in (self.values, self.functions, self.masses)]
        if len(shapes[1]) != 2 or shapes != [shapes[1][1:], shapes[1], shapes[1][:1]]:
            raise ValueError(f"values, functions and masses: shapes (k,), (n, k) and (n,) are needed, not {shapes}")

    def heat_kernel_signature(self, times: npt.ArrayLike) -> Doubles:
        """The share of a unit of heat at a vertex that is still there after some time.

        J. Sun, M. Ovsjanikov, L. Guibas, "A concise and provably informative multi-scale signature based on heat
        diffusion", SGP 2009.

        Parameters
        ----------
        times : array_like (t,) of float
            In units of length**2, finite and not negative.

        Returns
        -------
        ndarray (n, t) of float64
            In units of 1 / length**2. Missing pairs have an influence for times below about 4 / values[-1].
        """
        t = doubles("times", times)
        if t.ndim != 1 or not ((t >= 0) & (t < np.inf)).all():
            raise ValueError("times: a list of finite numbers that are not negative is needed")
        return _core.heat_kernel_signature(self.values, self.functions.T, t).T

    def wave_kernel_signature(self, energies: int = 100) -> Doubles:
        """The probability of finding a quantum particle of some energy at a vertex.

        M. Aubry, U. Schlickewei, D. Cremers, "The wave kernel signature: a quantum mechanical approach to shape analysis",
        ICCV Workshops 2011. Two pairs or more are needed.

        Parameters
        ----------
        energies : int
            Number of energies, two or more. They are spaced evenly on a logarithmic scale of the eigenvalues.

        Returns
        -------
        ndarray (n, energies) of float64
            In units of 1 / length**2.
        """
        check(Eigenpairs.wave_kernel_signature, locals())
        if energies < 2 or len(self.values) < 2:
            raise ValueError("two energies or more, and two pairs or more are needed")
        return _core.wave_kernel_signature(self.values, self.functions.T, energies).T


def laplacian_eigenpairs(
    points: npt.ArrayLike, triangles: npt.ArrayLike, number: int, *, policy: str = "parallel"
) -> Eigenpairs:
    """The smallest eigenvalues of the Laplace-Beltrami operator of a closed surface of genus 0, and their functions.

    They depend on lengths inside the surface only, so that two poses of a body have nearly the same. The Laplacian is that
    of cotangents of the intrinsic Delaunay triangulation, with all edges longer by up to 1e-6 of the mean where triangles would have
    no area: of surfaces that are a thousand times as long as wide, it resolves less. No pair is missed.

    Parameters
    ----------
    points, triangles, policy
        As for `parameterize()`.
    number : int
        Number of pairs, including that of the eigenvalue 0; from 1 to the number of vertices.

    Returns
    -------
    Eigenpairs

    Raises
    ------
    MeshError
        As for `parameterize()`, and if the faces around a vertex have the area 0.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> points, triangles = sp.icosphere(4)
    >>> pairs = sp.laplacian_eigenpairs(points, triangles, 9)
    >>> pairs.values.round(1).tolist()  # l (l + 1), 2 l + 1 times each
    [0.0, 2.0, 2.0, 2.0, 6.0, 6.0, 6.0, 6.0, 6.0]
    """
    check(laplacian_eigenpairs, locals())
    p = vectors("points", points)
    if not 1 <= number <= len(p):
        raise ValueError(f"number: from 1 to the number of vertices, {len(p)}, not {number}")
    values, functions, masses = _core.laplacian_eigenpairs(p, index_triples(triangles), number, policy)
    return Eigenpairs(doubles("values", values), functions.T, doubles("masses", masses))
