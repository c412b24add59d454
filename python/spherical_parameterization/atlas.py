# SPDX-License-Identifier: LGPL-3.0-or-later
"""From meshes to their mean shape and principal components. The command `atlas` does the same with files, and resumes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .analysis import Locator, icosphere
from .arrays import Doubles, OneLine, check, index_triples, one_of, vectors
from .errors import MeshError
from .maps import parameterize
from .methods import Isometric
from .registration import register_maps
from .statistics import ShapeStatistics, align_shapes, mean_vertex_areas, shape_statistics


@dataclass(frozen=True, eq=False, repr=False)
class Atlas(OneLine):
    """Shapes with the same vertices and faces, aligned, and their statistics."""

    triangles: npt.NDArray[np.int32]  #: (f, 3), of all shapes: those of an icosphere
    sphere: Doubles  #: (m, 3), the directions of the vertices
    shapes: Doubles  #: (n, m, 3), aligned
    weights: Doubles  #: (m,), what each vertex counts: its area, mean over the shapes
    statistics: ShapeStatistics
    members: list[int]  #: the numbers of the meshes that the shapes are of
    refused: dict[int, str]  #: by the numbers of the other meshes: why


def atlas(
    meshes: Sequence[tuple[npt.ArrayLike, npt.ArrayLike]],
    *,
    template: int | None = None,
    rounds: int = 1,
    level: int = 5,
    align: str = "rigid",
    modes: int | None = None,
    policy: str = "parallel",
) -> Atlas:
    """Maps meshes, registers them, samples them at one icosphere, and takes mean and principal components.

    Parameters
    ----------
    meshes : sequence of (points, triangles)
        Closed, of genus 0, each with vertices and faces of its own.
    template : int
        The number of the mesh that all are registered to first. Default: the first that has a map.
    rounds : int
        How often they are registered: from the second time on to the mean of the time before.
    level : int
        The icosphere has 10 * 4**level + 2 vertices.
    align : {"none", "centre", "rigid", "similarity"}
        What is no difference of shapes: nothing, their place, rotations, too, or sizes as well.
    modes : int
        At most so many. Default: all.
    policy : {"parallel", "sequential"}

    Returns
    -------
    Atlas

    Raises
    ------
    ValueError
        Fewer than two meshes can be mapped and registered, or not the template.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> sphere, triangles = sp.icosphere(3)
    >>> result = sp.atlas([(sphere * [x, 2, 3], triangles) for x in (1, 1.2, 1.4)], level=2)
    >>> result.statistics.mean.shape
    (162, 3)
    """
    check(atlas, locals())
    one_of("align", align, "none", "centre", "rigid", "similarity")
    spheres: dict[int, Doubles] = {}
    arrays = [(vectors("points", points), index_triples(triangles)) for points, triangles in meshes]
    refused: dict[int, str] = {}
    for i, (points, triangles) in enumerate(arrays):
        try:
            result = parameterize(points, triangles, Isometric(), policy=policy, warn=False)
        except MeshError as error:
            refused[i] = str(error)
            continue
        if result.is_valid:
            spheres[i] = result.sphere
        else:
            refused[i] = str(result)
    if template is None and spheres:
        template = min(spheres)
    if template not in spheres:
        raise ValueError(f"template: mesh {template} has no map: {refused.get(template or 0, 'there is no such mesh')}")
    directions, faces = icosphere(level)
    other = (*arrays[template], spheres[template])
    for round_number in range(rounds):
        shapes: dict[int, Doubles] = {}
        for i, sphere in spheres.items():
            moved = sphere
            if round_number > 0 or i != template:
                try:
                    moved = register_maps(*arrays[i], sphere, *other, policy=policy).sphere
                except MeshError as error:
                    refused[i] = str(error)
                    continue
            shapes[i] = Locator(arrays[i][1], moved, policy=policy).transfer(arrays[i][0], directions)
        if len(shapes) < 2:
            raise ValueError(f"meshes: two or more are needed that can be mapped and registered, not {len(shapes)}")
        stacked = np.array(list(shapes.values()))
        if align != "none":
            weights = mean_vertex_areas(stacked, faces, policy=policy)
            stacked = align_shapes(
                stacked, weights=weights, rotate=align != "centre", scale=align == "similarity", policy=policy
            ).shapes
        other = (stacked.mean(axis=0), faces, directions)
    weights = mean_vertex_areas(stacked, faces, policy=policy)
    statistics = shape_statistics(stacked, weights=weights, modes=modes, policy=policy)
    refused = {i: refused[i] for i in range(len(arrays)) if i not in shapes}
    return Atlas(faces, directions, stacked, weights, statistics, list(shapes), refused)
