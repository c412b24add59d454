# SPDX-License-Identifier: LGPL-3.0-or-later
"""What can go wrong: codes, exceptions, and the warning about maps that are not certified."""

from __future__ import annotations

import enum


class ErrorCode(str, enum.Enum):
    """What can be wrong with a mesh, or with the map that was found. Members compare equal to their names.

    >>> import spherical_parameterization as sp
    >>> sp.ErrorCode.BOUNDARY == "BOUNDARY"
    True
    """

    OK = "OK"  #: certified: no flipped face, degree 1, residual below the accuracy
    EMPTY_MESH = "EMPTY_MESH"  #: no face
    TOO_LARGE = "TOO_LARGE"  #: 2^31 halfedges or more
    NOT_TRIANGULAR = "NOT_TRIANGULAR"  #: a face that is not a triangle
    ISOLATED_VERTEX = "ISOLATED_VERTEX"  #: a vertex without faces
    BOUNDARY = "BOUNDARY"  #: border edges: the surface is not closed
    NON_MANIFOLD = "NON_MANIFOLD"  #: a vertex or edge whose faces do not form a single disk
    INCONSISTENT_ORIENTATION = "INCONSISTENT_ORIENTATION"  #: neighbouring faces of opposite orientations
    SEVERAL_COMPONENTS = "SEVERAL_COMPONENTS"  #: more than one connected component
    WRONG_GENUS = "WRONG_GENUS"  #: handles: not a topological sphere
    NON_FINITE_COORDINATE = "NON_FINITE_COORDINATE"  #: NaN or infinity in a point
    DEGENERATE_FACE = "DEGENERATE_FACE"  #: a face without area, or an edge without length, where one is needed
    BAD_WEIGHT = "BAD_WEIGHT"  #: an edge weight that is not positive and finite
    BAD_CONSTRAINTS = "BAD_CONSTRAINTS"  #: fixed vertices: one or two, at equal positions, a zero vector; or the mesh is too coarse
    NOT_CONVERGED = "NOT_CONVERGED"  #: the residual did not reach the accuracy
    INTERRUPTED = "INTERRUPTED"  #: stopped by Ctrl-C, by `progress`, or by the time limit
    NOT_BIJECTIVE = "NOT_BIJECTIVE"  #: converged, but faces are flipped or the degree is not 1
    BAD_INDEX = "BAD_INDEX"  #: a triangle that names a point that is not there
    BAD_DENSITY = "BAD_DENSITY"  #: a density that is not positive and finite

    def __str__(self) -> str:
        return self.value

    @property
    def message(self) -> str:
        """The code in words."""
        from . import _core

        return _core.message(_CODES.index(self))


_CODES = tuple(ErrorCode)


class MeshError(ValueError):
    """There is no map: something is wrong with the mesh, the weights or the fixed vertices.

    Parameters
    ----------
    code : ErrorCode or int
        What is wrong, or its number in the core.
    detail : str
        What exactly, where, and what to do about it.

    Attributes
    ----------
    code : ErrorCode
    detail : str
    """

    code: ErrorCode
    detail: str

    def __init__(self, code: ErrorCode | int, detail: str) -> None:
        super().__init__(code, detail)  # what pickle calls it with
        self.code = code if isinstance(code, ErrorCode) else _CODES[code]
        self.detail = detail

    def __str__(self) -> str:
        return f"{self.code.message}: {self.detail}" if self.detail else self.code.message


class DeviceError(RuntimeError):
    """An OpenCL device is not there, or has failed."""


class MapWarning(UserWarning):
    """There is a map, and it is not certified: `Result.error` and `Result.detail` say why."""
