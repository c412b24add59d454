# SPDX-License-Identifier: LGPL-3.0-or-later
"""Shapes and other data as spherical harmonics (SPHARM)."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, OneLine, Sphere, check, doubles, file_name, index_triples, one_of, sphere_vectors, vectors
from .arrays import wrong_type


@dataclass(frozen=True, eq=False, repr=False)
class Ellipsoid(OneLine):
    """The shape up to degree 1: the points `centre + axes.T @ (radii * (sphere_axes @ x))` for unit vectors x."""

    centre: Doubles  #: (3,)
    radii: Doubles  #: (3,), largest first
    axes: Doubles  #: (3, 3), rows: the directions of the half axes in space
    sphere_axes: Doubles  #: (3, 3), rows: the directions on the sphere that are mapped there


@dataclass(frozen=True, eq=False, repr=False)
class ShapeAlignment(OneLine):
    """The alignment of a shape with another one: `other.rotated(sphere).coefficients @ space.T`, up to position and size."""

    space: Doubles  #: (3, 3), rotates the shape
    sphere: Doubles  #: (3, 3), rotates its map
    correlation: float  #: from -1 to 1, with both centres at the origin


@dataclass(frozen=True, eq=False, repr=False)
class Harmonics(OneLine):
    """Functions on the sphere, given by coefficients of real orthonormal harmonics without Condon-Shortley phase.

    Parameters
    ----------
    coefficients : ndarray ((L + 1)**2,) or ((L + 1)**2, d) of float64
        Row l * l + l + m belongs to l and m, -l <= m <= l. Negative m are sines of the longitude, positive m cosines:
        rows 1, 2 and 3 belong to y, z and x.
    has_converged : bool
        Whether least squares reached their accuracy.
    iterations : int
        Number of iterations of least squares.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(3)
    >>> ellipsoid = sp.harmonics(triangles, sphere, sphere * [3, 2, 1], degree=8)
    >>> ellipsoid.ellipsoid().radii.round(6).tolist()
    [3.0, 2.0, 1.0]
    >>> abs(ellipsoid.at([[1, 0, 0]])).round(6).tolist()
    [[3.0, 0.0, 0.0]]
    """

    coefficients: Doubles
    has_converged: bool = True
    iterations: int = 0

    def __post_init__(self) -> None:
        check(Harmonics, vars(self))
        c = doubles("coefficients", self.coefficients)
        if c.ndim not in (1, 2) or c.shape[0] == 0 or math.isqrt(c.shape[0]) ** 2 != c.shape[0]:
            raise ValueError(f"coefficients: shape ((L + 1)**2,) or ((L + 1)**2, d) is needed, not {c.shape}")
        if not np.isfinite(c).all():
            raise ValueError("coefficients: all have to be finite")
        object.__setattr__(self, "coefficients", c)

    @property
    def degree(self) -> int:
        """The largest l."""
        return math.isqrt(len(self.coefficients)) - 1

    @property
    def _table(self) -> Doubles:
        return self.coefficients.reshape(len(self.coefficients), -1)

    def _with(self, table: Doubles) -> Harmonics:
        return Harmonics(table.reshape((len(table), *self.coefficients.shape[1:])))

    def at(self, directions: Sphere, *, policy: str = "parallel") -> Doubles:
        """The values of the functions.

        Parameters
        ----------
        directions : array_like (k, 3) of float
            Vectors of any length except 0, or a `Result`. For a map, the result is the reconstruction of the shape.
        policy : {"parallel", "sequential"}

        Returns
        -------
        ndarray (k,) or (k, d) of float64
        """
        check(Harmonics.at, locals())
        values = _core.harmonic_values(self._table, sphere_vectors("directions", directions), policy)
        return values.reshape((len(values), *self.coefficients.shape[1:]))

    def on_grid(self, rows: int, columns: int, *, policy: str = "parallel") -> Doubles:
        """The values on a grid of latitudes and longitudes.

        Parameters
        ----------
        rows : int
            Number of latitudes, equidistant from the north pole to the south pole, including both; 2 or more.
        columns : int
            Number of longitudes, equidistant from 0, excluding 2 pi.
        policy : {"parallel", "sequential"}

        Returns
        -------
        ndarray (rows, columns) or (rows, columns, d) of float64
        """
        check(Harmonics.on_grid, locals())
        values = np.moveaxis(_core.harmonic_grid(self._table, rows, columns, policy), 0, -1)
        return np.ascontiguousarray(values).reshape((rows, columns, *self.coefficients.shape[1:]))

    def power_spectrum(self) -> Doubles:
        """The sum of the squares of the coefficients of each degree: the same for all rotations.

        Returns
        -------
        ndarray (L + 1,) of float64
        """
        squares = (self._table**2).sum(axis=1)
        return np.add.reduceat(squares, np.arange(self.degree + 1) ** 2)

    def filtered(self, factors: npt.ArrayLike) -> Harmonics:
        """Multiplies every degree by a factor: decreasing factors smooth, factors above 1 sharpen.

        Parameters
        ----------
        factors : array_like (k,) of float
            Factors of the degrees 0 ... k - 1. The degree of the result is k - 1, or that of these functions if it is less.

        Returns
        -------
        Harmonics
        """
        given = doubles("factors", factors)
        if given.ndim != 1 or given.size == 0:
            raise ValueError(f"factors: shape (k,) is needed, not {given.shape}")
        degree = min(len(given) - 1, self.degree)
        per_row = np.repeat(given[: degree + 1], 2 * np.arange(degree + 1) + 1)
        return self._with(self._table[: (degree + 1) ** 2] * per_row[:, None])

    def rotated(self, rotation: npt.ArrayLike) -> Harmonics:
        """The rotated functions: the value at x is moved to R x.

        Parameters
        ----------
        rotation : array_like (3, 3) of float
            R, orthogonal, of determinant 1.

        Returns
        -------
        Harmonics
        """
        matrix = vectors("rotation", rotation, 3)
        if not (np.allclose(matrix @ matrix.T, np.eye(3), rtol=0, atol=1e-6) and np.linalg.det(matrix) > 0):
            raise ValueError("rotation: an orthogonal matrix of determinant 1 is needed")
        return self._with(_core.rotated_harmonics(self._table, matrix))

    def best_rotation(self, other: Harmonics, *, policy: str = "parallel") -> Doubles:
        """The rotation R for which the correlation of these functions with `other.rotated(R)` is the largest of all.

        Parameters
        ----------
        other : Harmonics
            The same number of functions.
        policy : {"parallel", "sequential"}

        Returns
        -------
        ndarray (3, 3) of float64
        """
        check(Harmonics.best_rotation, locals())
        if _of(other)._table.shape[1] != self._table.shape[1]:
            raise ValueError(f"other: {self._table.shape[1]} functions are needed, not {other._table.shape[1]}")
        return np.array(_core.best_rotation(self._table, other._table, policy))

    def best_alignment(self, other: Harmonics, *, policy: str = "parallel") -> ShapeAlignment:
        """The best alignment of another shape with this one, for any rotation of the shape in space and of its map.

        Parameters
        ----------
        other : Harmonics
            Both must have three functions, of degree 1 or more.
        policy : {"parallel", "sequential"}

        Returns
        -------
        ShapeAlignment
        """
        check(Harmonics.best_alignment, locals())
        for shape in (self, _of(other)):
            shape._check_shape()
        space, sphere, correlation = _core.best_alignment(self._table, other._table, policy)
        return ShapeAlignment(np.array(space), np.array(sphere), correlation)

    def mirrored(self) -> Harmonics:
        """The mirror image of a shape in the plane z = 0; its map is mirrored, too.

        Returns
        -------
        Harmonics
        """
        self._check_shape()
        return Harmonics(_core.mirrored(self._table))

    def _check_shape(self) -> None:
        if self._table.shape[1] != 3 or self.degree < 1:
            raise ValueError("a shape is three functions of degree 1 or more")

    def ellipsoid(self) -> Ellipsoid:
        """The first-order ellipsoid of a shape, of three functions.

        Returns
        -------
        Ellipsoid
        """
        self._check_shape()
        return Ellipsoid(*(np.array(part) for part in _core.first_order_ellipsoid(self._table)))

    def aligned(self) -> Harmonics:
        """The shape moved to the position of its first-order ellipsoid, so that shapes in any position can be compared.

        Returns
        -------
        Harmonics
        """
        ellipsoid = self.ellipsoid()
        moved = self._table @ ellipsoid.axes.T
        moved[0] = 0
        return Harmonics(moved).rotated(ellipsoid.sphere_axes)

    def to_pyshtools(self) -> Doubles:
        """The coefficients in the format of pyshtools with `normalization="ortho", csphase=1`.

        Returns
        -------
        ndarray (2, L + 1, L + 1) or (d, 2, L + 1, L + 1) of float64
        """
        result = np.zeros((self._table.shape[1], 2, self.degree + 1, self.degree + 1))
        for l in range(self.degree + 1):  # noqa: E741
            row = l * l + l
            result[:, 0, l, : l + 1] = self._table[row : row + l + 1].T
            result[:, 1, l, 1 : l + 1] = self._table[row - l : row][::-1].T
        return result.reshape((*self.coefficients.shape[1:], *result.shape[1:]))

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the coefficients to a file: .csv, .json or, for three functions, .coef (SPHARM-PDM), also with .gz behind.

        Parameters
        ----------
        file : path
            It is complete, or does not exist.

        Raises
        ------
        ValueError
            For another extension, or if the file is for three functions and there is another number.
        """
        extension = _format_of(file)
        if extension == "coef" and self._table.shape[1] != 3:
            raise ValueError(f"a .coef file has the coefficients of three functions, not of {self._table.shape[1]}")
        _core.write_text(file_name("file", file), _core.harmonics_to_text(self._table, extension))


