# SPDX-License-Identifier: LGPL-3.0-or-later
"""Maps to the sphere: `parameterize()`, its `Result`, and `certify()`."""

from __future__ import annotations

import functools
import inspect
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, Integers, Sphere, check, chosen, doubles, edge_numbers, index_triples
from .arrays import integers, numbers, one_of, sphere_vectors, vectors, wrong_type
from .errors import ErrorCode, MapWarning, MeshError
from .methods import METHODS, Automatic, ClampedWeights, Method, SaddlePoint

Fixed = Union[Mapping[int, Sequence[float]], tuple[npt.ArrayLike, npt.ArrayLike]]


@dataclass(frozen=True)
class Seconds:
    """Wall-clock seconds of the phases of a call; they add up to `total`."""

    read: float  #: reading the arrays, with all checks of the mesh
    weights: float  #: edge weights; for conformal weights also the intrinsic Delaunay triangulation
    start_map: float  #: set-up of the multigrid hierarchy, and the start map
    solve: float  #: from the start map to the result
    certify: float  #: certificates of all attempts
    total: float  #: the whole call

    def __float__(self) -> float:
        return self.total


@dataclass(frozen=True)
class Attempt:
    """The outcome of a method that was tried."""

    method: str
    error: ErrorCode
    detail: str
    seconds: Seconds
    termination: str | None  #: why it ended, as in `Result`


@dataclass(frozen=True, eq=False)
class Result:
    """A map, its certificate, and the work that was done. True if and only if the map is certified."""

    sphere: Doubles  #: (n, 3), a unit vector for every point
    error: ErrorCode  #: `OK` if and only if the map is certified
    detail: str  #: what is wrong, where, and what to do; empty if `OK`
    number_of_vertices: int
    number_of_faces: int
    flipped_faces: int  #: faces (a, b, c) with orientation(O, a, b, c) <= 0, by exact predicates on `sphere`
    moved_vertices: int  #: number of vertices that were moved to repair bad faces, with conformal weights
    degree: int  #: how often the map covers the sphere; 1 for a valid map
    residual: float  #: residual of the equation that the method solves
    energy: float  #: spring energy; with `Isometric` the mean distortion
    density_deviation: float  #: with `density`: root mean square of log(area / target area), weighted by target area; else 0
    smallest_area: float  #: area of the smallest spherical triangle, in steradians; below 1e-26 rounding flips faces
    smallest_edge: float  #: length of the shortest chord, in units of 2^-52
    method: str  #: the method that computed the map: "balanced", "isometric", ...
    fallback_reason: str  #: `Automatic`: why the attempts before were rejected
    termination: str | None  #: why the method ended: "converged", "iterations", "time", "callback", "stalled"; None if nothing was computed
    start_iterations: int  #: iterations for the start map
    iterations: int  #: iterations of the method
    sweeps: int  #: Jacobi or Gauss-Seidel sweeps
    seconds: Seconds  #: wall-clock time of each phase
    attempts: tuple[Attempt, ...]  #: all methods that were tried
    device: str  #: where the method ran
    text: str  #: the result in one line, which is also `str(result)`

    @property
    def is_valid(self) -> bool:
        """Whether the map is certified (no flipped face, degree 1) and the method has done what was asked for.

        `termination` says whether it has reached its accuracy, or how it ended before.
        """
        return self.error is ErrorCode.OK

    def __bool__(self) -> bool:
        return self.is_valid

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<Result: {self.text}>"


@dataclass(frozen=True)
class Certificate:
    """The result of `certify()`. True if and only if the map is valid."""

    flipped_faces: int  #: faces that are flipped, degenerate or not finite
    degree: int  #: how often the map covers the sphere; -1 for a mirrored map

    @property
    def is_valid(self) -> bool:
        """Whether the map is a bijection."""
        return self.flipped_faces == 0 and self.degree == 1

    def __bool__(self) -> bool:
        return self.is_valid

    def __repr__(self) -> str:
        verdict = "valid" if self else "not valid"
        return f"<Certificate: {verdict}, {self.flipped_faces} flipped faces, degree {self.degree}>"


