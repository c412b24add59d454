# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files: the same bytes and the same refusals as the tool's."""

import gzip
import os
from pathlib import Path

import numpy as np
import pytest
from conftest import Tool, bumpy, refused

import spherical_parameterization as sp

FORMATS = ["off", "obj", "ply", "gii", "vtk", "vtp", "glb", "gltf", "ply.gz", "off.xz", "obj.zst", "gii.bz2"]


@pytest.mark.parametrize("extension", FORMATS)
def test_what_is_written_is_read(extension: str, tmp_path: Path) -> None:
    points, triangles = bumpy(3)
    file = tmp_path / f"mesh.{extension}"
    sp.write_mesh(file, points, triangles)
    found = sp.read_mesh(file)
    assert np.array_equal(found[1], triangles)
    is_exact = extension.split(".")[0] in ("off", "obj", "ply", "vtk", "vtp")
    assert np.array_equal(found[0], points if is_exact else points.astype(np.float32))


@pytest.mark.parametrize("name", ["out.off", "out.obj", "out.ply", "out.gii", "lh.out", "out.vtk", "out.vtp", "out.glb", "out.gltf"])
def test_the_bytes_are_those_of_the_tool(name: str, tool: Tool, tmp_path: Path) -> None:
    points, triangles = bumpy(3)
    expected = tool("map", points, triangles, out=name)
    found = tmp_path / "lh.python" if name.startswith("lh.") else tmp_path / f"python{expected.suffix}"
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
    with refused("NOT_TRIANGULAR", "read it with triangulate=True"):
        sp.read_mesh(file)
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
    with pytest.raises(ValueError, match="must be called"):
        sp.write_mesh(tmp_path / "mesh.stl", points, triangles)
    with pytest.raises(ValueError, match="mesh.vtu' must be called"):
        sp.write_mesh(tmp_path / "mesh.vtu", points, triangles)
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


def test_names_have_no_zero_byte(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="path: a name has no zero byte"):
        sp.write_mesh(f"{tmp_path}/a.off\0.off", *bumpy(1))
    assert not list(tmp_path.iterdir())


