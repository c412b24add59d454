# SPDX-License-Identifier: LGPL-3.0-or-later
"""Mesh files and values at their vertices, by the readers and writers of the command-line tool."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral
from typing import Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Doubles, Integers, Sphere, check, check_indices, file_name, index_triples, numbers, unit_vectors, vectors
from .errors import ErrorCode, MeshError

Path = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True, eq=False)
class VertexColumn:
    """Numbers or labels at the vertices of a mesh.

    Attributes
    ----------
    name : str
    values : array_like (n,) of float
        The numbers, or the keys of labels. NaN means that a vertex has none.
    labels : dict of int to (str, (float, float, float, float)), optional
        The names and colours (red, green, blue, alpha, from 0 to 1) of labels by their keys. None means that the values are
        numbers, which may be interpolated.
    """

    name: str
    values: npt.ArrayLike
    labels: dict[int, tuple[str, tuple[float, float, float, float]]] | None = None


def read_data(path: Path, number_of_vertices: int) -> list[VertexColumn]:
    """Reads numbers and labels at the vertices of a mesh, in the order of the vertices.

    Parameters
    ----------
    path : str or path
        A FreeSurfer file (curv as lh.thickness, .annot or .label), a GIFTI file (.func.gii, .shape.gii or .label.gii), a
        .csv file whose first line has the names of the columns, or a PLY or VTK file of a surface with data. Columns of
        words in .csv files, columns of `int` in PLY files and of 32-bit or 64-bit integers in VTK files are labels.
    number_of_vertices : int

    Returns
    -------
    list of VertexColumn

    Raises
    ------
    OSError
        If the file cannot be read, is damaged, or has data for another number of vertices. The message says where.
    """
    check(read_data, locals())
    file = file_name("path", path)
    os.stat(path)  # FileNotFoundError
    columns = []
    for name, values, table in _core.read_data(file, number_of_vertices):
        labels = None
        if table is not None:
            labels = {key: (text.decode(errors="replace"), (r, g, b, a)) for key, text, (r, g, b, a) in table}
        columns.append(VertexColumn(name.decode(errors="replace"), values, labels))
    return columns


def write_data(path: Path, columns: Sequence[VertexColumn]) -> None:
    """Writes numbers and labels at vertices to a file. The file is complete, or does not exist.

    Parameters
    ----------
    path : str or path
        .csv holds all columns, .func.gii and .shape.gii hold numbers, .label.gii and .annot hold labels, .annot with the keys 0, 1, 2, ... FreeSurfer's .label
        holds one column of numbers, and lists the vertices that have one. Any other name that begins with lh. or rh. is that
        of a FreeSurfer curv file, which holds one column of numbers. Columns that the format does not hold are left out.
    columns : sequence of VertexColumn

    Raises
    ------
    ValueError
        If the name belongs to no format that can be written.
    OSError
        If the format holds none of the columns, or the file cannot be written.
    """
    _core.write_data(file_name("path", path), _for_core(columns))


def _for_core(columns: Sequence[VertexColumn], size: int | None = None) -> list[tuple[bytes, Doubles, object]]:
    if not isinstance(columns, Sequence) or not all(isinstance(column, VertexColumn) for column in columns):
        raise TypeError("columns: a list of VertexColumn is needed")
    result: list[tuple[bytes, Doubles, object]] = []
    for column in columns:
        check(VertexColumn, vars(column))
        if not column.name:
            raise ValueError("columns: a name is empty")
        size = np.size(np.asarray(column.values)) if size is None else size
        values = numbers(column.name, column.values, size)
        are_keys = np.isnan(values) | ((values == np.round(values)) & (values >= -(2**31)) & (values < 2**31))
        if column.labels is not None and not are_keys.all():
            raise ValueError(f"{column.name}: the values of labels are integers, or NaN where there is none")
        result.append((column.name.encode(), values, _table(column)))
    return result


def _table(column: VertexColumn) -> list[tuple[int, bytes, tuple[float, ...]]] | None:
    if column.labels is None:
        return None
    wrong = TypeError(f"{column.name}: labels: a dict of whole numbers to (name, (red, green, blue, alpha)) is needed")
    if not isinstance(column.labels, Mapping) or not all(isinstance(key, Integral) for key in column.labels):
        raise wrong
    if not all(-(2**31) <= key < 2**31 for key in column.labels):
        raise ValueError(f"{column.name}: the keys of labels are integers of 32 bits")
    try:
        return [
            (int(key), name.encode(), (float(r), float(g), float(b), float(a)))
            for key, (name, (r, g, b, a)) in column.labels.items()
        ]
    except (AttributeError, TypeError, ValueError):
        raise wrong from None


def read_mesh(path: Path, *, triangulate: bool = False) -> tuple[Doubles, Integers]:
    """Reads points and triangles from a file: OFF, OBJ, PLY, STL, GIFTI, FreeSurfer and MNI surfaces, VTK and glTF, also compressed.

    The format is recognized by the contents of the file. In STL and glTF files, points at the same position are merged; meshes
    of glTF are where their nodes put them, skinned ones at rest, without morph targets.
    Files of other formats are read by meshio, if it is installed.

    Parameters
    ----------
    path : str or path
    triangulate : bool
        Whether to cut polygons into triangles, by diagonals inside them.

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
    name = file_name("path", path)
    os.stat(path)  # FileNotFoundError
    if not _core.is_format_known(name):
        try:
            import meshio
        except ImportError:
            pass
        else:
            if os.path.splitext(os.fsdecode(path))[1].lower() in meshio.extension_to_filetypes:
                return _by_meshio(os.fsdecode(path), triangulate)
    return _core.read_mesh(name, triangulate)