def edges(triangles: npt.ArrayLike) -> Integers:
    """The edges of a mesh, in the order in which `parameterize()` takes weights.

    Parameters
    ----------
    triangles : array_like (m, 3) of int

    Returns
    -------
    ndarray (k, 2) of int64
        The vertices of each edge, the smaller index first; the edges are sorted.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sp.edges([[0, 1, 2], [0, 2, 1]]).tolist()
    [[0, 1], [0, 2], [1, 2]]
    """
    return edge_numbers(index_triples(triangles))[0]


def _weights(weights: str | ClampedWeights | npt.ArrayLike, triangles: Integers) -> object:
    """A name, ClampedWeights, or an array (m, 3) with the weight of the edge from every corner to the next one."""
    if isinstance(weights, str):
        one_of("weights", weights, "conformal", "clamped", "barycentric", "mean-value")
        return weights
    if isinstance(weights, ClampedWeights):
        return weights
    given = doubles("weights", weights)
    edge, number = edge_numbers(triangles)
    if given.shape != triangles.shape:
        return np.ascontiguousarray(numbers("weights", given, len(edge))[number])
    of_edges = np.empty(len(edge))
    of_edges[number] = given
    differ = np.flatnonzero((of_edges[number] != given).any(axis=1) & np.isfinite(given).all(axis=1))
    if len(differ) > 0:
        raise ValueError(f"weights: an edge of triangle {differ[0]} has another weight in the triangle beyond it")
    return given


def _fixed(fixed: Fixed, sphere: Doubles) -> npt.NDArray[np.bool_] | None:
    """Which vertices are fixed, if any are; writes where to `sphere`."""
    if isinstance(fixed, Mapping):
        fixed = (list(fixed.keys()), list(fixed.values()))
    if not isinstance(fixed, (tuple, list)) or len(fixed) != 2:
        raise wrong_type("fixed", "a mapping of vertices to directions, or a pair of vertices and directions,", fixed)
    index = integers("fixed: vertices", fixed[0])
    if index.size == 0:
        return None
    if index.ndim != 1 or len(np.unique(index)) < len(index):
        raise ValueError("fixed: a list of vertices is needed, each of them once")
    places = vectors("fixed: directions", fixed[1], index.size)
    if not ((0 <= index) & (index < len(sphere))).all():
        raise MeshError(ErrorCode.BAD_CONSTRAINTS, f"fixed vertices are numbers from 0 to {len(sphere) - 1}")
    is_fixed = np.zeros(len(sphere), dtype=np.bool_)
    is_fixed[index] = True
    sphere[index] = places
    return is_fixed


def _density(density: npt.ArrayLike, number_of_points: int, number_of_triangles: int) -> Doubles:
    """One number for every point or triangle; four of a tetrahedron are those of its points."""
    array = doubles("density", density)
    if array.shape not in ((number_of_points,), (number_of_triangles,)):
        raise ValueError(
            f"density: shape ({number_of_points},) or ({number_of_triangles},) is needed, not {array.shape}"
        )
    return array


_opencl_device = functools.lru_cache(maxsize=None)(_core.opencl_device)


def opencl_device(name: str = "", *, precision: str = "automatic", smallest_mesh: int = 10000) -> _core.OpenCLDevice:
    """An OpenCL device, as `policy` of `parameterize()`.

    Parameters
    ----------
    name : str
        Its index in `opencl_devices()`, or a part of its name. If empty: the device named by the environment variable
        CGAL_SPHERICAL_PARAMETERIZATION_DEVICE, else the first GPU with double precision, else the first device.
    precision : {"automatic", "double", "single"}
    smallest_mesh : int
        Meshes with fewer vertices are mapped on one core of the host.

    Raises
    ------
    DeviceError
        If there is no such device, or if it does not support the precision.

    Returns
    -------
    OpenCLDevice
    """
    check(opencl_device, {"name": name, "precision": precision, "smallest_mesh": smallest_mesh})
    one_of("precision", precision, "automatic", "double", "single")
    return _opencl_device(name, precision, smallest_mesh)


def opencl_devices() -> list[dict[str, Any]]:
    """The properties of each OpenCL device.

    Returns
    -------
    list of dict
        Empty if there is no driver.
    """
    return _core.opencl_devices()


