# SPDX-License-Identifier: LGPL-3.0-or-later
"""Mesh files, by the readers and writers of the command-line tool."""

from __future__ import annotations

import os
from typing import Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, Integers, check, index_triples, vectors
from .errors import ErrorCode, MeshError

Path = Union[str, "os.PathLike[str]"]


def read_mesh(path: Path, *, triangulate: bool = False) -> tuple[Doubles, Integers]:
    """Reads points and triangles from a file: OFF, OBJ, PLY, STL, GIFTI, FreeSurfer surfaces and glTF, also compressed.

    The format is recognized by the contents of the file. In STL and glTF files, points at the same position are merged.
    Files of other formats are read by meshio, if it is installed.

    Parameters
    ----------
    path : str or path
    triangulate : bool
        Whether to cut polygons into triangles, which is correct for convex polygons.

    Returns
    -------
    points : ndarray (n, 3) of float64
    triangles : ndarray (m, 3) of int

    Raises
    ------
    MeshError
        If a face is not a triangle, or a coordinate is not finite.
    OSError
        If the file cannot be read, or is damaged; the text says where.
    """
    check(read_mesh, locals())
    os.stat(path)  # FileNotFoundError
    name = os.fsencode(path)
    if not _core.is_format_known(name):
        try:
            import meshio
        except ImportError:
            pass
        else:
            if os.path.splitext(os.fsdecode(path))[1].lower() in meshio.extension_to_filetypes:
                return _by_meshio(os.fsdecode(path))
    return _core.read_mesh(name, triangulate)


def _by_meshio(name: str) -> tuple[Doubles, Integers]:
    import meshio

    try:
        mesh = meshio.read(name)
    except (SystemExit, meshio.ReadError) as error:  # some versions of it exit
        raise OSError(f"{name}: meshio cannot read it: {error}") from error
    others = sorted({c.type for c in mesh.cells if c.type not in ("triangle", "vertex", "line")})
    if others:
        raise MeshError(ErrorCode.NOT_TRIANGULAR, f"{name} has cells of type {', '.join(others)}; triangulate it")
    blocks = [c.data for c in mesh.cells if c.type == "triangle"]
    if not blocks:
        raise MeshError(ErrorCode.EMPTY_MESH, f"{name} has no triangles")
    return np.asarray(mesh.points, dtype=np.float64), np.concatenate(blocks)


def write_mesh(
    path: Path,
    points: npt.ArrayLike,
    triangles: npt.ArrayLike,
    *,
    sphere: bool = False,
    ascii: bool = False,
    like: Path | None = None,
) -> None:
    """Writes a mesh to a file. The file is complete, or does not exist.

    Parameters
    ----------
    path : str or path
        .off, .obj, .ply, .gii, .glb, .gltf, or lh.NAME and rh.NAME for FreeSurfer, also followed by .gz, .xz, .zst or .bz2.
    points : array_like (n, 3) of float
    triangles : array_like (m, 3) of int
    sphere : bool
        Whether the points are a map. GIFTI and FreeSurfer files then get spheres of radius 100, as neuroimaging programs expect.
    ascii : bool
        Whether to write PLY as text.
    like : str or path, optional
        A file from which the GIFTI metadata or the FreeSurfer volume geometry are taken.

    Raises
    ------
    ValueError
        If the extension belongs to no format that can be written.
    MeshError
        If a triangle has an index of a point that does not exist, or the format cannot hold the coordinates.
    OSError
        If the file cannot be written.
    """
    check(write_mesh, locals())
    points, triangles = vectors("points", points), index_triples(triangles)
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(points):
        raise MeshError(ErrorCode.BAD_INDEX, "points are numbered from 0 on")
    _core.write_mesh(os.fsencode(path), points, triangles, sphere, ascii, b"" if like is None else os.fsencode(like))
