# SPDX-License-Identifier: LGPL-3.0-or-later
# The compiled core. Private: arguments are not checked here.
from typing import Any

import numpy as np
import numpy.typing as npt

_Doubles = npt.NDArray[np.float64]
_Integers = npt.NDArray[Any]
_Vector = list[float]

__version__: str

def parameterize(
    points: _Doubles,
    triangles: _Integers,
    method: object,
    weights: object,
    policy: object,
    fixed: object,
    density: _Doubles | None,
    sphere: _Doubles,
    accuracy: float | None,
    iterations: int | None,
    maximum_running_time: float,
    verbose: bool,
    progress: object,
    /,
) -> tuple[dict[str, Any], bool, bool]: ...
def message(code: int, /) -> str: ...
def opencl_devices() -> list[Any]: ...
def opencl_device(name: str, precision: str, smallest_mesh: int, /) -> OpenCLDevice: ...
def certify(triangles: _Integers, sphere: _Doubles, policy: str, /) -> tuple[int, int]: ...
def face_distortion(
    points: _Doubles, triangles: _Integers, sphere: _Doubles, measure: str, policy: str, /
) -> _Doubles: ...
def vertex_log_area_stretch(points: _Doubles, triangles: _Integers, sphere: _Doubles, policy: str, /) -> _Doubles: ...
def mean_over_faces(points: _Doubles, triangles: _Integers, values: _Doubles, /) -> _Doubles: ...
def distortion_summary(
    points: _Doubles, triangles: _Integers, sphere: _Doubles, policy: str, /
) -> tuple[Any, ...]: ...
def segment(
    points: _Doubles, triangles: _Integers, sphere: _Doubles, method: object, stretch: object, policy: str, /
) -> npt.NDArray[np.int32]: ...
def texture_coordinates(
    points: _Doubles, triangles: _Integers, sphere: _Doubles, chart: str, axes: object, bits: int, policy: str, /
) -> tuple[Any, ...]: ...
def texture_seams(points: _Doubles, triangles: _Integers, uv: _Doubles, /) -> npt.NDArray[np.int32]: ...
def icosphere(level: int, /) -> tuple[_Doubles, npt.NDArray[np.int32]]: ...
def shape_signature(points: _Doubles, triangles: _Integers, sphere: _Doubles, policy: str, /) -> _Doubles: ...
def distances(signature: _Doubles, index: _Doubles, /) -> _Doubles: ...
def stretch_histogram(
    points: _Doubles,
    triangles: _Integers,
    sphere: _Doubles,
    sampling: str,
    scale: str,
    bins: int,
    low: float,
    high: float,
    number_of_samples: int,
    seed: int,
    policy: str,
    /,
) -> list[float]: ...

def harmonic_analysis(
    triangles: _Integers,
    sphere: _Doubles,
    values: _Doubles,
    degree: int,
    fit: str,
    weights: str,
    points: object,
    accuracy: float,
    iterations: int,
    policy: str,
    /,
) -> tuple[_Doubles, bool, int]: ...
def harmonic_values(coefficients: _Doubles, directions: _Doubles, policy: str, /) -> _Doubles: ...
def harmonic_grid(coefficients: _Doubles, rows: int, columns: int, policy: str, /) -> _Doubles: ...
def rotated_harmonics(coefficients: _Doubles, rotation: _Doubles, /) -> _Doubles: ...
def best_rotation(f: _Doubles, g: _Doubles, policy: str, /) -> list[_Vector]: ...
def best_alignment(f: _Doubles, g: _Doubles, policy: str, /) -> tuple[list[_Vector], list[_Vector], float]: ...
def mirrored(coefficients: _Doubles, /) -> _Doubles: ...
def first_order_ellipsoid(
    coefficients: _Doubles, /
) -> tuple[list[float], list[float], list[_Vector], list[_Vector]]: ...
def align_shapes(
    shapes: _Doubles,
    are_harmonics: bool,
    weights: list[float],
    rotate: bool,
    scale: bool,
    accuracy: float,
    iterations: int,
    policy: str,
    /,
) -> tuple[_Doubles, list[float], list[list[_Vector]], list[_Vector], float, bool, int]: ...
def shape_statistics(
    shapes: _Doubles, are_harmonics: bool, weights: list[float], modes: int, policy: str, /
) -> tuple[_Doubles, _Doubles, list[float], list[list[float]], float]: ...
def left_out_errors(
    shapes: _Doubles, are_harmonics: bool, weights: list[float], groups: int, policy: str, /
) -> tuple[list[float]]: ...
def mean_vertex_areas(shapes: _Doubles, triangles: _Integers, policy: str, /) -> list[float]: ...
def harmonics_to_text(coefficients: _Doubles, format: str, /) -> str: ...
def harmonics_of_text(text: str, format: str, /) -> _Doubles: ...
def register_maps(
    points_a: _Doubles,
    triangles_a: _Integers,
    sphere_a: _Doubles,
    points_b: _Doubles,
    triangles_b: _Integers,
    sphere_b: _Doubles,
    motion: str,
    curvature_weight: float,
    stretch_weight: float,
    isometry_weight: float,
    position_weight: float,
    landmark_weight: float,
    landmarks: list[tuple[int, int]],
    policy: str,
    maximum_running_time: float,
    progress: object,
    /,
) -> tuple[bool, _Doubles, bool, str, list[_Vector], float, float, float, float, float, int, float]: ...
def moebius_centred(sphere: _Doubles, triangles: _Integers, masses: _Doubles, /) -> tuple[_Doubles, float]: ...

class OpenCLDevice:
    @property
    def name(self) -> str: ...
    @property
    def is_double_precision(self) -> bool: ...
    @property
    def smallest_mesh(self) -> int: ...

class Locator:
    def __init__(self, triangles: _Integers, sphere: _Doubles, policy: str, /) -> None: ...
    def locate(self, directions: _Doubles, policy: str, /) -> tuple[npt.NDArray[np.int32], _Doubles]: ...
    def interpolate(self, values: _Doubles, faces: npt.NDArray[np.int32], weights: _Doubles, /) -> _Doubles: ...
    def align(self, points: _Doubles, other: Locator, other_points: _Doubles, policy: str, /) -> list[_Vector]: ...
