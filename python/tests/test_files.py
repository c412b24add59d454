# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files: the same bytes and the same refusals as the tool's."""

from __future__ import annotations

import gzip
from pathlib import Path

import numpy as np
import pytest
from conftest import Tool, bumpy

import spherical_parameterization as sp

FORMATS = ["off", "obj", "ply", "gii", "glb", "gltf", "ply.gz", "off.xz", "obj.zst", "gii.bz2"]


@pytest.mark.parametrize("extension", FORMATS)
def test_what_is_written_is_read(extension: str, tmp_path: Path) -> None:
    points, triangles = bumpy(3)
    file = tmp_path / f"mesh.{extension}"
    sp.write_mesh(file, points, triangles)
    found = sp.read_mesh(file)
    assert np.array_equal(found[1], triangles)
    is_exact = extension.split(".")[0] in ("off", "obj", "ply")
    assert np.array_equal(found[0], points if is_exact else points.astype(np.float32))


@pytest.mark.parametrize("name", ["out.off", "out.obj", "out.ply", "out.gii", "lh.out", "out.glb", "out.gltf"])
def test_the_bytes_are_those_of_the_tool(name: str, tool: Tool) -> None:
    points, triangles = bumpy(3)
    expected = tool.run("map", points, triangles, out=name)
    found = tool.folder / "lh.python" if name.startswith("lh.") else tool.folder / f"python{expected.suffix}"
    sp.write_mesh(found, sp.parameterize(points, triangles).sphere, triangles, sphere=True)
    assert found.read_bytes() == expected.read_bytes()


def test_metadata_are_kept(tmp_path: Path) -> None:
    points, triangles = bumpy(2)
    plain, marked, again = (tmp_path / name for name in ("a.gii", "b.gii", "c.gii"))
    sp.write_mesh(plain, points, triangles)
    mark = "<MetaData>\n<MD><Name>Subject</Name><Value>me</Value></MD>\n</MetaData>"
    marked.write_text(plain.read_text().replace("<MetaData>\n</MetaData>", mark, 1))
    sp.write_mesh(again, points, triangles, like=marked)
    assert again.read_bytes() == marked.read_bytes() != plain.read_bytes()


def test_polygons(tmp_path: Path) -> None:
    file = tmp_path / "square.off"
    file.write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    with pytest.raises(sp.MeshError, match="read it with triangulate=True") as error:
        sp.read_mesh(file)
    assert error.value.code == "NOT_TRIANGULAR"
    assert sp.read_mesh(file, triangulate=True)[1].tolist() == [[0, 1, 2], [0, 2, 3]]


def test_what_cannot_be_read(tmp_path: Path) -> None:
    points, triangles = bumpy(2)
    file = tmp_path / "mesh.ply"
    sp.write_mesh(file, points, triangles)
    with pytest.raises(FileNotFoundError):
        sp.read_mesh(tmp_path / "missing.off")
    file.write_bytes(file.read_bytes()[:-100])
    with pytest.raises(OSError, match="mesh.ply: cut short"):
        sp.read_mesh(file)
    (tmp_path / "notes.txt").write_text("nothing")
    with pytest.raises(OSError, match="notes.txt: has the unknown extension"):
        sp.read_mesh(tmp_path / "notes.txt")


def test_what_cannot_be_written(tmp_path: Path) -> None:
    points, triangles = bumpy(2)
    with pytest.raises(ValueError, match="the extension"):
        sp.write_mesh(tmp_path / "mesh.stl", points, triangles)
    with pytest.raises(sp.MeshError, match="numbered from 0"):
        sp.write_mesh(tmp_path / "mesh.off", points, triangles + 1)
    with pytest.raises(sp.MeshError, match="floats"):
        sp.write_mesh(tmp_path / "mesh.gii", 1e300 * points, triangles)
    with pytest.raises(OSError):
        sp.write_mesh(tmp_path / "nowhere" / "mesh.off", points, triangles)
    assert not list(tmp_path.iterdir())


def test_content_decides_about_the_format(tmp_path: Path) -> None:
    points, triangles = bumpy(2)
    sp.write_mesh(tmp_path / "a.ply", points, triangles)
    (tmp_path / "a.off").write_bytes(gzip.compress((tmp_path / "a.ply").read_bytes()))
    assert np.array_equal(sp.read_mesh(tmp_path / "a.off")[0], points)


def test_other_formats_by_meshio(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    points, triangles = bumpy(2)
    meshio.write_points_cells(tmp_path / "a.vtk", points, {"triangle": triangles})
    found = sp.read_mesh(tmp_path / "a.vtk")
    assert np.array_equal(found[0], points) and np.array_equal(found[1], triangles)
