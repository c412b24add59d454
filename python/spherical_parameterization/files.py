# SPDX-License-Identifier: LGPL-3.0-or-later
"""Meshes from files, by the libraries that read them."""

from __future__ import annotations

import itertools
import os
from typing import Any

import numpy as np

from .arrays import Doubles, Integers
from .errors import ErrorCode, MeshError


def read_mesh(path: str | os.PathLike[str]) -> tuple[Doubles, Integers]:
    """Points and triangles of a file: GIFTI and FreeSurfer's surfaces by nibabel, OFF, OBJ, all others by meshio.

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
    extension = os.path.splitext(name)[1].lower()
    if extension == ".off":
        return _read_off(name)
    if extension == ".obj":
        return _read_obj(name)
    import meshio

    if extension in meshio.extension_to_filetypes:
        try:
            mesh = meshio.read(name)
        except SystemExit as error:  # of some versions of meshio, at a file that they cannot read
            raise OSError(f"meshio cannot read {name}") from error
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


def _triangles(name: str, faces: list[list[int]]) -> Integers:
    for corners in faces:
        if len(corners) != 3:
            raise MeshError(ErrorCode.NOT_TRIANGULAR, f"{name} has a face of {len(corners)} corners; triangulate it")
    return np.array(faces, dtype=np.int64).reshape(-1, 3)


def _read_off(name: str) -> tuple[Doubles, Integers]:
    """All variants of the header, and colours of vertices or faces; meshio knows one."""
    with open(name) as file:
        lines = (words for words in (line.partition("#")[0].split() for line in file) if words)
        header: list[str] = next(lines, [])
        if not header or header[0].removeprefix("\ufeff") not in ("OFF", "COFF", "NOFF", "CNOFF"):
            raise OSError(f"{name} is not an OFF file: the first word is not OFF")
        sizes = header[1:] or next(lines, [])
        try:
            points = np.array([next(lines)[:3] for _ in range(int(sizes[0]))], dtype=np.float64).reshape(-1, 3)
            faces = [[int(i) for i in words[1 : 1 + int(words[0])]] for words in itertools.islice(lines, int(sizes[1]))]
        except (StopIteration, IndexError, ValueError) as error:
            raise OSError(f"{name} is cut off, or has no numbers where they have to be") from error
    if len(faces) < int(sizes[1]):
        raise OSError(f"{name} is cut off")
    return points, _triangles(name, faces)


def _read_obj(name: str) -> tuple[Doubles, Integers]:
    """Points and faces alone: meshio refuses files with more texture coordinates than points."""
    points: list[list[str]] = []
    faces: list[list[int]] = []
    with open(name) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(words[1:4])
            elif words[:1] == ["f"]:
                corners = [int(word.split("/")[0]) for word in words[1:]]
                faces.append([corner - 1 if corner > 0 else corner + len(points) for corner in corners])
    return np.array(points, dtype=np.float64).reshape(-1, 3), _triangles(name, faces)


def _gifti_gz(name: str) -> Any:
    import gzip

    import nibabel

    with gzip.open(name) as file:
        return nibabel.GiftiImage.from_bytes(file.read())
