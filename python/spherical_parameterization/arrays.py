# SPDX-License-Identifier: LGPL-3.0-or-later
"""Arguments as the core takes them: types and ranges are checked here. Arrays that are right already are not copied."""

from __future__ import annotations

import dataclasses
import math
import numbers as kinds
import os
import sys
from collections.abc import Callable, Mapping
from typing import Any, Protocol, Union

import numpy as np
import numpy.typing as npt

from .errors import ErrorCode, MeshError

Doubles = npt.NDArray[np.float64]
Integers = npt.NDArray[Any]


class Mapped(Protocol):
    """A result that has a map."""

    @property
    def sphere(self) -> Doubles: ...


Sphere = Union[npt.ArrayLike, Mapped]

_KINDS = {
    "str": (str, "a string"),
    "bool": ((bool, np.bool_), "True or False"),
    "int": (kinds.Integral, "a whole number"),
    "float": (kinds.Real, "a number"),
}
_WEIGHTS = ("curvature_weight", "stretch_weight", "isometry_weight", "position_weight")  # of register_maps()
_RANGES: dict[str, tuple[float, float]] = {
    "level": (0, 12),
    "bits": (1, 52),
    "degree": (0, 16383),
    "rounds": (1, 2**31 - 1),
    "seed": (0, 2**32 - 1),
    "maximum_running_time": (0, math.inf),
    "batch_seconds": (sys.float_info.min, math.inf),
    "stall_seconds": (sys.float_info.min, math.inf),
    **dict.fromkeys(_WEIGHTS, (0, sys.float_info.max)),
}


def wrong_type(name: str, wanted: str, value: object) -> TypeError:
    """The exception that says what an argument may be."""
    return TypeError(f"{name}: {wanted} is needed, not {type(value).__name__}")