def test_a_file_may_be_called_like_the_standard_input(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    points, triangles = bumpy(2)
    sp.write_mesh("a.off", points, triangles)
    os.rename("a.off", "-")
    assert np.array_equal(sp.read_mesh("-")[0], points)


def test_other_formats_by_meshio(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    points, triangles = bumpy(2)
    for name in ("a.mesh", "a.vtu", "a.vtk"):  # the latter two are read here
        meshio.write_points_cells(tmp_path / name, points, {"triangle": triangles})
        found = sp.read_mesh(tmp_path / name)
        assert np.array_equal(found[0], points) and np.array_equal(found[1], triangles)


def test_what_meshio_cannot_read(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    file = tmp_path / "a.mesh"
    meshio.write_points_cells(file, square, {"quad": np.array([[0, 1, 2, 3]])})
    with refused("NOT_TRIANGULAR"):
        sp.read_mesh(file)
    assert sp.read_mesh(file, triangulate=True)[1].tolist() == [[0, 1, 2], [0, 2, 3]]
    whole = file.read_bytes()
    for end in range(20, len(whole) - 10, 20):
        file.write_bytes(whole[:end])
        with pytest.raises(OSError, match="a.mesh: meshio cannot read it"):
            sp.read_mesh(file)


def test_polygons_of_meshio_are_cut_inside(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    arrow = np.array([[0.0, 0, 0], [1, 1, 0], [9, 0, 0], [0, 9, 0]])
    meshio.write_points_cells(tmp_path / "a.mesh", arrow, {"quad": np.array([[0, 1, 2, 3], [3, 2, 1, 0]])})
    triangles = sp.read_mesh(tmp_path / "a.mesh", triangulate=True)[1]
    normals = np.cross(arrow[triangles[:, 1]] - arrow[triangles[:, 0]], arrow[triangles[:, 2]] - arrow[triangles[:, 0]])[:, 2]
    assert np.sign(normals).tolist() == [1, 1, -1, -1]
    meshio.write_points_cells(tmp_path / "a.mesh", arrow[:, :2], {"triangle": np.array([[0, 1, 2]])})
    with refused("EMPTY_MESH"):
        sp.read_mesh(tmp_path / "a.mesh")


def test_data_come_back(tmp_path: Path) -> None:
    points, triangles = bumpy(2)
    rng = np.random.default_rng(1)
    height = sp.VertexColumn("height", rng.normal(size=len(points)))
    keys = rng.choice([2.0, 5.0, np.nan], len(points))
    parcel = sp.VertexColumn("parcel", keys, {2: ("bänk", (1.0, 0.0, 0.2, 1.0)), 5: ("five", (0.0, 1.0, 0.4, 1.0))})
    for name in ("all.csv", "numbers.func.gii", "lh.height", "parcel.label.gii", "lh.parcel.annot", "lh.height.label"):
        sp.write_data(tmp_path / name, [height, parcel])
        found = sp.read_data(tmp_path / name, len(points))
        expected = [height, parcel] if name == "all.csv" else [parcel] if "parcel" in name else [height]
        assert [column.name for column in found] == [column.name for column in expected]
        for a, b in zip(found, expected):
            if name == "all.csv" and b.labels:  # which has their names
                assert a.labels is not None
                assert {label for label, _ in a.labels.values()} == {"bänk", "five"}
                continue
            if name == "lh.parcel.annot":  # which numbers them
                values = np.where(np.isnan(keys), np.nan, keys == 5)
                assert np.array_equal(a.values, values, equal_nan=True)
                assert {key: label for key, (label, _) in a.labels.items()} == {0: "bänk", 1: "five"}
                continue
            are_doubles = b.labels or name in ("all.csv", "lh.height.label")
            values = np.asarray(b.values, None if are_doubles else "f4")
            assert np.array_equal(a.values, values, equal_nan=True)
            assert (a.labels is None) == (b.labels is None)
            for key, (label, colour) in (b.labels or {}).items():
                assert a.labels is not None
                assert a.labels[key][0] == label
                assert np.allclose(a.labels[key][1], colour)
    for name in ("mesh.ply", "mesh.vtk", "mesh.vtp"):
        sp.write_mesh(tmp_path / name, points, triangles, data=[height, parcel])
        assert np.array_equal(sp.read_mesh(tmp_path / name)[0], points)
        found = sp.read_data(tmp_path / name, len(points))
        assert np.array_equal(found[0].values, height.values)
        assert np.array_equal(found[1].values, np.nan_to_num(keys, nan=-1))
        assert found[1].labels == {}


def test_data_that_cannot_be_read_or_written(tmp_path: Path) -> None:
    column = sp.VertexColumn("a", [1, 2.5, 3])
    sp.write_data(tmp_path / "a.csv", [column])
    with pytest.raises(OSError, match="values for 3 vertices, but the mesh has 4"):
        sp.read_data(tmp_path / "a.csv", 4)
    with pytest.raises(OSError, match="no columns of labels"):
        sp.write_data(tmp_path / "a.annot", [column])
    with pytest.raises(ValueError, match="must be called"):
        sp.write_data(tmp_path / "a.xyz", [column])
    with pytest.raises(ValueError, match="integers, or NaN"):
        sp.write_data(tmp_path / "b.csv", [sp.VertexColumn("a", [1, 2.5], {})])
    with pytest.raises(ValueError, match=r"shape \(3,\)"):
        sp.write_data(tmp_path / "b.csv", [column, sp.VertexColumn("b", [1, 2])])
    with pytest.raises(ValueError, match="keys of labels"):
        sp.write_data(tmp_path / "b.csv", [sp.VertexColumn("a", [1, 2], {2**31: ("one", (0, 0, 0, 1))})])
    assert not (tmp_path / "b.csv").exists()


def test_names_that_are_no_utf8(tmp_path: Path) -> None:
    file = tmp_path / os.fsdecode(b"\xff.off")
    file.write_text("nothing")
    with pytest.raises(OSError, match="\udcff.off: "):
        sp.read_mesh(file)
    file.write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    with refused("NOT_TRIANGULAR", "\udcff.off: "):
        sp.read_mesh(file)
    points, triangles = bumpy(2)
    sp.harmonics(triangles, sp.icosphere(2)[0], points, 2).save(file.with_suffix(".csv"))
    assert len(sp.read_harmonics(file.with_suffix(".csv")).coefficients) == 9


def test_maps_of_any_radius_are_written_as_the_formats_have_them(tmp_path: Path) -> None:
    sphere, triangles = sp.icosphere(2)
    for name, radius in (("a.ply", 1), ("a.gii", 100), ("lh.a", 100)):
        for factor in (1, 100, 7):
            sp.write_mesh(tmp_path / name, factor * sphere, triangles, sphere=True)
            assert np.allclose(sp.read_mesh(tmp_path / name)[0], radius * sphere, rtol=0, atol=1e-5 * radius)
    sp.write_mesh(tmp_path / "a.ply", sp.parameterize(sphere * [1, 2, 3], triangles), triangles, sphere=True)