def callback_of(progress: object) -> object:
    """A callable; False of numpy is False. A bar of tqdm is told by how much the fraction has grown."""
    if progress is None:
        return None
    if callable(progress):
        function = progress

        def goes_on(fraction: float) -> bool:
            answer = function(fraction)
            return not isinstance(answer, (bool, np.bool_)) or bool(answer)

        return goes_on
    bar: Any = progress
    if not (hasattr(bar, "total") and hasattr(bar, "update") and hasattr(bar, "n")):
        raise wrong_type("progress", "a function, or a bar of tqdm,", bar)
    total = 1 if bar.total is None else bar.total

    def update(fraction: float) -> None:
        bar.update(fraction * total - bar.n)

    return update


def parameterize(
    points: npt.ArrayLike, triangles: npt.ArrayLike, method: Method = Automatic(), *,
    weights: str | ClampedWeights | npt.ArrayLike = "conformal", policy: str | _core.OpenCLDevice = "parallel",
    fixed: Fixed | None = None, density: npt.ArrayLike | None = None, start: Sphere | None = None,
    accuracy: float | None = None, iterations: int | None = None, maximum_running_time: float = float("inf"),
    progress: object = None, verbose: bool = False, warn: bool = True,
) -> Result:
    """Maps a closed triangle mesh of genus 0 to the unit sphere. Exact predicates certify the map.

    Parameters
    ----------
    points : array_like (n, 3) of float
        In any unit. float64 in C order is not copied.
    triangles : array_like (m, 3) of int
        Indices of points, from 0, counterclockwise as seen from outside. int32 and int64 in C order are not copied.
    method : Automatic, Balanced, Isometric or SaddlePoint, or "automatic", "balanced", "isometric" or "saddle-point"
    weights : {"conformal", "clamped", "barycentric", "mean-value"}, ClampedWeights, or array_like of float
        Spring constants of the edges. An array has one number for each of `edges(triangles)`, or shape (m, 3) with the
        edges from each corner of a triangle to the next one, the same for both triangles of an edge.
    policy : {"parallel", "sequential", "opencl"} or OpenCLDevice
        Where to run; the map does not depend on it, to the last bit. See `opencl_device()`.
    fixed : mapping of int to three floats, or pair of array_like (k,) and (k, 3)
        Vertices and their positions on the sphere: three or more, or none. `Isometric` and `Automatic` accept any positions.
    density : array_like (n,) or (m,) of float
        A positive number for every point or every triangle: areas on the sphere are to be proportional to these numbers times the
        areas in the mesh. For `Isometric` and `Automatic`; `Result.density_deviation` says how close they are.
    start : array_like (n, 3) of float
        The start map, for `SaddlePoint(start="given")` and no other method.
    accuracy : float
        The residual to reach. Default: that of the method.
    iterations : int
        Maximum number of iterations. Default: that of the method.
    maximum_running_time : float
        Seconds after which the call ends with the best map so far and `error` INTERRUPTED.
    progress : callable, or bar of tqdm
        Called with the fraction of the work done, at the beginning, up to 20 times a second, and at the end. If it returns False,
        the call ends with the best map so far and `error` INTERRUPTED; a `MeshError` says so if there is none yet.
    verbose : bool
        Logs every iteration to stderr.
    warn : bool
        Whether to issue a warning if the map is not certified.

    Returns
    -------
    Result
        `result.sphere` is the map; `result.is_valid` says whether it is certified.

    Raises
    ------
    MeshError
        If there is no map, because something is wrong with the mesh, the weights, densities or fixed vertices, or because
        limit or `progress` ended the call before there was one (INTERRUPTED). `code` and `detail` say what, where, and
        what to do.
    DeviceError
        If the OpenCL device does not exist, or has failed.
    ValueError, TypeError
        If an argument has a wrong value, shape or type.

    Warns
    -----
    MapWarning
        If there is a map, but it is not certified.

    Notes
    -----
    Other Python threads run during the call. Ctrl-C ends the call with the best map so far and `error` INTERRUPTED; if
    there is none yet, KeyboardInterrupt is raised.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> points, triangles = sp.icosphere(3)
    >>> result = sp.parameterize(points * [1, 1, 2], triangles)
    >>> result.is_valid, result.flipped_faces, result.degree, result.method
    (True, 0, 1, 'balanced')
    >>> result.sphere.shape
    (642, 3)

    A mesh that is not closed:

    >>> try:
    ...     sp.parameterize(points, triangles[1:])
    ... except sp.MeshError as error:
    ...     print(error.code)
    BOUNDARY
    """
    return _mapped(**locals())[0]


