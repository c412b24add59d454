# SPDX-License-Identifier: LGPL-3.0-or-later
"""Preparation of meshes by the module `_preparation`, which is under the GPL, like the CGAL packages that it uses."""

from __future__ import annotations

import dataclasses
import importlib
import json
from numbers import Real
from typing import Any

import numpy as np
import numpy.typing as npt

from .arrays import Doubles, Integers, OneLine, check, check_indices, index_triples, one_of, vectors, wrong_type


def gpl_module() -> Any:
    """The module `_preparation`."""
    try:
        return importlib.import_module("._preparation", __package__)
    except ImportError as error:
        raise ImportError(
            "spherical_parameterization._preparation is not there: it is under the GPL, and comes separately, by "
            "'pip install ./python/preparation' or with the .deb"
        ) from error


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Prepared(OneLine):
    """A repaired mesh, with the original indices of its points and triangles."""

    points: Doubles  #: (n, 3)
    triangles: Integers  #: (m, 3)
    vertex_map: Integers  #: (n,), for every point its index before, or -1 if it is new
    face_map: Integers  #: (m,), for every triangle its index before, or -1 if it is new
    report: dict[str, Any]  #: part of the `--report` of the tool; `report["preparation"]["done"]` says in sentences what was done


def prepare(
    points: npt.ArrayLike, triangles: npt.ArrayLike, *,
    harmless: bool = False, components: str = "largest", fill_holes: bool = True, cut_handles: bool = True,
    merge_distance: float = 0.0, wrap: bool | tuple[float | None, float | None] = False,
    maximum_running_time: float = float("inf"),
) -> Prepared:
    """Repairs a mesh so that it is one closed surface of genus 0: merges points at the same position, orients faces, cuts
    non-manifold parts from each other, keeps the largest component, fills holes and cuts handles along shortest loops.

    Parameters
    ----------
    points : array (n, 3)
    triangles : array (m, 3) of int
    harmless : bool
        Makes only repairs that do not change the shape; not with `wrap` or `merge_distance`.
    components : "largest" or "all"
    fill_holes, cut_handles : bool
    merge_distance : float
        Boundary points are merged up to this distance.
    wrap : bool or (alpha, offset)
        Replaces the mesh by a surface around it. Cavities that a ball of radius alpha cannot enter are filled.
    maximum_running_time : float
        Seconds after which a `MeshError` with the code INTERRUPTED is raised.

    Returns
    -------
    Prepared

    Raises
    ------
    MeshError
        If there is no valid triangle. Triangles at points that are not finite are not valid.
    ImportError
        If the module `_preparation` is not installed. It is under the GPL, and is installed separately.
    """
    module = gpl_module()
    check(prepare, locals())
    one_of("components", components, "largest", "all")
    if not 0 <= merge_distance < np.inf:
        raise ValueError(f"merge_distance: a number from 0 on is needed, not {merge_distance}")
    sizes = ((None, None) if wrap else None) if isinstance(wrap, (bool, np.bool_)) else wrap
    if sizes is not None:
        if not isinstance(sizes, (tuple, list, np.ndarray)) or not all(x is None or isinstance(x, Real) for x in sizes):
            raise wrong_type("wrap", "True, or a pair of positive numbers,", wrap)
        if len(sizes) != 2 or not all(x is None or 0 < x < np.inf for x in sizes):
            raise ValueError(f"wrap: True, or two positive numbers, are needed, not {wrap}")
    elif wrap is None:
        raise wrong_type("wrap", "True, or a pair of positive numbers,", wrap)
    if harmless and (sizes is not None or merge_distance > 0):
        raise ValueError("harmless: wrap and merge_distance change the shape")
    points, triangles = vectors("points", points), index_triples(triangles)
    check_indices(triangles, len(points))
    was_ctrl_c, mended, faces, vertex_map, face_map, report = module.prepare(
        points, triangles.astype(np.int32), merge_distance, not harmless and components == "largest",
        fill_holes and not harmless, cut_handles and not harmless, None if sizes is None else tuple(sizes), maximum_running_time,
    )
    if was_ctrl_c:
        raise KeyboardInterrupt
    return Prepared(mended, faces, vertex_map, face_map, json.loads(report))