def _of(other: object) -> Harmonics:
    if not isinstance(other, Harmonics):
        raise wrong_type("other", "Harmonics", other)
    return other


def _format_of(file: str | os.PathLike[str]) -> str:
    extension = Path(os.fsdecode(_core.without_compression(file_name("file", file)))).suffix[1:].lower()
    one_of("extension", extension, "csv", "json", "coef")
    return extension


def read_harmonics(file: str | os.PathLike[str]) -> Harmonics:
    """Reads coefficients that `Harmonics.save()`, the tool or SPHARM-PDM has written.

    Parameters
    ----------
    file : path
        .csv, .json or .coef, also compressed

    Returns
    -------
    Harmonics
        The shape of the coefficients is ((L + 1)**2, d).

    Raises
    ------
    OSError
        If the file cannot be read.
    ValueError
        If the file is not of this kind.
    """
    extension = _format_of(file)
    os.stat(file)  # FileNotFoundError
    text = _core.read_text(file_name("file", file))
    try:
        return Harmonics(_core.harmonics_of_text(text, extension))
    except RuntimeError as error:  # without a message where that quotes bytes that are no UTF-8
        wrong = str(error) or "no file of harmonic coefficients"
        raise ValueError(f"{os.fsdecode(file)}: {wrong}") from None