def map_to_go_on(*arguments: Any, **settings: Any) -> Result:
    """`parameterize()` for functions that go on with the map: Ctrl-C ends them, too, with a KeyboardInterrupt."""
    bound = inspect.signature(parameterize).bind(*arguments, **settings)
    bound.apply_defaults()
    result, was_ctrl_c = _mapped(**bound.arguments)
    if was_ctrl_c:
        raise KeyboardInterrupt
    return result


def _mapped(
    points: Any, triangles: Any, method: Any, *, weights: Any, policy: Any, fixed: Any, density: Any, start: Any, accuracy: Any,
    iterations: Any, maximum_running_time: Any, progress: Any, verbose: Any, warn: Any,
) -> tuple[Result, bool]:
    """The result of `parameterize()`, and whether Ctrl-C has ended the call."""
    check(parameterize, locals())
    points, triangles = vectors("points", points), index_triples(triangles)
    method = chosen("method", method, METHODS)
    if start is not None and not (isinstance(method, SaddlePoint) and method.start == "given"):
        raise ValueError("start: only SaddlePoint(start='given') starts from a map")
    if start is None and isinstance(method, SaddlePoint) and method.start == "given":
        raise ValueError("start: SaddlePoint(start='given') needs a map")
    sphere = np.zeros_like(points) if start is None else sphere_vectors("start", start, len(points)).copy()
    is_fixed = None if fixed is None else _fixed(fixed, sphere)
    if isinstance(policy, str):
        one_of("policy", policy, "sequential", "parallel", "opencl")
    elif not isinstance(policy, _core.OpenCLDevice):
        raise wrong_type("policy", "'parallel', 'sequential', 'opencl' or an OpenCLDevice", policy)
    fields, has_map, was_ctrl_c = _core.parameterize(
        points, triangles, method, _weights(weights, triangles), opencl_device() if policy == "opencl" else policy,
        is_fixed, None if density is None else _density(density, len(points), len(triangles)), sphere,
        accuracy, iterations, maximum_running_time, verbose, callback_of(progress),
    )
    error = ErrorCode(fields.pop("error"))
    attempts = tuple(Attempt(a[0], ErrorCode(a[1]), a[2], Seconds(*a[3]), a[4]) for a in fields.pop("attempts"))
    if was_ctrl_c and not has_map:
        raise KeyboardInterrupt
    if not has_map:
        raise MeshError(error, fields["detail"])
    fields["seconds"] = Seconds(*fields["seconds"])
    result = Result(sphere=sphere, error=error, attempts=attempts, **fields)
    if warn and not result:
        warnings.warn(result.text, MapWarning, stacklevel=3)
    return result, was_ctrl_c


def certify(triangles: npt.ArrayLike, sphere: Sphere, *, policy: str = "parallel") -> Certificate:
    """Checks by exact predicates whether a map is a bijection.

    Parameters
    ----------
    triangles : array_like (m, 3) of int
    sphere : array_like (n, 3) of float
        Vectors of any length except 0. float32 numbers are certified as they are, as a file will hold them.
    policy : {"parallel", "sequential"}

    Returns
    -------
    Certificate

    Raises
    ------
    MeshError
        If the triangles do not form a closed surface of genus 0, or a coordinate is not finite.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(2)
    >>> sp.certify(triangles, sphere)
    <Certificate: valid, 0 flipped faces, degree 1>
    >>> sp.certify(triangles, -sphere).is_valid
    False
    """
    check(certify, locals())
    return Certificate(*_core.certify(index_triples(triangles), vectors("sphere", getattr(sphere, "sphere", sphere)), policy))
