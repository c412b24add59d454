# SPDX-License-Identifier: LGPL-3.0-or-later
"""Meshes from files, by the libraries that read them."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .arrays import Doubles, Integers
from .errors import ErrorCode, MeshError


def read_mesh(path: str | os.PathLike[str]) -> tuple[Doubles, Integers]:
    """Points and triangles of a file: GIFTI by nibabel, FreeSurfer's surfaces too; all others by meshio.

    Parameters
    ----------
    path : str or path
        `.gii` and `.gii.gz` are GIFTI; what has no extension that meshio knows is tried as FreeSurfer geometry.

    Returns
    -------
    points : ndarray (n, 3) of float64
    triangles : ndarray (m, 3) of int

    Raises
    ------
    MeshError
        If there are no triangles in the file, or other faces than triangles.
    ImportError
        If nibabel or meshio is needed and not there.
    OSError, and exceptions of the library
        If the file cannot be read.
    """
    name = os.fspath(path)
    if name.endswith((".gii", ".gii.gz")):
        import nibabel

        image: Any = nibabel.load(name) if name.endswith(".gii") else _gifti_gz(name)
        points, triangles = image.agg_data(("pointset", "triangle"))
        return np.asarray(points, dtype=np.float64), np.asarray(triangles)
    import meshio

    if os.path.splitext(name)[1].lower() in meshio.extension_to_filetypes:
        mesh = meshio.read(name)
        others = sorted({c.type for c in mesh.cells if c.type not in ("triangle", "vertex", "line")})
        if others:
            raise MeshError(ErrorCode.NOT_TRIANGULAR, f"{name} has cells of type {', '.join(others)}; triangulate it")
        blocks = [c.data for c in mesh.cells if c.type == "triangle"]
        if not blocks:
            raise MeshError(ErrorCode.EMPTY_MESH, f"{name} has no triangles")
        return np.asarray(mesh.points, dtype=np.float64), np.concatenate(blocks)
    import nibabel.freesurfer

    points, triangles = nibabel.freesurfer.read_geometry(name)[:2]
    return np.asarray(points, dtype=np.float64), np.asarray(triangles)


def _gifti_gz(name: str) -> Any:
    import gzip

    import nibabel

    with gzip.open(name) as file:
        return nibabel.GiftiImage.from_bytes(file.read())
