# SPDX-License-Identifier: GPL-3.0-or-later
"""The same bits as the command-line tool."""

import json
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import Tool, bumpy, ellipsoid, tube

MESHES = {"ellipsoid": ellipsoid(), "bumpy": bumpy(5, 3), "tube": tube()}
SETTINGS = {
    "automatic": (["--method", "automatic"], {}),
    "balanced": (["--method", "balanced", "--weights", "barycentric"], {"method": sp.Balanced(), "weights": "barycentric"}),
    "exponent": (["--method", "balanced", "--spring-exponent", "3"], {"method": sp.Balanced(3)}),
    "mean value": (["--method", "balanced", "--weights", "mean-value"], {"method": sp.Balanced(), "weights": "mean-value"}),
    "conformal": (["--method", "balanced"], {"method": sp.Balanced()}),
    "clamped": (
        ["--method", "balanced", "--weights", "clamped", "--min-angle", "20", "--max-angle", "80"],
        {"method": sp.Balanced(), "weights": sp.ClampedWeights(20, 80)},
    ),
    "isometric": (["--method", "isometric", "--area-exponent", "2"], {"method": sp.Isometric(2)}),
}


@pytest.mark.parametrize("settings", SETTINGS)
@pytest.mark.parametrize("mesh", MESHES)
def test_maps(tool: Tool, tmp_path: Path, mesh: str, settings: str) -> None:
    options, arguments = SETTINGS[settings]
    result = sp.parameterize(*MESHES[mesh], **arguments, warn=False)
    if not result:
        pytest.skip("the tool writes certified maps only")
    report = tmp_path / "report.json"
    sphere, _ = sp.read_mesh(tool("map", *MESHES[mesh], *options, "--report", str(report)))
    assert (result.sphere == sphere).all()
    expected = json.loads(report.read_text())
    assert result.method == expected["method_used"]
    for key in ("iterations", "residual", "energy", "flipped_faces", "moved_vertices", "degree"):
        assert getattr(result, key) == expected[key]
    summary = sp.distortion(*MESHES[mesh], result.sphere)
    for measure in ("log_area_stretch", "angle_distortion", "dilatation", "symmetric_dirichlet"):
        found = getattr(summary, measure)
        assert (found.mean, found.deviation, found.median, found.max) == tuple(
            expected["distortion"][measure][key] for key in ("mean", "standard_deviation", "median", "max")
        )


def test_fixed_vertices(tool: Tool, tmp_path: Path) -> None:
    points, triangles = ellipsoid(3)
    directions = np.vstack([np.eye(3), -np.eye(3)])  # unit vectors without rounding
    numbers = np.argmax(points @ directions.T, axis=0)
    file = tmp_path / "fixed.txt"
    np.savetxt(file, np.column_stack([numbers, directions]), ["%d", "%.17g", "%.17g", "%.17g"])
    result = sp.parameterize(points, triangles, sp.Balanced(), fixed=(numbers, directions))
    sphere, _ = sp.read_mesh(tool("map", points, triangles, "--method", "balanced", "--fixed", str(file)))
    assert (result.sphere == sphere).all()


def test_resample(tool: Tool) -> None:
    points, triangles = bumpy()
    sphere = sp.parameterize(points, triangles, sp.Isometric()).sphere
    expected = sp.read_mesh(tool("resample", points, triangles, "--level", "4"))
    found = sp.Locator(triangles, sphere).resample(points, 4)
    assert (found[0] == expected[0]).all() and (found[1] == expected[1]).all()


def test_segments(tool: Tool, tmp_path: Path) -> None:
    points, triangles = tube(40)
    sphere = sp.parameterize(points, triangles, sp.Balanced(), weights="clamped").sphere
    labels = tmp_path / "labels.txt"
    tool("segment", points, triangles, "--labels", str(labels), out="segments.ply")
    assert (sp.segment(points, triangles, sphere) == np.loadtxt(labels, dtype=int)).all()


@pytest.mark.parametrize("chart", ["latitude-longitude", "octahedral"])
def test_texture(tool: Tool, chart: str) -> None:
    points, triangles = bumpy()
    sphere = sp.parameterize(points, triangles, sp.Balanced()).sphere
    lines = tool("texture", points, triangles, "--chart", chart, out="textured.obj").read_text().splitlines()
    uv = np.array([line.split()[1:] for line in lines if line.startswith("vt ")], dtype=float)
    corners = [[part.split("/")[1] for part in line.split()[1:]] for line in lines if line.startswith("f ")]
    texture = sp.texture_coordinates(points, triangles, sphere, chart=chart, bits=23)
    assert (texture.uv == uv[np.array(corners, dtype=int) - 1]).all()


def test_signatures(tool: Tool) -> None:
    points, triangles = bumpy()
    index = tool("signature", points, triangles, out="index.csv")
    row = index.read_text().splitlines()[-1].split(",")
    assert np.array(row[-96:], dtype=float).tolist() == sp.shape_signature(points, triangles).tolist()