def file_name(name: str, value: object) -> bytes:
    """As the core takes it, for which "-" is the standard input."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise wrong_type(name, "the name of a file", value)
    file = os.fsencode(value)
    if b"\0" in file:
        raise ValueError(f"{name}: a name has no zero byte")
    return b"./-" if file == b"-" else file


def check(function: Callable[..., object] | type, arguments: Mapping[str, object]) -> None:
    """Whether arguments, or the fields of a dataclass, are strings, numbers or truth values where annotations say so.

    Whole numbers are in the range that the core takes, the names of `_RANGES` in theirs.
    """
    for name, annotation in function.__annotations__.items():
        kind, _, other = str(annotation).partition(" | ")
        if name not in arguments or kind not in _KINDS or other not in ("", "None"):
            continue
        value: Any = arguments[name]
        if value is None and other:
            continue
        allowed, wanted = _KINDS[kind]
        if not isinstance(value, allowed) or (isinstance(value, bool) and kind != "bool"):  # type: ignore[arg-type]
            raise wrong_type(name, wanted + " or None" * bool(other), value)
        if kind == "float" and abs(value) > sys.float_info.max and not isinstance(value, (float, np.floating)):
            raise ValueError(f"{name}: a number of at most 1.8e308 is needed")
        low, high = _RANGES.get(name, (0, 2**31 - 1) if kind == "int" else (-math.inf, math.inf))
        if kind in ("int", "float") and not low <= value <= high:
            needed = "a number" if low == -math.inf else f"{low:g} to {high:.10g}"
            raise ValueError(f"{name}: {needed} is needed, not {value}")


def one_of(option: str, value: object, *allowed: str) -> None:
    """Raises ValueError for a word that is not among the allowed ones, TypeError for what is no word."""
    if not isinstance(value, str):
        raise wrong_type(option, f"one of {', '.join(map(repr, allowed))}", value)
    if value not in allowed:
        raise ValueError(f"{option} {value!r}: one of {', '.join(map(repr, allowed))} is needed")


def chosen(name: str, value: object, choices: Mapping[str, type]) -> Any:
    """An object of one of the classes, which may be given as itself, by its class, or by its word."""
    classes = tuple(choices.values())
    if isinstance(value, str):
        one_of(name, value, *choices)
        value = choices[value]
    if isinstance(value, type) and issubclass(value, classes):
        value = value()
    if not isinstance(value, classes):
        words = f"one of {', '.join(map(repr, choices))}, or of {', '.join(c.__name__ + '()' for c in classes)}"
        raise wrong_type(name, words, value)
    return value


def doubles(name: str, values: object) -> Doubles:
    """float64 in C order."""
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{name}: numbers are needed, as many in every row: {error}") from None
    except TypeError as error:  # of an array that is not in the memory of this process
        raise TypeError(f"{name}: {error}") from None
    try:
        if array.dtype.kind in "US":
            raise ValueError("there is text")
        if array.dtype.kind in "fiubO" and values is not None:
            return np.require(array, np.float64, ["C", "ALIGNED"])
    except ValueError as error:  # text
        raise ValueError(f"{name}: numbers are needed, as many in every row: {error}") from None
    except TypeError:  # objects that are no numbers
        pass
    kind = type(values).__name__ if array.dtype.kind == "O" else array.dtype
    raise TypeError(f"{name}: an array of real numbers is needed, not {kind}")


def vectors(name: str, values: object, rows: int | None = None) -> Doubles:
    """An array (n, 3) of float64 in C order."""
    array = doubles(name, values)
    if array.ndim != 2 or array.shape[1] != 3 or rows not in (None, array.shape[0]):
        wanted = "(n, 3)" if rows is None else f"({rows}, 3)"
        raise ValueError(f"{name}: shape {wanted} is needed, not {array.shape}")
    return array


def sphere_vectors(name: str, values: Sphere, rows: int | None = None) -> Doubles:
    """A map, as it is, unless squares of lengths would overflow or vanish: then on the unit sphere."""
    array = vectors(name, getattr(values, "sphere", values), rows)
    sizes = abs(array).max(axis=1)
    is_extreme = (1e100 < sizes.max(initial=0) < np.inf) or sizes[sizes > 0].min(initial=1) < 1e-100
    return unit_vectors(name, array, rows) if is_extreme else array


def unit_vectors(name: str, values: Sphere, rows: int | None = None) -> Doubles:
    """A map on a sphere of any radius as one on the unit sphere; unit vectors, also those of float32, stay as they are."""
    array = vectors(name, getattr(values, "sphere", values), rows)
    with np.errstate(all="ignore"):
        is_other = ~(abs(np.linalg.norm(array, axis=1) - 1) < 1e-6)
        if is_other.any():
            others = array[is_other] / abs(array[is_other]).max(axis=1, keepdims=True)
            array = array.copy()
            array[is_other] = others / np.linalg.norm(others, axis=1, keepdims=True)
            if not np.isfinite(array).all():
                row = int(np.flatnonzero(~np.isfinite(array).all(axis=1))[0])
                raise MeshError(ErrorCode.NON_FINITE_COORDINATE, f"{name}: row {row} is no direction: zero or not finite")
    return array


def numbers(name: str, values: object, size: int) -> Doubles:
    """An array (size,) of float64 in C order."""
    array = doubles(name, values)
    if array.shape != (size,):
        raise ValueError(f"{name}: shape ({size},) is needed, not {array.shape}")
    return array


def integers(name: str, values: object) -> Integers:
    """Of any size; nothing is as good as an array of none."""
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name}: integers are needed, as many in every row: {error}") from None
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None
    if array.dtype.kind not in "iu" and (array.size > 0 or array.ndim == 0):
        raise TypeError(f"{name}: integers are needed, not {array.dtype}")
    return array if array.dtype.kind in "iu" else array.astype(np.int64)


def index_triples(triangles: npt.ArrayLike, name: str = "triangles") -> Integers:
    """An array (m, 3) of int32 or int64 in C order."""
    array = integers(name, triangles)
    if array.ndim != 2:
        raise ValueError(f"{name}: shape (m, 3) is needed, not {array.shape}")
    if array.shape[1] != 3:
        raise MeshError(ErrorCode.NOT_TRIANGULAR, f"faces have {array.shape[1]} corners; triangulate the mesh first")
    is_native = array.dtype in (np.dtype(np.int32), np.dtype(np.int64))
    return np.require(array, array.dtype if is_native else np.int64, ["C", "ALIGNED"])


def check_indices(triangles: Integers, number_of_points: int) -> None:
    """Whether the points of the triangles are there."""
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < number_of_points:
        raise MeshError(ErrorCode.BAD_INDEX, "a triangle names a point that is not there; points are numbered from 0 on")


def edge_numbers(triangles: Integers) -> tuple[Integers, Integers]:
    """The edges (k, 2), and for every corner of a face the number of the edge to its next corner (m, 3)."""
    check_indices(triangles, 2**31)
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2).astype(np.int64)
    ends.sort(axis=1)
    size = int(ends.max(initial=0)) + 1
    keys, number = np.unique(ends[:, 0] * size + ends[:, 1], return_inverse=True)
    return np.stack([keys // size, keys % size], axis=1), number.reshape(-1, 3)


class OneLine:
    """For dataclasses of arrays: printed as one line, with the shapes of the arrays."""

    def __repr__(self) -> str:
        values = ((field.name, getattr(self, field.name)) for field in dataclasses.fields(self))
        parts = (f"{name}: {v.shape}" if isinstance(v, np.ndarray) else f"{name}={v!r}" for name, v in values)
        return f"<{type(self).__name__} {', '.join(parts)}>"
