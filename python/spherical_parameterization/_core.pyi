# SPDX-License-Identifier: LGPL-3.0-or-later
# The compiled core. Private: arguments are not checked here.
from typing import Any

__version__: str

class OpenCLDevice:
    @property
    def name(self) -> str: ...
    @property
    def is_double_precision(self) -> bool: ...
    @property
    def smallest_mesh(self) -> int: ...

def __getattr__(name: str) -> Any: ...