def _by_meshio(name: str, triangulate: bool) -> tuple[Doubles, Integers]:
    import meshio

    try:
        mesh = meshio.read(name)
    except MemoryError:
        raise
    except (SystemExit, Exception) as error:  # what it raises depends on the damage; some versions of it exit
        raise OSError(f"{name}: meshio cannot read it: {error}") from error
    polygons = ("triangle", "quad", "polygon") if triangulate else ("triangle",)
    others = sorted({c.type for c in mesh.cells if c.type not in (*polygons, "vertex", "line")})
    if others:
        raise MeshError(ErrorCode.NOT_TRIANGULAR, f"{name} has cells of type {', '.join(others)}; triangulate it")
    cells = [np.ascontiguousarray(c.data, dtype=np.int64) for c in mesh.cells if c.type in polygons]
    if any(cell.ndim != 2 or cell.shape[1] < 3 for cell in cells):
        raise MeshError(ErrorCode.NOT_TRIANGULAR, f"{name} has faces of fewer than three vertices")
    if not cells:
        raise MeshError(ErrorCode.EMPTY_MESH, f"{name} has no triangles")
    points = np.ascontiguousarray(mesh.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise MeshError(ErrorCode.EMPTY_MESH, f"{name} is a mesh of the plane; a surface in space is needed")
    return points, _core.triangles_of(os.fsencode(name), points, cells)


def write_mesh(
    path: Path, points: Sphere, triangles: npt.ArrayLike, *, sphere: bool = False, ascii: bool = False,
    like: Path | None = None, data: Sequence[VertexColumn] = (),
) -> None:
    """Writes a mesh to a file. The file is complete, or does not exist.

    Parameters
    ----------
    path : str or path
        .off, .obj, .ply, .gii, .vtk, .vtp, .glb, .gltf, or lh.NAME and rh.NAME for FreeSurfer, also followed by .gz, .xz, .zst or .bz2.
    points : array_like (n, 3) of float
    triangles : array_like (m, 3) of int
    sphere : bool
        Whether the points are a map. They are then written on the unit sphere, and to GIFTI and FreeSurfer files on one of radius 100,
        as neuroimaging programs expect.
    ascii : bool
        Whether to write PLY, VTK and VTP as text.
    like : str or path, optional
        A file from which the GIFTI metadata or the FreeSurfer volume geometry are taken.
    data : sequence of VertexColumn
        Columns at the points, written to .ply, .vtk and .vtp.

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
    points, triangles = (unit_vectors if sphere else vectors)("points", points), index_triples(triangles)
    check_indices(triangles, len(points))
    annotated = b"" if like is None else file_name("like", like)
    _core.write_mesh(file_name("path", path), points, triangles, sphere, ascii, annotated, _for_core(data, len(points)))
