# SPDX-License-Identifier: LGPL-3.0-or-later
"""Statistics of shapes that correspond: alignment, mean and principal components."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, OneLine, check, doubles, index_triples, numbers
from .spherical_harmonics import Harmonics

Shapes = Union[npt.ArrayLike, Sequence[Harmonics]]


@dataclass(frozen=True, eq=False, repr=False)
class ShapeStatistics(OneLine):
    """Mean and principal components of n shapes: shape i is `mean + tensordot(scores[i], modes, 1)`.

    For `Harmonics`, mean and modes are coefficients, ((L + 1)**2, 3) instead of (m, 3).

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(2)
    >>> ellipsoids = [sphere * [1 + i, 2, 1] for i in range(5)]
    >>> statistics = sp.shape_statistics(ellipsoids)
    >>> statistics.explained.round(6).tolist()
    [1.0]
    """

    mean: Doubles  #: (m, 3)
    modes: Doubles  #: (k, m, 3), orthonormal: root mean square 1 over the vertices, or over the sphere
    variances: Doubles  #: (k,), variances of the scores, divided by n - 1; largest first
    scores: Doubles  #: (n, k)
    total_variance: float  #: sum of the variances of all modes, including those that were not requested

    @property
    def explained(self) -> Doubles:
        """(k,): the share of every mode in the total variance."""
        return self.variances / self.total_variance if self.total_variance > 0 else self.variances

    def shape(self, scores: npt.ArrayLike) -> Doubles:
        """The shape with these scores.

        Parameters
        ----------
        scores : array_like (j,) of float
            Of the first modes; not more than there are.

        Returns
        -------
        ndarray (m, 3) of float64
        """
        given = np.atleast_1d(doubles("scores", scores))
        if given.ndim != 1 or len(given) > len(self.modes):
            raise ValueError(f"scores: shape (j,) with j <= {len(self.modes)} is needed, not {given.shape}")
        return self.mean + np.tensordot(given, self.modes[: len(given)], 1)


@dataclass(frozen=True, eq=False, repr=False)
class ShapeSet(OneLine):
    """Aligned shapes, and their transformations: x was mapped to `scales[i] * rotations[i] @ x + translations[i]`."""

    shapes: Doubles  #: (n, m, 3): vertices, or coefficients of harmonics
    scales: Doubles  #: (n,)
    rotations: Doubles  #: (n, 3, 3)
    translations: Doubles  #: (n, 3)
    deviation: float  #: root mean square distance from the mean, over vertices and shapes
    has_converged: bool
    iterations: int


def _stack(shapes: Shapes, weights: npt.ArrayLike | None = None) -> tuple[Doubles, bool, list[float]]:
    """The shapes, whether they are harmonics, and the weights; as the core takes them."""
    tables: Any = shapes
    are_harmonics = isinstance(tables, Sequence) and len(tables) > 0 and isinstance(tables[0], Harmonics)
    if are_harmonics:
        tables = [getattr(shape, "coefficients", shape) for shape in tables]
    array = doubles("shapes", tables)
    if array.ndim != 3 or array.shape[2] != 3 or 0 in array.shape:
        raise ValueError(f"shapes: shape (n, m, 3) is needed, not {array.shape}")
    if weights is None:
        return array, are_harmonics, []
    if are_harmonics:
        raise ValueError("weights: coefficients have none: their mean is that over the sphere")
    given = numbers("weights", weights, array.shape[1])
    if not (np.isfinite(given).all() and given.min() >= 0 and given.sum() > 0):
        raise ValueError("weights: finite numbers that are not negative are needed, not all of them 0")
    return array, are_harmonics, given.tolist()


def _groups(groups: int | None, shapes: Doubles) -> int:
    if len(shapes) < 2 or (groups is not None and not 2 <= groups <= len(shapes)):
        raise ValueError("groups: two shapes or more are needed, and 2 to n groups")
    return groups or 0


def align_shapes(
    shapes: Shapes, *, weights: npt.ArrayLike | None = None, rotate: bool = True, scale: bool = False,
    accuracy: float = 1e-10, iterations: int = 1000, policy: str = "parallel",
) -> ShapeSet:
    """Generalized Procrustes alignment: moves shapes so that they are closest to their mean.

    Parameters
    ----------
    shapes : array_like (n, m, 3) of float, or sequence of n Harmonics
        Vertex j of all shapes corresponds, or coefficient j.
    weights : array_like (m,) of float
        Weights of the vertices, such as `mean_vertex_areas()`. Default: equal.
    rotate : bool
        Rotates all shapes except the first one. Otherwise only their centres are moved to the origin.
    scale : bool
        Scales all shapes to the same size.
    accuracy : float
        Stops when no rotation changes by more than this, in radians.
    iterations : int
        Maximum number of iterations.
    policy : {"parallel", "sequential"}

    Returns
    -------
    ShapeSet
    """
    check(align_shapes, locals())
    given = _stack(shapes, weights)
    if not accuracy >= 0:
        raise ValueError("accuracy: must not be negative")
    aligned, *motions, deviation, has_converged, steps = _core.align_shapes(*given, rotate, scale, accuracy, iterations, policy)
    scales, rotations, translations = (np.array(motion) for motion in motions)
    return ShapeSet(aligned, scales, rotations, translations, deviation, has_converged, steps)


def shape_statistics(
    shapes: Shapes, *, weights: npt.ArrayLike | None = None, modes: int | None = None, policy: str = "parallel",
) -> ShapeStatistics:
    """Mean and principal components of shapes. Call `align_shapes()` first.

    Parameters
    ----------
    shapes, weights, policy
        As for `align_shapes()`.
    modes : int
        Maximum number of modes. Default: all modes above rounding errors, n - 1 or fewer.

    Returns
    -------
    ShapeStatistics
    """
    check(shape_statistics, locals())
    given = _stack(shapes, weights)
    number = len(given[0])
    mean, found, variances, scores, total = _core.shape_statistics(*given, number if modes is None else modes, policy)
    table = np.array(scores, dtype=np.float64).reshape(number, len(variances))
    return ShapeStatistics(mean, found, np.array(variances), table, total)


def left_out_errors(
    shapes: Shapes, *, weights: npt.ArrayLike | None = None, groups: int | None = None, policy: str = "parallel",
) -> Doubles:
    """Leave-out errors: every shape is left out, and reconstructed from the modes of the others.

    Parameters
    ----------
    shapes, weights, policy
        As for `align_shapes()`, which should have aligned the shapes.
    groups : int
        Number of groups in which shapes are left out, 2 to n. Default: one by one.

    Returns
    -------
    ndarray (k,) of float64
        For each number of modes, from 0 on: the root mean square distance of the left out shapes from their reconstructions.
    """
    check(left_out_errors, locals())
    given = _stack(shapes, weights)
    return np.array(_core.left_out_errors(*given, _groups(groups, given[0]), policy)[0])


@dataclass(frozen=True, eq=False, repr=False)
class ModelQuality(OneLine):
    """The quality of a set of shapes as a statistical model, for each number of modes, from 0 on."""

    compactness: Doubles  #: (k,): the variance of this number of modes; for all modes the total variance
    generalization: Doubles  #: `left_out_errors()`: for as many modes as the other shapes have
    specificity: Doubles  #: (k,): mean distance of a random shape of the model from the nearest shape of the set
    specificity_error: Doubles  #: (k,): the standard error of that mean


def model_quality(
    shapes: Shapes, *, weights: npt.ArrayLike | None = None, groups: int | None = None, samples: int = 1000,
    seed: int = 1, policy: str = "parallel",
) -> ModelQuality:
    """Compactness, generalization and specificity of shapes as a model (Davies 2002; Styner et al. 2003).

    Parameters
    ----------
    shapes, weights, policy
        As for `align_shapes()`, which should have aligned the shapes.
    groups : int
        As for `left_out_errors()`.
    samples : int
        Number of random shapes, 2 or more. A random shape is the mean plus modes with normally distributed scores.
    seed : int
        Seed of the random numbers.

    Returns
    -------
    ModelQuality
    """
    check(model_quality, locals())
    given = _stack(shapes, weights)
    if samples < 2:
        raise ValueError(f"samples: 2 or more are needed, not {samples}")
    figures = _core.model_quality(*given, _groups(groups, given[0]), samples, seed, policy)
    return ModelQuality(*(np.array(figure, dtype=np.float64) for figure in figures))


def mean_vertex_areas(shapes: npt.ArrayLike, triangles: npt.ArrayLike, *, policy: str = "parallel") -> Doubles:
    """Areas of the vertices: a third of the areas of their faces, averaged over the shapes.

    Parameters
    ----------
    shapes : array_like (n, m, 3) of float
    triangles : array_like (f, 3) of int
        The triangles, the same for all shapes.
    policy : {"parallel", "sequential"}

    Returns
    -------
    ndarray (m,) of float64
        Can be used as `weights` of `align_shapes()`, `shape_statistics()` and `left_out_errors()`.
    """
    check(mean_vertex_areas, locals())
    array, are_harmonics, _ = _stack(shapes)
    if are_harmonics:
        raise TypeError("shapes: points are needed, not coefficients of harmonics")
    return np.array(_core.mean_vertex_areas(array, index_triples(triangles), policy))
