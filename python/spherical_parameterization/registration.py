# SPDX-License-Identifier: LGPL-3.0-or-later
"""Registration: corresponding points of two shapes."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, OneLine, Sphere, check, doubles, index_triples, integers, numbers, one_of
from .arrays import sphere_vectors, vectors
from .errors import MapWarning
from .maps import callback_of


@dataclass(frozen=True, eq=False, repr=False)
class RegisteredMap(OneLine):
    """A registered map: corresponding points of its mesh and of another mesh have the same image. It is certified."""

    sphere: Doubles  #: (n, 3), the registered map of the first mesh
    is_complete: bool  #: False if `progress` or the time limit has ended the registration
    start: str  #: the start: "spectrum", or a rotation by "landmarks", "coordinates" or "features"
    margin: float  #: how much worse the best other candidate is, as a logarithm: from -0.1, if its map fits worse, to infinity, if there is none
    signature_difference: float  #: mean difference of the signatures of corresponding points, from 0 to 1; about 0.03 between poses of one body
    trust: str  #: the verdict from margin, signature_difference and stretching: "sure", "unsure", "unlike" (shapes), or "unknown" without the spectrum
    rotation: Doubles  #: (3, 3), the rotation of the first map at the start
    mismatch_before: float  #: root of the sum of the mean squared differences of the features on the finest level, each times its weight, after the rotation
    mismatch: float  #: the same at the end
    stretching: float  #: mean stretching of the surface onto the other one: 4 is an isometry; 0 if not deformed
    distortion: float  #: mean symmetric Dirichlet energy of the deformation of the sphere; 4 is none
    largest_landmark_distance: float  #: largest distance of two corresponding landmarks on the sphere, in radians
    iterations: int  #: iterations of all levels together
    seconds: float  #: wall-clock time

    def __repr__(self) -> str:
        state = "valid" if self.is_complete else "valid, not complete"
        return f"<RegisteredMap: {state}, {len(self.sphere)} vertices, correspondence {self.trust}>"


def _features(
    features: npt.ArrayLike | None, other_features: npt.ArrayLike | None, weight: npt.ArrayLike, sizes: tuple[int, int]
) -> list[tuple[Doubles, Doubles, float]]:
    tables = []
    for name, given, size in zip(("features", "other_features"), (features, other_features), sizes):
        table = doubles(name, np.empty((size, 0)) if given is None else given)
        if table.ndim not in (1, 2) or len(table) != size:
            raise ValueError(f"{name}: shape ({size},) or ({size}, k) is needed, not {table.shape}")
        tables.append(table.reshape(size, -1).T if table.size else np.empty((0, size)))
    if len(tables[0]) != len(tables[1]):
        raise ValueError(f"features, other_features: as many are needed, not {len(tables[0])} and {len(tables[1])}")
    weights = doubles("feature_weight", weight)
    if weights.shape not in ((), tables[0].shape[:1]) or not (np.isfinite(weights) & (weights >= 0)).all():
        raise ValueError(f"feature_weight: numbers from 0 on are needed, one or {len(tables[0])}, not {weight!r}")
    return [(x, y, float(w)) for x, y, w in zip(*tables, np.broadcast_to(weights, len(tables[0])))]


def register_maps(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere,
    other_points: npt.ArrayLike, other_triangles: npt.ArrayLike, other_sphere: Sphere, *, motion: str = "deformation",
    curvature_weight: float = 20, stretch_weight: float = 0, isometry_weight: float = 1, position_weight: float = 0,
    features: npt.ArrayLike | None = None, other_features: npt.ArrayLike | None = None,
    feature_weight: npt.ArrayLike = 20, landmarks: npt.ArrayLike | None = None, landmark_weight: float = 300,
    policy: str = "parallel", maximum_running_time: float = float("inf"), progress: object = None,
) -> RegisteredMap:
    """Moves the map of a mesh on the sphere so that it corresponds to the map of another mesh.

    Parameters
    ----------
    points : array_like (n, 3) of float
    triangles : array_like (m, 3) of int
    sphere : array_like (n, 3) of float
        A valid map of this mesh, of low isometric distortion, and by the same method as the other map.
    other_points, other_triangles, other_sphere : array_like
        The other mesh, and its map, which is not moved.
    motion : {"deformation", "moebius", "rotation"}
        How the map may be moved.
    curvature_weight, stretch_weight, isometry_weight, position_weight : float
        Weights of the terms of the deformation, relative to the mean symmetric Dirichlet energy of the deformation: the mean
        squared differences of mean curvature and of the area stretch of the maps; the stretching of one surface onto the
        other; the mean squared differences of positions, for shapes in the same position and pose.
    features, other_features : array_like (n,) or (n, k) of float, optional
        Numbers at the vertices of each mesh that should be equal at corresponding points, such as sulcal depth. They
        determine the start, and drive the deformation together with the curvature, or alone if `curvature_weight` is 0.
        Each column is smoothed and brought to mean 0 and variance 1 on each surface, so units do not matter.
    feature_weight : float, or array_like (k,) of float
        Weight of each column, as that of the curvature.
    landmarks : array_like (k, 2) of int, optional
        Pairs of corresponding vertices of this mesh and of the other one.
    landmark_weight : float
        Initial weight of the mean squared distance of the landmarks on the sphere.
    policy : {"parallel", "sequential"}
    maximum_running_time : float
        Seconds after which the best map so far is returned, which is certified, too.
    progress : callable, or bar of tqdm
        Called with the fraction of the work done, up to 20 times a second. If it returns False, the call ends as at the
        time limit.

    Returns
    -------
    RegisteredMap

    Raises
    ------
    MeshError
        If a map is not valid, or the registered map could not be kept valid.
    KeyboardInterrupt
        After Ctrl-C, within a fraction of a second. Other Python threads run during the call.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(3)
    >>> body = sphere * [3, 2, 1] + sphere**2
    >>> registered = sp.register_maps(body, triangles, sphere, body[:, [1, 2, 0]], triangles, sphere[:, [1, 2, 0]])
    >>> there = sp.Locator(triangles, sphere[:, [1, 2, 0]]).transfer(body[:, [1, 2, 0]], registered.sphere)
    >>> bool(abs(there - body[:, [1, 2, 0]]).max() < 0.05)
    True
    """
    check(register_maps, locals())
    if not 0 <= landmark_weight < np.inf:
        raise ValueError(f"landmark_weight: a number from 0 on is needed, not {landmark_weight}")
    one_of("motion", motion, "deformation", "moebius", "rotation")
    a, b = vectors("points", points), vectors("other_points", other_points)
    pairs = integers("landmarks", np.empty((0, 2)) if landmarks is None else landmarks)
    if pairs.size == 0:
        pairs = pairs.reshape(0, 2)
    if pairs.ndim != 2 or pairs.shape[1] != 2:
        raise ValueError(f"landmarks: shape (k, 2) is needed, not {pairs.shape}")
    if pairs.size and (pairs.min() < 0 or pairs[:, 0].max() >= len(a) or pairs[:, 1].max() >= len(b)):
        raise ValueError("landmarks: there is no such vertex")
    if any(len(set(column)) < len(column) for column in pairs.T.tolist()):
        raise ValueError("landmarks: a vertex is listed twice")
    was_ctrl_c, registered, is_complete, start, margin, difference, trust, rotation, *figures = _core.register_maps(
        a, index_triples(triangles), sphere_vectors("sphere", sphere, len(a)),
        b, index_triples(other_triangles, "other_triangles"), sphere_vectors("other_sphere", other_sphere, len(b)),
        motion, curvature_weight, stretch_weight, isometry_weight, position_weight,
        _features(features, other_features, feature_weight, (len(a), len(b))), landmark_weight, pairs.tolist(),
        policy, maximum_running_time, callback_of(progress),
    )
    if was_ctrl_c:
        raise KeyboardInterrupt
    return RegisteredMap(registered, is_complete, start, margin, difference, trust, np.array(rotation), *figures)


def morph(points: npt.ArrayLike, other_points: npt.ArrayLike, steps: int = 10) -> Doubles:
    """The points of a mesh on their way to other places, such as the corresponding points of another shape.

    The best rigid motion is made at an even speed, and the rest is linear, so that a shape that only turns does not shrink
    on the way.

    Parameters
    ----------
    points, other_points : array_like (n, 3) of float
        The points at the start and at the end.
    steps : int
        At least 1.

    Returns
    -------
    ndarray (steps + 1, n, 3) of float64
        The first and the last are the given points.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> points, triangles = sp.icosphere(2)
    >>> half = sp.morph(points * [2, 1, 1], points * [-2, -1, 1])[5]  # turned by 90 degrees
    >>> bool(abs(abs(half) - abs(points * [2, 1, 1])[:, [1, 0, 2]]).max() < 1e-12)
    True
    """
    check(morph, locals())
    a, b = vectors("points", points), vectors("other_points", other_points)
    if len(a) != len(b) or len(a) == 0:
        raise ValueError(f"other_points: as many as points are needed, at least one, not {len(b)} for {len(a)}")
    if not (np.isfinite(a).all() and np.isfinite(b).all()):
        raise ValueError("points, other_points: finite numbers are needed")
    if steps < 1:
        raise ValueError(f"steps: a number from 1 on is needed, not {steps}")
    return _core.morph(a, b, steps)


def moebius_centred(sphere: Sphere, triangles: npt.ArrayLike, masses: npt.ArrayLike) -> Doubles:
    """Moves a map by the Moebius transformation that brings the centroid of masses to the centre of the sphere.

    Afterwards, all conformal maps of a shape are the same up to a rotation (A. Baden, K. Crane, M. Kazhdan, "Moebius
    registration", 2018). Long faces may flip, and the smallest ones where limbs shrink: certify the result.

    Parameters
    ----------
    sphere : array_like (n, 3) of float
    triangles : array_like (m, 3) of int
    masses : array_like (n,) of float
        Masses of the vertices, such as their areas on the surface; not negative.

    Returns
    -------
    ndarray (n, 3) of float64

    Raises
    ------
    MeshError
        For a mass that is negative or not finite, or if all are 0.

    Warns
    -----
    MapWarning
        If half of the masses or more are at one point: then there is no such transformation, and the centroid is as near
        to the centre as the warning says.
    """
    images = sphere_vectors("sphere", sphere)
    centred, distance = _core.moebius_centred(images, index_triples(triangles), numbers("masses", masses, len(images)))
    if distance > 1e-6:
        text = f"the masses cannot be centred: half of them or more are at one point; the centroid is {distance:.3g} off"
        warnings.warn(text, MapWarning, stacklevel=2)
    return centred
