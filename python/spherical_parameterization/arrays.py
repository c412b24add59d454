# SPDX-License-Identifier: LGPL-3.0-or-later
"""Arrays as the core reads them. What already has the right type and order is not copied."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import ErrorCode, MeshError

Doubles = npt.NDArray[np.float64]
Integers = npt.NDArray[Any]


def vectors(name: str, values: npt.ArrayLike, rows: int | None = None) -> Doubles:
    """An array (n, 3) of float64 in C order."""
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3 or rows not in (None, array.shape[0]):
        wanted = "(n, 3)" if rows is None else f"({rows}, 3)"
        raise ValueError(f"{name}: shape {wanted} is needed, not {array.shape}")
    return array


def numbers(name: str, values: npt.ArrayLike, size: int) -> Doubles:
    """An array (size,) of float64 in C order."""
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.shape != (size,):
        raise ValueError(f"{name}: shape ({size},) is needed, not {array.shape}")
    return array


def index_triples(triangles: npt.ArrayLike) -> Integers:
    """An array (m, 3) of int32 or int64 in C order."""
    array = np.asarray(triangles)
    if array.dtype.kind not in "iu":
        raise TypeError(f"triangles: integers are needed, not {array.dtype}")
    if array.ndim != 2:
        raise ValueError(f"triangles: shape (m, 3) is needed, not {array.shape}")
    if array.shape[1] != 3:
        raise MeshError(ErrorCode.NOT_TRIANGULAR, f"faces have {array.shape[1]} corners; triangulate the mesh first")
    is_native = array.dtype in (np.dtype(np.int32), np.dtype(np.int64))
    return np.ascontiguousarray(array, dtype=array.dtype if is_native else np.int64)


def edge_numbers(triangles: Integers) -> tuple[Integers, Integers]:
    """The edges (k, 2), and for every corner of a face the number of the edge to its next corner (m, 3)."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2).astype(np.int64)
    ends.sort(axis=1)
    size = int(ends.max(initial=0)) + 1
    keys, number = np.unique(ends[:, 0] * size + ends[:, 1], return_inverse=True)
    return np.stack([keys // size, keys % size], axis=1), number.reshape(-1, 3)