def harmonics(
    triangles: npt.ArrayLike, sphere: Sphere, values: npt.ArrayLike, degree: int, *, fit: str = "least-squares",
    weights: str = "sphere-area", points: npt.ArrayLike | None = None, accuracy: float = 1e-10, iterations: int = 500,
    policy: str = "parallel",
) -> Harmonics:
    """Expands data at the vertices in spherical harmonics. With the points of a mesh as data, this is SPHARM.

    Parameters
    ----------
    triangles : array_like (m, 3) of int
    sphere : array_like (n, 3) of float
        A valid map; maps by `Isometric` need the fewest degrees.
    values : array_like (n,) or (n, d) of float
        Data, such as the points.
    degree : int
        Each column has (degree + 1)**2 coefficients.
    fit : {"least-squares", "integrals"}
        Least squares at the vertices, which need as many vertices as coefficients; or integrals over the faces, on which
        the data are interpolated linearly.
    weights : {"sphere-area", "surface-area", "equal"}
        Weights of the vertices in least squares.
    points : array_like (n, 3) of float
        Needed for "surface-area".
    accuracy : float
        Least squares stop when the gradient has fallen by this factor; for integrals, the accuracy of the quadrature.
    iterations : int
        Maximum number of iterations of least squares.
    policy : {"parallel", "sequential"}

    Returns
    -------
    Harmonics

    Raises
    ------
    MeshError
        If a number is not finite, a vector of the sphere is zero, or the map is not valid.
    """
    check(harmonics, locals())
    one_of("fit", fit, "least-squares", "integrals")
    one_of("weights", weights, "sphere-area", "surface-area", "equal")
    images = sphere_vectors("sphere", sphere)
    data = doubles("values", values)
    if data.ndim not in (1, 2) or len(data) != len(images):
        raise ValueError(f"values: shape ({len(images)},) or ({len(images)}, d) is needed, not {data.shape}")
    if fit == "least-squares" and (degree + 1) ** 2 > len(images):
        raise ValueError(
            f"degree {degree}: least squares need {(degree + 1) ** 2} vertices, and there are {len(images)}; "
            'take a smaller degree, or fit="integrals"'
        )
    if not accuracy > 0:
        raise ValueError("accuracy: a positive number is needed")
    if weights == "surface-area" and points is None:
        raise ValueError('weights="surface-area" needs points')
    table = np.ascontiguousarray(data.reshape(len(data), -1))
    coefficients, has_converged, count = _core.harmonic_analysis(
        index_triples(triangles), images, table, degree, fit, weights,
        None if points is None else vectors("points", points, len(images)), accuracy, iterations, policy,
    )
    return Harmonics(coefficients.reshape((len(coefficients), *data.shape[1:])), has_converged, count)
