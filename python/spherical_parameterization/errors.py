# SPDX-License-Identifier: LGPL-3.0-or-later
"""Error codes, exceptions, and the warning about maps that are not certified."""

from __future__ import annotations

import enum
import inspect
from typing import TYPE_CHECKING

from . import _core

_SENTENCES = dict(_core.error_codes())  # the list is in the header values/Error.h


class _Names(enum.EnumMeta):
    if TYPE_CHECKING:

        def __getattr__(cls, name: str) -> ErrorCode: ...


class ErrorCode(str, enum.Enum, metaclass=_Names):
    """What is wrong with a mesh, or with a map. Members compare equal to their names.

    >>> import spherical_parameterization as sp
    >>> sp.ErrorCode.BOUNDARY == "BOUNDARY"
    True
    """

    _ignore_ = ["_members", "_code"]
    _members = vars()
    for _code in _SENTENCES:
        _members[_code] = _code

    def __str__(self) -> str:
        return str(self.value)

    @property
    def message(self) -> str:
        """The code in words."""
        return _SENTENCES[self.value]


_LIST = "".join(f"{name}\n    {sentence}\n" for name, sentence in _SENTENCES.items())
ErrorCode.__doc__ = f"{inspect.getdoc(ErrorCode)}\n\nAttributes\n----------\n{_LIST}"


class MeshError(ValueError):
    """There is no map: something is wrong with the mesh, the weights or the fixed vertices.

    Parameters
    ----------
    code : ErrorCode or str
        What is wrong, or its name.
    detail : str
        What exactly, where, and what to do about it.

    Attributes
    ----------
    code : ErrorCode
    detail : str
    """

    code: ErrorCode
    detail: str

    def __init__(self, code: ErrorCode | str, detail: str) -> None:
        super().__init__(code, detail)  # what pickle calls it with
        self.code = ErrorCode(code)
        self.detail = detail

    def __str__(self) -> str:
        return f"{self.code.message}: {self.detail}" if self.detail else self.code.message


class DeviceError(RuntimeError):
    """An OpenCL device does not exist, or has failed."""


class MapWarning(UserWarning):
    """There is a map, but it is not certified; `Result.error` and `Result.detail` say why."""
