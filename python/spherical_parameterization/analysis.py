# SPDX-License-Identifier: LGPL-3.0-or-later
"""What is done with a map: distortion, segments, textures, the inverse map, shape search."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, Integers, OneLine, Sphere, check, check_indices, chosen, doubles, index_triples, integers
from .arrays import numbers, one_of, sphere_vectors, unit_vectors, vectors, wrong_type
from .errors import ErrorCode
from .maps import map_to_go_on
from .methods import SEGMENTATIONS, Balanced, MajorityVote, Segmentation


def _mesh(points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere) -> tuple[Doubles, Integers, Doubles]:
    points = vectors("points", points)
    return points, index_triples(triangles), unit_vectors("sphere", sphere, len(points))


@dataclass(frozen=True)
class Distribution:
    """Distribution of a measure over the surface. Faces are weighted by their source area."""

    mean: float
    deviation: float  #: root of the mean square difference from the mean
    min: float
    percentile_1: float
    percentile_5: float
    median: float
    percentile_95: float
    percentile_99: float
    max: float


@dataclass(frozen=True, repr=False)
class DistortionSummary:
    """The distortion of a map in figures."""

    log_area_stretch: Distribution  #: log((source area / its total) / (spherical area / 4 pi)); 0 is none; NaN where faces are flipped
    angle_distortion: Distribution  #: radians; 0 is none
    dilatation: Distribution  #: quasi-conformal dilatation, the ratio of the principal stretches; 1 is none
    symmetric_dirichlet: Distribution  #: symmetric Dirichlet energy between flat triangles; 4 is isometric
    spherical_symmetric_dirichlet: Distribution  #: the same with det(a, b, c) / 2 as area on the sphere
    degenerate_faces: int  #: number of source faces of area 0, which are ignored

    def __repr__(self) -> str:
        means = (f"{field.name} {getattr(self, field.name).mean:.4g}" for field in fields(self)[:-1])
        return f"<DistortionSummary: means of {', '.join(means)}>"

    def __str__(self) -> str:
        rows = [f"{'':30s}{'mean':>12s}{'median':>12s}{'95 %':>12s}{'max':>12s}"]
        for field in fields(self)[:-1]:
            d = getattr(self, field.name)
            rows.append(f"{field.name:30s}{d.mean:12.4g}{d.median:12.4g}{d.percentile_95:12.4g}{d.max:12.4g}")
        return "\n".join(rows)


def distortion(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere, *, policy: str = "parallel"
) -> DistortionSummary:
    """Summary of the distortion of a valid map.

    Parameters
    ----------
    points : array_like (n, 3) of float
    triangles : array_like (m, 3) of int
    sphere : array_like (n, 3) of float, or Result
        Its radius may be any: only directions are used.
    policy : {"parallel", "sequential"}

    Returns
    -------
    DistortionSummary

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> points, triangles = sp.icosphere(3)
    >>> summary = sp.distortion(points, triangles, points)
    >>> round(summary.symmetric_dirichlet.mean, 6), round(summary.dilatation.max, 6)
    (4.0, 1.0)
    """
    check(distortion, locals())
    summary = _core.distortion_summary(*_mesh(points, triangles, sphere), policy)
    area, angle, dilatation, flat, spherical = (Distribution(*d) for d in summary[:-1])
    return DistortionSummary(area, angle, dilatation, flat, spherical, summary[-1])


def face_distortion(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere, measure: str = "log_area_stretch", *,
    policy: str = "parallel",
) -> Doubles:
    """The distortion of every face.

    Parameters
    ----------
    points, triangles, sphere, policy
        As for `distortion()`.
    measure : {"log_area_stretch", "angle_distortion", "dilatation", "symmetric_dirichlet"}
        See `DistortionSummary`.

    Returns
    -------
    ndarray (m,) of float64
    """
    check(face_distortion, locals())
    one_of("measure", measure, "log_area_stretch", "angle_distortion", "dilatation", "symmetric_dirichlet")
    return _core.face_distortion(*_mesh(points, triangles, sphere), measure, policy)


@dataclass(frozen=True, eq=False, repr=False)
class LengthChanges(OneLine):
    """How many times lengths become longer or shorter from a surface to another one, at least 1."""

    of_faces: Doubles  #: (m,), in the direction in which they change most; 1 for faces of area 0
    factor: Distribution  #: of these values
    share_of_large: float  #: of the area, on which they are more than 3: what corresponds is squeezed or stretched


def length_changes(
    points: npt.ArrayLike, triangles: npt.ArrayLike, other_points: npt.ArrayLike, *, policy: str = "parallel"
) -> LengthChanges:
    """The changes of lengths from a mesh to corresponding points, such as those on another shape that `register_maps()` finds.

    They are max(s, 1 / t) of the principal stretches s >= t of each face, both surfaces scaled to the same area.

    Parameters
    ----------
    points, other_points : array_like (n, 3) of float
        The points of the mesh, and those that correspond to them.
    triangles : array_like (m, 3) of int
    policy : {"parallel", "sequential"}

    Returns
    -------
    LengthChanges

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> points, triangles = sp.icosphere(3)
    >>> changes = sp.length_changes(points, triangles, 5 * points)
    >>> round(changes.factor.max, 6), changes.share_of_large
    (1.0, 0.0)
    """
    check(length_changes, locals())
    points, other_points = vectors("points", points), vectors("other_points", other_points)
    if len(other_points) != len(points):
        raise ValueError(f"other_points: as many as points are needed, not {len(other_points)} for {len(points)}")
    if not np.isfinite(other_points).all():
        raise ValueError("other_points: all have to be finite")
    of_faces, factor, share = _core.length_changes(points, index_triples(triangles), other_points, policy)
    return LengthChanges(of_faces, Distribution(*factor), share)


def _surface(triangles: npt.ArrayLike) -> tuple[Doubles, Integers]:
    """What the core takes for a mesh of which the points do not matter."""
    triangles = index_triples(triangles)
    number_of_points = min(int(triangles.max(initial=-1)) + 1, triangles.size)  # a larger number is BAD_INDEX
    return np.zeros((number_of_points, 3)), triangles


def mean_over_faces(triangles: npt.ArrayLike, values: npt.ArrayLike) -> Doubles:
    """Values of faces as values of vertices: the mean over the faces of a vertex.

    Parameters
    ----------
    triangles : array_like (m, 3) of int
    values : array_like (m,) of float

    Returns
    -------
    ndarray (n,) of float64

    Raises
    ------
    MeshError
        If the triangles do not form a closed surface of genus 0.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sp.mean_over_faces([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], [0, 3, 6, 9])
    array([4., 3., 5., 6.])
    """
    points, triangles = _surface(triangles)
    return _core.mean_over_faces(points, triangles, numbers("values", values, len(triangles)))


def vertex_log_area_stretch(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere, *, policy: str = "parallel"
) -> Doubles:
    """The logarithmic area stretch of the vertices (means over their faces). It is positive where the map shrinks.

    Parameters
    ----------
    points, triangles, sphere, policy
        As for `distortion()`.

    Returns
    -------
    ndarray (n,) of float64
    """
    check(vertex_log_area_stretch, locals())
    return _core.vertex_log_area_stretch(*_mesh(points, triangles, sphere), policy)


def segment(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere, method: Segmentation = MajorityVote(), *,
    stretch: npt.ArrayLike | None = None, policy: str = "parallel",
) -> npt.NDArray[np.int32]:
    """Cuts a shape into body and limbs.

    Parameters
    ----------
    points, triangles, policy
        As for `distortion()`.
    sphere : array_like (n, 3) of float
        A conformal map; it need not be valid.
    method : MajorityVote, GirthProfiles or RegionGrowing, or "majority-vote", "girth-profiles" or "region-growing"
    stretch : array_like (m,) of float
        Logarithmic area stretch of the faces. Default: `face_distortion()`.

    Returns
    -------
    ndarray (m,) of int32
        The segment of every face, numbered from 0. Every segment is connected.

    Raises
    ------
    MeshError
        If something is wrong with the mesh or the map.
    KeyboardInterrupt
        After Ctrl-C, within a fraction of a second. Other Python threads run during the call.
    """
    check(segment, locals())
    points, triangles, sphere = _mesh(points, triangles, sphere)
    given = None if stretch is None else numbers("stretch", stretch, len(triangles))
    return _core.segment(points, triangles, sphere, chosen("method", method, SEGMENTATIONS), given, policy)


@dataclass(frozen=True, eq=False, repr=False)
class Texture(OneLine):
    """Texture coordinates, and counts of faces with special treatment."""

    uv: Doubles  #: (m, 3, 2): u and v of every corner of every face
    north: list[float]  #: the direction at v = 1, or at the centre of the octahedral square
    meridian: list[float]  #: the direction of longitude 0
    seam_faces: int  #: number of faces with a corner beyond the side of the square
    pole_faces: int  #: number of faces around a pole, or with a corner at a pole
    moved_faces: int  #: number of faces with a corner that was moved so that they are not flipped in the plane
    unresolved_faces: int  #: number of those that are too small for the grid
    largest_move: float  #: largest distance of a move, in units of u and v


def texture_coordinates(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere, *,
    chart: str = "latitude-longitude", axes: tuple[Sequence[float], Sequence[float]] | None = None,
    bits: int = 52, policy: str = "parallel",
) -> Texture:
    """Texture coordinates for every corner; no triangle is flipped or degenerate in the plane.

    Parameters
    ----------
    points, triangles, sphere, policy
        As for `distortion()`.
    chart : {"latitude-longitude", "octahedral"}
    axes : pair of three floats
        The directions of the north pole and of longitude 0. Default: those for which the texture is least distorted.
    bits : int
        Coordinates are multiples of 2^-bits, 1 to 52. With 23 they are float32 without further rounding.

    Returns
    -------
    Texture

    Raises
    ------
    MeshError
        If the map has flipped faces.
    KeyboardInterrupt
        After Ctrl-C, within a fraction of a second. Other Python threads run during the call.
    """
    check(texture_coordinates, locals())
    one_of("chart", chart, "latitude-longitude", "octahedral")
    if axes is not None:
        axes = vectors("axes", axes, 2).tolist()
    return Texture(*_core.texture_coordinates(*_mesh(points, triangles, sphere), chart, axes, bits, policy))


def texture_seams(triangles: npt.ArrayLike, uv: npt.ArrayLike) -> npt.NDArray[np.int32]:
    """The edges along which a texture is cut: their two faces have different coordinates at one of the end points.

    Parameters
    ----------
    triangles : array_like (m, 3) of int
    uv : array_like (m, 3, 2) of float
        u and v of every corner, as `texture_coordinates()` returns them.

    Returns
    -------
    ndarray (k, 2) of int32
        The vertices of the edges, the smaller index first, sorted. `numpy.unique()` of them are the vertices to duplicate.

    Raises
    ------
    MeshError
        If the triangles do not form a closed surface of genus 0.
    """
    points, triangles = _surface(triangles)
    corners = doubles("uv", uv)
    if corners.shape != (len(triangles), 3, 2):
        raise ValueError(f"uv: shape ({len(triangles)}, 3, 2) is needed, not {corners.shape}")
    return _core.texture_seams(points, triangles, corners)


def icosphere(level: int) -> tuple[Doubles, npt.NDArray[np.int32]]:
    """An icosahedron on the unit sphere, with every triangle cut in four `level` times.

    Parameters
    ----------
    level : int
        0 to 12.

    Returns
    -------
    points : ndarray (10 * 4**level + 2, 3) of float64
    triangles : ndarray (20 * 4**level, 3) of int32
    """
    check(icosphere, locals())
    return _core.icosphere(level)


class Resampling:
    """Weights for resampling values from the vertices of one mesh to those of another: a sparse matrix, stored by rows.

    `scipy.sparse.csr_array((weights, vertices, offsets))` is the matrix.

    Attributes
    ----------
    offsets : ndarray (k + 1,) of int64
        The beginning of every row, and the end of the last one.
    vertices : ndarray of int32
    weights : ndarray of float64
        Positive, of sum 1 in every row.
    """

    def __init__(self, weights: Any, number_of_vertices: int) -> None:
        self._weights, self._size = weights, number_of_vertices
        self.offsets, self.vertices, self.weights = weights.rows()

    def __repr__(self) -> str:
        return f"<Resampling: {len(self.offsets) - 1} vertices from {self._size}>"

    def means(self, values: npt.ArrayLike) -> Doubles:
        """Weighted means. Constant values stay constant.

        Parameters
        ----------
        values : array_like (n,) or (n, d) of float

        Returns
        -------
        ndarray (k,) or (k, d) of float64
        """
        given = _rows("values", doubles("values", values), self._size)
        means = self._weights.means(np.ascontiguousarray(given.reshape(len(given), -1)))
        return means.reshape(len(means), *given.shape[1:])

    def majorities(self, labels: npt.ArrayLike) -> Any:
        """The label with the largest sum of weights.

        Parameters
        ----------
        labels : array_like (n,)
            Labels of any type that can be sorted.

        Returns
        -------
        ndarray (k,)
        """
        kinds, number = np.unique(_column("labels", labels, self._size), return_inverse=True)
        return kinds[self._weights.majorities(number)]

    def nearest(self, labels: npt.ArrayLike) -> Any:
        """The label of the vertex with the largest weight.

        Parameters
        ----------
        labels : array_like (n, ...)
            Labels of any type.

        Returns
        -------
        ndarray (k, ...)
        """
        return _rows("labels", labels, self._size)[self._weights.nearest(range(self._size))]


def _rows(name: str, values: object, size: int) -> npt.NDArray[Any]:
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{name}: {error}") from None
    if array.shape[:1] != (size,):
        raise ValueError(f"{name}: {size} rows are needed, not {array.shape}")
    return array


def _column(name: str, values: object, size: int) -> npt.NDArray[Any]:
    array = _rows(name, values, size)
    if array.ndim != 1:
        raise ValueError(f"{name}: shape ({size},) is needed, not {array.shape}")
    return array


class Locator:
    """The inverse of a map: finds the point of the mesh that is mapped to a direction.

    Parameters
    ----------
    triangles : array_like (m, 3) of int
    sphere : array_like (n, 3) of float
        A valid map.
    policy : {"parallel", "sequential"}
        Policy of the constructor and of all methods.

    Raises
    ------
    MeshError
        If the map is not valid.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(2)
    >>> locator = sp.Locator(triangles, sphere)
    >>> locator.transfer(sphere, [[0, 0, 1]]).round(6).tolist()
    [[0.0, 0.0, 1.0]]
    """

    def __init__(self, triangles: npt.ArrayLike, sphere: Sphere, *, policy: str = "parallel") -> None:
        check(Locator.__init__, locals())
        sphere, triangles = unit_vectors("sphere", sphere).copy(), index_triples(triangles).copy()  # callers may change them
        self._number_of_vertices, self._triangles, self._policy = len(sphere), triangles, policy
        self._sphere = sphere
        self._locator = _core.Locator(triangles, sphere, policy)

    def __repr__(self) -> str:
        return f"<Locator: {self._number_of_vertices} vertices, {len(self._triangles)} faces>"

    def __reduce__(self) -> Any:  # the core's object is made again
        return functools.partial(Locator, policy=self._policy), (self._triangles, self._sphere)

    def locate(self, directions: Sphere) -> tuple[npt.NDArray[np.int32], Doubles]:
        """The faces whose images contain the directions.

        Parameters
        ----------
        directions : array_like (k, 3) of float
            Vectors of any length except 0, or a `Result`.

        Returns
        -------
        faces : ndarray (k,) of int32
        weights : ndarray (k, 3) of float64
            Barycentric coordinates in the faces.
        """
        return self._locator.locate(sphere_vectors("directions", directions), self._policy)

    def interpolate(self, values: npt.ArrayLike, faces: npt.ArrayLike, weights: npt.ArrayLike) -> Doubles:
        """Interpolates values of vertices at points in faces.

        Parameters
        ----------
        values : array_like (n,) or (n, d) of float
        faces, weights
            The result of `locate()`.

        Returns
        -------
        ndarray (k,) or (k, d) of float64
        """
        given = _rows("values", doubles("values", values), self._number_of_vertices)
        table = np.ascontiguousarray(given.reshape(len(given), -1))
        places = integers("faces", faces)
        if places.ndim != 1:
            raise ValueError(f"faces: a list of numbers is needed, not {places.shape}")
        if places.size and not 0 <= places.min() <= places.max() < len(self._triangles):
            raise IndexError(f"faces are numbers from 0 to {len(self._triangles) - 1}")
        result = self._locator.interpolate(table, np.ascontiguousarray(places, dtype=np.int32), vectors("weights", weights, len(places)))
        return result.reshape((len(places), *given.shape[1:]))

    def transfer(self, values: npt.ArrayLike, directions: Sphere, *, nearest: bool = False) -> Any:
        """Interpolates values of vertices at directions, such as those of another map: `locate()` and `interpolate()`.

        Parameters
        ----------
        values : array_like (n,) or (n, d)
            Numbers; with `nearest`, values of any type.
        directions : array_like (k, 3) of float
            Vectors of any length except 0, or a `Result`.
        nearest : bool
            Takes the value of the corner with the largest weight instead of interpolating: for labels.

        Returns
        -------
        ndarray (k,) or (k, d)
            float64, or with `nearest` the type of the values.
        """
        check(Locator.transfer, locals())
        faces, weights = self.locate(directions)
        if not nearest:
            return self.interpolate(values, faces, weights)
        of_vertices = _rows("values", values, self._number_of_vertices)
        return of_vertices[self._triangles[faces, weights.argmax(axis=1)]]

    def linear_resampling(self, directions: Sphere) -> Resampling:
        """Barycentric weights at directions, such as the vertices of a template's sphere.

        Parameters
        ----------
        directions : array_like (k, 3) of float
            Vectors of any length except 0, or a `Result`.

        Returns
        -------
        Resampling
        """
        weights = self._locator.linear_resampling(sphere_vectors("directions", directions), self._policy)
        return Resampling(weights, self._number_of_vertices)

    def area_preserving_resampling(
        self, areas: npt.ArrayLike, other: Locator, other_areas: npt.ArrayLike
    ) -> Resampling:
        """Weights that preserve areas and skip no vertex: ADAP_BARY_AREA of wb_command.

        Parameters
        ----------
        areas : array_like (n,) of float
            Areas of the vertices on the surface, such as `mean_vertex_areas([points], triangles)`.
        other : Locator
            The map of the mesh that gets the values, in the same position.
        other_areas : array_like (k,) of float
            Areas of the vertices of that mesh.

        Returns
        -------
        Resampling
            Weights from the vertices of this mesh to those of the other one.
        """
        if not isinstance(other, Locator):
            raise wrong_type("other", "a Locator", other)
        of_both = []
        for name, given, locator in (("areas", areas, self), ("other_areas", other_areas, other)):
            of_both.append(numbers(name, given, locator._number_of_vertices))
            if not (np.isfinite(of_both[-1]) & (of_both[-1] >= 0)).all():
                raise ValueError(f"{name}: finite numbers that are not negative are needed")
        weights = self._locator.area_preserving_resampling(
            self._sphere, of_both[0], other._locator, other._sphere, of_both[1], self._policy
        )
        return Resampling(weights, self._number_of_vertices)

    def transfer_faces(self, values: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere) -> Any:
        """Transfers values of faces, such as labels, to another mesh: each face gets the value of the face at its centre.

        Parameters
        ----------
        values : array_like (m, ...)
            Values of the faces of this mesh, of any type.
        triangles : array_like (k, 3) of int
            The triangles of the other mesh.
        sphere : array_like (l, 3) of float
            A map of the other mesh in the same position, see `align()`.

        Returns
        -------
        ndarray (k, ...)
        """
        of_faces = _rows("values", values, len(self._triangles))
        images, corners = unit_vectors("sphere", sphere), index_triples(triangles)
        check_indices(corners, len(images))
        a, b, c = images[corners].swapaxes(0, 1)
        return of_faces[self.locate(a + (b + c))[0]]

    def transfer_segment_labels(
        self, labels: npt.ArrayLike, points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere,
        segments: npt.ArrayLike,
    ) -> Any:
        """Gives each segment of another mesh the label that the largest share of its area has here.

        Parameters
        ----------
        labels : array_like (m,)
            Labels of the faces of this mesh, of any type that can be sorted.
        points : array_like (l, 3) of float
            The points of the other mesh.
        triangles : array_like (k, 3) of int
        sphere : array_like (l, 3) of float
            A map of the other mesh in the same position, such as a registered one, see `register_maps()`.
        segments : array_like (k,) of int
            The segments of the faces of the other mesh, see `segment()`.

        Returns
        -------
        ndarray (k,)
        """
        names, numbered = np.unique(_column("labels", labels, len(self._triangles)), return_inverse=True)
        points, triangles, sphere = _mesh(points, triangles, sphere)
        given = _column("segments", integers("segments", segments), len(triangles))
        of_faces = np.unique(given, return_inverse=True)[1]  # any integers as those of int32
        found = self._locator.transfer_segment_labels(
            numbered.astype(np.int32), points, triangles, sphere, of_faces.astype(np.int32), self._policy
        )
        return names[found]

    def resample(self, points: npt.ArrayLike, level: int) -> tuple[Doubles, npt.NDArray[np.int32], Doubles]:
        """Samples the shape at the vertices of an icosphere.

        Parameters
        ----------
        points : array_like (n, 3) of float
        level : int
            The level of `icosphere()`.

        Returns
        -------
        points : ndarray (k, 3) of float64
        triangles : ndarray of int32
        sphere : ndarray (k, 3) of float64
            The vertices of the icosphere, which are a map of the new mesh.
        """
        sphere, triangles = icosphere(level)
        return self.transfer(vectors("points", points, self._number_of_vertices), sphere), triangles, sphere

    def align(self, points: npt.ArrayLike, other: Locator, other_points: npt.ArrayLike) -> Doubles:
        """The rotation of the sphere from this map to another one. The shapes must have the same orientation in space.

        Parameters
        ----------
        points : array_like (n, 3) of float
            The points of this mesh.
        other : Locator
        other_points : array_like of float
            The points of the other mesh.

        Returns
        -------
        ndarray (3, 3) of float64
            R such that x in this map corresponds to R x in the other map: `other.transfer(values, x @ R.T)`.
        """
        if not isinstance(other, Locator):
            raise wrong_type("other", "a Locator", other)
        here = vectors("points", points, self._number_of_vertices)
        there = vectors("other_points", other_points, other._number_of_vertices)
        return np.array(self._locator.align(here, other._locator, there, self._policy))


def shape_signature(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere | None = None, *, policy: str = "parallel",
) -> Doubles:
    """The signature of a shape, 96 numbers that are similar for all poses of the shape; see `search()`.

    Parameters
    ----------
    points, triangles, policy
        As for `distortion()`.
    sphere : array_like (n, 3) of float
        A conformal map by `Balanced`; it need not be valid. Default: a new map with clamped weights or, if it does
        not converge, with barycentric weights.

    Returns
    -------
    ndarray (96,) of float64

    Raises
    ------
    MeshError
        If something is wrong with the mesh, or the map has no area.
    KeyboardInterrupt
        After Ctrl-C. Other Python threads run during the call.
    """
    check(shape_signature, locals())
    if sphere is None:
        result = map_to_go_on(points, triangles, Balanced(), weights="clamped", policy=policy, warn=False)
        if result.error is ErrorCode.NOT_CONVERGED or (not result and result.degree != 1):
            result = map_to_go_on(points, triangles, Balanced(), weights="barycentric", policy=policy, warn=False) or result
        sphere = result.sphere
    return _core.shape_signature(*_mesh(points, triangles, sphere), policy)


def shape_form(points: npt.ArrayLike, triangles: npt.ArrayLike) -> Doubles:
    """The form of a shape in its pose, 112 numbers for things that differ less in girths and limbs than in form; see `relevance()`.

    Parameters
    ----------
    points, triangles
        As for `distortion()`.

    Returns
    -------
    ndarray (112,) of float64
        Histograms of points that are spread evenly over the surface, single precision: of the distances of pairs and the angles of their
        normals (64), and of the distances from the centre and the angles between normal and radius (48).
    """
    return _core.shape_form(vectors("points", points), index_triples(triangles))


def relevance(signatures: npt.ArrayLike, forms: npt.ArrayLike) -> Doubles:
    """How relevant shapes are to the first one of them: by girths, limbs and form, and by chains of similar shapes among them.

    Zhou, Weston, Gretton, Bousquet, Schölkopf, "Ranking on data manifolds", NIPS 2003. A class should have six members or more. The time
    grows with the cube of the number of shapes (0.1 s for 500): call it with the nearest ones by `search()`.

    Parameters
    ----------
    signatures : array_like (s, 96) of float
        By `shape_signature()`; the first row is the query.
    forms : array_like (s, 112) of float
        By `shape_form()`.

    Returns
    -------
    ndarray (s,) of float64
        From 0 (no chain leads there) to 1 (the query).
    """
    rows = doubles("signatures", signatures), doubles("forms", forms)
    for name, array, width in zip(("signatures", "forms"), rows, (96, 112)):
        if array.ndim != 2 or array.shape[0] == 0 or array.shape[1] != width:
            raise ValueError(f"{name}: shape (s, {width}) is needed, s 1 or more, not {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError(f"{name}: all have to be finite")
    if len(rows[0]) != len(rows[1]):
        raise ValueError(f"forms: {len(rows[0])} rows are needed, as many as signatures, not {len(rows[1])}")
    return np.array(_core.relevance(*rows))


def search(signature: npt.ArrayLike, index: npt.ArrayLike, k: int = 10) -> tuple[npt.NDArray[np.intp], Doubles]:
    """The nearest of many signatures, by L1 distance. Typical distances are 0.2 between poses of one shape, and 2 between shapes.

    Parameters
    ----------
    signature : array_like (96,) of float
    index : array_like (s, 96) of float
    k : int
        The number of results.

    Returns
    -------
    numbers : ndarray of int
        Rows of `index`, nearest first.
    distances : ndarray of float64
    """
    check(search, locals())
    rows = doubles("index", index)
    if rows.size == 0:
        raise ValueError("index: one signature or more is needed")
    if rows.ndim != 2 or rows.shape[1] != 96:
        raise ValueError(f"index: shape (s, 96) is needed, not {rows.shape}")
    distances = _core.distances(numbers("signature", signature, 96), rows)
    nearest = np.argsort(distances, kind="stable")[:k]
    return nearest, distances[nearest]


def stretch_histogram(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere, *,
    sampling: str = "exact-areas", scale: str = "logarithmic", bins: int = 32, low: float = -4, high: float = 28,
    number_of_samples: int = 4096, seed: int = 0, policy: str = "parallel",
) -> Doubles:
    """The published shape signature: the histogram of the area stretch. See `shape_signature()` for a better one.

    Parameters
    ----------
    points, triangles, sphere, policy
        As for `distortion()`.
    sampling : {"exact-areas", "uniform", "random", "vertices"}
    scale : {"logarithmic", "linear"}
    bins : int
    low, high : float
        The beginning of the first bin and the end of the last one, on the scale.
    number_of_samples, seed : int
        For "uniform" and "random" sampling.

    Returns
    -------
    ndarray (bins,) of float64
        Shares, which add up to 1.
    """
    check(stretch_histogram, locals())
    one_of("sampling", sampling, "exact-areas", "uniform", "random", "vertices")
    one_of("scale", scale, "logarithmic", "linear")
    for name, value in (("low", low), ("high", high)):
        if not np.isfinite(value):
            raise ValueError(f"{name}: a finite number is needed, not {value}")
    shares = _core.stretch_histogram(
        *_mesh(points, triangles, sphere), sampling, scale, bins, low, high, number_of_samples, seed, policy
    )
    return np.array(shares)
