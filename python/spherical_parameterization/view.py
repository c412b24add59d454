# SPDX-License-Identifier: LGPL-3.0-or-later
"""The web page of a mesh and its map, by the module `_preparation`, since the page is under the GPL."""

from __future__ import annotations

import html
import json
from dataclasses import asdict, dataclass

import numpy.typing as npt

from . import _core
from .analysis import distortion, face_distortion, segment
from .arrays import OneLine, Sphere, check, file_name, index_triples, sphere_vectors, vectors
from .errors import ErrorCode, MeshError
from .files import Path
from .maps import certify, map_to_go_on
from .prepare import gpl_module


@dataclass(frozen=True, repr=False)
class Page(OneLine):
    """A web page as one HTML file, which loads nothing from elsewhere. Notebooks show it."""

    html: str

    def save(self, path: Path) -> None:
        """Writes the page to a file, which is complete, or does not exist."""
        _core.write_text(file_name("path", path), self.html)

    def __repr__(self) -> str:
        return f"<Page: {len(self.html)} characters of HTML>"

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.html)}" style="width: 100%; height: 640px; border: 0"></iframe>'


def view(
    points: npt.ArrayLike, triangles: npt.ArrayLike, sphere: Sphere | None = None, *, name: str = "mesh",
    policy: str = "parallel",
) -> Page:
    """A web page that shows a mesh and its map beside each other, with stretch, angles and segments as colours: the page of
    the command `view`.

    Parameters
    ----------
    points : array_like (n, 3) of float
    triangles : array_like (m, 3) of int
    sphere : array_like (n, 3) of float, or Result, optional
        A valid map. Default: that of `parameterize()`.
    name : str
        The title.
    policy : {"parallel", "sequential"}

    Returns
    -------
    Page

    Raises
    ------
    MeshError
        If the map is not valid, or for more than 16,777,216 points.
    ImportError
        If the module `_preparation` is not installed. It is under the GPL, and is installed separately.

    Examples
    --------
    >>> import spherical_parameterization as sp
    >>> points, triangles = sp.icosphere(3)
    >>> sp.view(points * [3, 2, 1], triangles).save("ellipsoid.html")  # doctest: +SKIP
    """
    module = gpl_module()
    check(view, locals())
    points, triangles = vectors("points", points), index_triples(triangles)
    result = None
    if sphere is None:
        sphere = result = map_to_go_on(points, triangles, policy=policy, warn=False)
        if not result:
            raise MeshError(result.error, result.detail)
    images = sphere_vectors("sphere", sphere, len(points))
    certificate = certify(triangles, images, policy=policy)
    if not certificate:
        text = f"{certificate.flipped_faces} flipped faces, the degree is {certificate.degree}"
        raise MeshError(ErrorCode.NOT_BIJECTIVE, text)
    mesh = points, triangles, images
    report = {
        "input": name.encode(errors="replace").decode(), "vertices": len(points), "faces": len(triangles), "error": None, "error_code": "OK",
        **asdict(certificate), "distortion": asdict(distortion(*mesh, policy=policy)),
    }
    if result is not None:
        report |= {key: getattr(result, key) for key in ("start_iterations", "iterations", "residual", "fallback_reason")}
        report |= {"method_used": result.method, "weights": "conformal", "seconds": asdict(result.seconds)}
    measures = [
        ("stretch", face_distortion(*mesh, policy=policy)),
        ("angle", face_distortion(*mesh, "angle_distortion", policy=policy)),
        ("segments", segment(*mesh, policy=policy)),
    ]
    return Page(module.page([points, images], triangles, measures, json.dumps(report)))
