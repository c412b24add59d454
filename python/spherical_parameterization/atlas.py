# SPDX-License-Identifier: LGPL-3.0-or-later
"""From meshes to their mean shape and principal components. The command `atlas` does the same with files, and resumes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, Integers, OneLine, check, index_triples, one_of, vectors, wrong_type
from .errors import ErrorCode, MeshError
from .maps import map_to_go_on
from .methods import Isometric
from .statistics import ShapeStatistics

_PLACEMENTS = ("none", "centre", "rigid", "similarity")


@dataclass(frozen=True, eq=False, repr=False)
class Atlas(OneLine):
    """Shapes with the same vertices and faces, aligned, and their statistics."""

    triangles: npt.NDArray[np.int32]  #: (f, 3), the same for all shapes
    sphere: Doubles  #: (m, 3), the directions of the vertices
    shapes: Doubles  #: (n, m, 3), aligned
    weights: Doubles  #: (m,), weights of the vertices: their areas, averaged over the shapes
    statistics: ShapeStatistics
    members: list[int]  #: for every shape, the index of its mesh
    refused: dict[int, str]  #: for the indices of the other meshes: why they were refused


def atlas(
    meshes: Sequence[tuple[npt.ArrayLike, npt.ArrayLike]], *,
    template: int | None = None, rounds: int = 1, faces: str = "icosphere", level: int = 5, align: str = "rigid",
    modes: int | None = None, policy: str = "parallel",
) -> Atlas:
    """Maps meshes, registers them, samples them at one icosphere, and computes mean and principal components.

    Parameters
    ----------
    meshes : sequence of (points, triangles)
        Closed meshes of genus 0. Each may have its own vertices and faces.
    template : int
        The index of the mesh to which all are registered first. Default: the first mesh that has a map.
    rounds : int
        Number of rounds of registration. From the second round on, the template is the mean of the round before.
    faces : {"icosphere", "template"}
        All shapes get the vertices and faces of an icosphere, or of the template.
    level : int
        The icosphere has 10 * 4**level + 2 vertices.
    align : {"none", "centre", "rigid", "similarity"}
        What is removed before shapes are compared: nothing, translations, rotations, too, or sizes, too.
    modes : int
        Maximum number of modes. Default: all.
    policy : {"parallel", "sequential"}

    Returns
    -------
    Atlas

    Raises
    ------
    ValueError
        If there are fewer than two meshes, or the template cannot be mapped.
    MeshError
        If fewer than two meshes can be mapped and registered.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(3)
    >>> result = sp.atlas([(sphere * [x, 2, 3], triangles) for x in (1, 1.2, 1.4)], level=2)
    >>> result.statistics.mean.shape
    (162, 3)
    """
    check(atlas, locals())
    one_of("align", align, *_PLACEMENTS)
    one_of("faces", faces, "icosphere", "template")
    mapped: dict[int, tuple[Doubles, Integers, Doubles]] = {}
    refused: dict[int, str] = {}
    codes: list[ErrorCode | str] = []
    if not isinstance(meshes, Iterable):
        raise wrong_type("meshes", "a list of (points, triangles)", meshes)
    for i, mesh in enumerate(meshes):
        if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
            raise wrong_type(f"meshes: mesh {i}", "a pair (points, triangles)", mesh)
        points, triangles = mesh
        try:
            points, triangles = vectors("points", points), index_triples(triangles)
            result = map_to_go_on(points, triangles, Isometric(), policy=policy, warn=False)
        except MeshError as error:
            refused[i] = str(error)
            codes.append(error.code)
            continue
        if result.is_valid:
            mapped[i] = points, triangles, result.sphere
        else:
            refused[i] = str(result)
            codes.append(result.error)
    if len(mapped) < 2 and not refused:
        raise ValueError(f"meshes: two or more are needed, not {len(mapped)}")
    if len(mapped) < 2:
        wrong = "two or more shapes are needed" if mapped else "no mesh has a map"
        reasons = [f"mesh {i}: {reason}" for i, reason in refused.items()]
        raise MeshError(codes[0], "; ".join([wrong, *reasons]))
    if template is None:
        template = min(mapped)
    if template not in mapped:
        raise ValueError(f"template: mesh {template} has no map: {refused.get(template, 'there is no such mesh')}")
    numbers = list(mapped)
    placement, most = _PLACEMENTS.index(align), 2**31 - 1 if modes is None else modes
    where = level if faces == "icosphere" else -1
    corners, sphere, shapes, weights, statistics, members, others = _core.shape_atlas(
        list(mapped.values()), numbers.index(template), rounds, where, placement, most, policy
    )
    refused.update((numbers[i], why) for i, why in others)
    mean, shape_modes, variances, scores, total = statistics
    return Atlas(
        corners, sphere, shapes, np.array(weights),
        ShapeStatistics(mean, shape_modes, np.array(variances), np.array(scores), total),
        [numbers[i] for i in members], refused,
    )
