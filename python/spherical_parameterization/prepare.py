# SPDX-License-Identifier: LGPL-3.0-or-later
"""Mending meshes, by the command-line tool: it stands on parts of CGAL that are under the GPL, and runs as a program of its own."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import subprocess
import tempfile
from typing import Any

import numpy as np
import numpy.typing as npt

from .arrays import Doubles, Integers, OneLine, check, index_triples, one_of, vectors
from .errors import ErrorCode, MeshError

_CORNERS = np.dtype([("size", "u1"), ("corners", "<i4", 3)])


@dataclasses.dataclass(frozen=True, repr=False)
class Prepared(OneLine):
    """A mended mesh, and where it comes from."""

    points: Doubles  #: (n, 3)
    triangles: Integers  #: (m, 3)
    vertex_map: Integers  #: (n,), for every point its number before, or -1 if it is new
    face_map: Integers  #: (m,), for every triangle its number before, or -1 if it is new
    report: dict[str, Any]  #: as the tool writes it with `--report`; `report["preparation"]["done"]` has it in sentences


def prepare(
    points: npt.ArrayLike,
    triangles: npt.ArrayLike,
    *,
    harmless: bool = False,
    components: str = "largest",
    fill_holes: bool = True,
    cut_handles: bool = True,
    merge_distance: float = 0.0,
    wrap: bool | tuple[float, float] = False,
) -> Prepared:
    """Mends a mesh until it is one closed surface of genus 0: merges points at the same place, orients, cuts non-manifold parts
    from each other, keeps the largest component, fills holes and cuts handles along shortest loops.

    The command-line tool does it, which has to be installed: the program that the environment variable
    SPHERICAL_PARAMETERIZATION_TOOL names, or else `spherical-parameterization` in PATH. Arrays go through files in a
    temporary folder.

    Parameters
    ----------
    points : array (n, 3)
    triangles : array (m, 3) of int
    harmless : bool
        Only what does not change the shape.
    components : "largest" or "all"
    fill_holes, cut_handles : bool
    merge_distance : float
        Up to which points at boundaries are merged.
    wrap : bool or (alpha, offset)
        A surface around everything takes the place of the mesh: what a ball of radius alpha cannot enter is filled.

    Returns
    -------
    Prepared

    Raises
    ------
    MeshError
        If there is no triangle that can be used. Those at points that are not finite cannot.
    FileNotFoundError
        If the tool is not there.
    RuntimeError
        If it failed: with what it said.
    """
    check(prepare, locals())
    one_of("components", components, "largest", "all")
    points, triangles = vectors("points", points), index_triples(triangles)
    if triangles.size and (triangles.min() < 0 or triangles.max() >= len(points)):
        raise MeshError(ErrorCode.BAD_INDEX, "a triangle names a point that is not there; points are numbered from 0 on")
    steps = ["merge", "orient"]
    if not harmless:
        steps += ["largest"] * (components == "largest") + ["holes"] * fill_holes + ["handles"] * cut_handles
    options = ["--steps", ",".join(steps), "--merge-distance", repr(float(merge_distance))]
    if wrap:
        options.append("--wrap")
        if wrap is not True:
            alpha, offset = wrap
            options += ["--alpha", repr(float(alpha)), "--offset", repr(float(offset))]

    tool = _tool()
    with tempfile.TemporaryDirectory(prefix="spherical-parameterization-") as folder:
        path = {name: os.path.join(folder, name) for name in ("in.ply", "out.ply", "vertices", "faces", "report")}
        _write_ply(path["in.ply"], points, triangles)
        maps = ["--vertex-map", path["vertices"], "--face-map", path["faces"], "--report", path["report"]]
        run = subprocess.run(
            [tool, "prepare", path["in.ply"], "-o", path["out.ply"], *maps, *options],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        report: dict[str, Any] = {}
        if os.path.exists(path["report"]):
            with open(path["report"]) as file:
                report = json.load(file)
        if run.returncode != 0:
            if report.get("error_code") in set(ErrorCode):
                raise MeshError(ErrorCode(report["error_code"]), str(report["error"]).removeprefix(path["in.ply"] + ": "))
            raise RuntimeError(f"{tool} failed with exit code {run.returncode}: {run.stderr.strip()}")
        vertex_map, face_map = (np.loadtxt(path[name], dtype=np.int64, ndmin=1) for name in ("vertices", "faces"))
        return Prepared(*_read_ply(path["out.ply"]), vertex_map, face_map, report)


def _tool() -> str:
    named = os.environ.get("SPHERICAL_PARAMETERIZATION_TOOL")
    tool = shutil.which(named or "spherical-parameterization")
    if tool is None:
        where = f"SPHERICAL_PARAMETERIZATION_TOOL names {named!r}, which is no program" if named else "it is not in PATH"
        raise FileNotFoundError(
            f"the command-line tool spherical-parameterization is needed, but {where}; install it, or set "
            "SPHERICAL_PARAMETERIZATION_TOOL"
        )
    return tool


def _write_ply(name: str, points: Doubles, triangles: Integers) -> None:
    faces = np.empty(len(triangles), dtype=_CORNERS)
    faces["size"], faces["corners"] = 3, triangles
    properties = "".join(f"property double {axis}\n" for axis in "xyz")
    with open(name, "wb") as file:
        file.write(
            f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{properties}"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n".encode()
        )
        file.write(points.astype("<f8", copy=False).tobytes())
        file.write(faces.tobytes())


def _read_ply(name: str) -> tuple[Doubles, Integers]:
    """What the tool writes: doubles and triangles, as text or in binary."""
    with open(name, "rb") as file:
        sizes, is_text = {}, False
        for line in iter(file.readline, b"end_header\n"):
            words = line.decode().split()
            is_text = is_text or words[:2] == ["format", "ascii"]
            if words[:1] == ["element"]:
                sizes[words[1]] = int(words[2])
        if is_text:
            points = np.loadtxt(file, max_rows=sizes["vertex"], ndmin=2)
            return points, np.loadtxt(file, dtype=np.int32, max_rows=sizes["face"], ndmin=2)[:, 1:]
        points = np.fromfile(file, "<f8", 3 * sizes["vertex"]).reshape(-1, 3)
        return points, np.fromfile(file, _CORNERS, sizes["face"])["corners"].astype(np.int32)
