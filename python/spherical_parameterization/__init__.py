# SPDX-License-Identifier: LGPL-3.0-or-later
"""Certified maps of closed triangle meshes of genus 0 to the sphere. Arrays in, arrays out.

>>> import spherical_parameterization as sp
>>> points, triangles = sp.icosphere(4)
>>> result = sp.parameterize(points * [3, 2, 1], triangles)
>>> result.is_valid
True
"""

from . import collection
from ._core import OpenCLDevice, __version__
from .analysis import (
    DistortionSummary, Distribution, LengthChanges, Locator, Resampling, Texture, distortion, face_distortion, icosphere,
    length_changes, mean_over_faces, relevance, search, segment, shape_form, shape_signature, stretch_histogram, texture_coordinates, texture_seams,
    vertex_log_area_stretch,
)
from .atlas import Atlas, atlas
from .errors import DeviceError, ErrorCode, MapWarning, MeshError
from .files import VertexColumn, read_data, read_mesh, write_data, write_mesh
from .maps import Attempt, Certificate, Result, Seconds, certify, edges, opencl_device, opencl_devices, parameterize
from .methods import (
    Automatic, Balanced, ClampedWeights, GirthProfiles, Isometric, MajorityVote, RegionGrowing, SaddlePoint,
)
from .prepare import Prepared, prepare
from .registration import RegisteredMap, moebius_centred, morph, register_maps
from .spherical_harmonics import Ellipsoid, Harmonics, ShapeAlignment, harmonics, read_harmonics
from .spectrum import Eigenpairs, laplacian_eigenpairs
from .statistics import (
    ModelQuality, ShapeSet, ShapeStatistics, align_shapes, left_out_errors, mean_vertex_areas, model_quality,
    shape_statistics,
)
from .view import Page, view

__all__ = [
    "Atlas", "Attempt", "Automatic", "Balanced", "Certificate", "ClampedWeights", "DeviceError", "DistortionSummary",
    "Distribution", "Eigenpairs", "Ellipsoid", "ErrorCode", "GirthProfiles", "Harmonics", "Isometric",
    "LengthChanges", "Locator", "MajorityVote", "MapWarning", "MeshError", "ModelQuality", "OpenCLDevice", "Page", "Prepared", "RegionGrowing",
    "RegisteredMap", "Resampling", "Result", "SaddlePoint", "Seconds", "ShapeAlignment", "ShapeSet", "ShapeStatistics",
    "Texture", "VertexColumn", "__version__", "align_shapes", "atlas", "certify", "collection", "distortion", "edges",
    "face_distortion", "harmonics", "icosphere", "laplacian_eigenpairs", "left_out_errors", "length_changes",
    "mean_over_faces", "mean_vertex_areas", "model_quality", "moebius_centred", "morph", "opencl_device", "opencl_devices", "parameterize",
    "prepare", "read_data", "read_harmonics", "read_mesh", "register_maps", "relevance", "search", "segment",
    "shape_form", "shape_signature", "shape_statistics", "stretch_histogram", "texture_coordinates", "texture_seams", "vertex_log_area_stretch",
    "view", "write_data", "write_mesh",
]
