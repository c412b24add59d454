# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes mended."""

import importlib.util
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import Tool, bumpy, refused, torus

import spherical_parameterization as sp


if not importlib.util.find_spec("spherical_parameterization._preparation"):
    pytest.skip("the module under the GPL is not there", allow_module_level=True)


def test_a_good_mesh_is_not_changed() -> None:
    points, triangles = bumpy(3)
    prepared = sp.prepare(points, triangles)
    assert np.array_equal(prepared.points, points)
    assert np.array_equal(prepared.triangles, triangles)
    assert np.array_equal(prepared.vertex_map, np.arange(len(points)))
    assert prepared.report["preparation"]["done"] == [] and prepared != sp.prepare(points, triangles)


@pytest.mark.parametrize("kind", ["hole", "handle", "soup", "two"])
def test_what_comes_out_is_mapped(kind: str) -> None:
    points, triangles = torus() if kind == "handle" else bumpy(3)
    if kind == "hole":
        triangles = triangles[5:]
    elif kind == "soup":
        points, triangles = points[triangles].reshape(-1, 3), np.arange(triangles.size).reshape(-1, 3)
    elif kind == "two":
        points, triangles = np.concatenate([points, points + 9]), np.concatenate([triangles, triangles + len(points)])
    prepared = sp.prepare(points, triangles)
    assert prepared.report["preparation"]["done"]
    old = prepared.vertex_map >= 0
    assert np.array_equal(prepared.points[old], points[prepared.vertex_map[old]])
    assert sp.parameterize(prepared.points, prepared.triangles, sp.Automatic()).is_valid


def test_options() -> None:
    points, triangles = bumpy(3)
    assert np.array_equal(sp.prepare(points, triangles[5:], fill_holes=False).triangles, triangles[5:])
    assert len(sp.prepare(*torus(), cut_handles=False).triangles) == len(torus()[1])
    assert (sp.prepare(points, triangles[5:], wrap=(1.0, 0.1)).vertex_map == -1).all()
    with pytest.raises(ValueError, match="components"):
        sp.prepare(points, triangles, components="split")


def test_a_point_that_is_not_finite_is_left_out() -> None:
    points, triangles = bumpy(2)
    points[7] = np.nan
    prepared = sp.prepare(points, triangles)
    assert np.isfinite(prepared.points).all() and 7 not in prepared.vertex_map
    assert sp.parameterize(prepared.points, prepared.triangles).is_valid


def test_the_tool_does_the_same(tool: Tool, tmp_path: Path) -> None:
    points, triangles = bumpy(3)
    points, triangles = np.concatenate([points, torus()[0]]), np.concatenate([triangles[5:], torus()[1] + len(points)])
    report = tmp_path / "report.json"
    expected = sp.read_mesh(tool("prepare", points, triangles, "--report", str(report), out="out.ply"))
    prepared = sp.prepare(points, triangles)
    assert np.array_equal(prepared.points, expected[0]) and np.array_equal(prepared.triangles, expected[1])
    said = json.loads(report.read_text())
    assert {key: said[key] for key in prepared.report} == prepared.report


def test_errors() -> None:
    points, triangles = bumpy(2)
    with refused("EMPTY_MESH"):
        sp.prepare(points, triangles[:0])
    with pytest.raises(sp.MeshError):
        sp.prepare(points * [1, np.nan, 1], triangles)
    for wrong in ({"merge_distance": -1.0}, {"wrap": (1.0, 0.0)}, {"maximum_running_time": -1.0}):
        with pytest.raises(ValueError):
            sp.prepare(points, triangles, **wrong)  # type: ignore[arg-type]
    for wrong in ({"merge_distance": 0.1}, {"wrap": True}):
        with pytest.raises(ValueError, match="harmless: "):
            sp.prepare(points, triangles, harmless=True, **wrong)  # type: ignore[arg-type]
    with refused("INTERRUPTED"):
        sp.prepare(*torus(), maximum_running_time=0.0)
