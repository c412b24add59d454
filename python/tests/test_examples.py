# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples and the notebook, with what Debian packages."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy

EXAMPLES = Path(__file__).parent.parent / "examples"


def run(name: str, *arguments: object) -> str:
    command = [sys.executable, EXAMPLES / name, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_cortex_to_sphere(tmp_path: Path) -> None:
    nibabel = pytest.importorskip("nibabel")
    points, triangles = bumpy(4)
    array = nibabel.gifti.GiftiDataArray
    surface = [
        array(points.astype(np.float32), intent="NIFTI_INTENT_POINTSET"),
        array(triangles.astype(np.int32), intent="NIFTI_INTENT_TRIANGLE"),
    ]
    nibabel.save(nibabel.GiftiImage(darrays=surface), tmp_path / "lh.white.surf.gii")
    overlay = array(points[:, 2].astype(np.float32), intent="NIFTI_INTENT_SHAPE")
    nibabel.save(nibabel.GiftiImage(darrays=[overlay]), tmp_path / "lh.height.shape.gii")
    options = ["--overlay", tmp_path / "lh.height.shape.gii", "--level", 3]
    output = run("cortex_to_sphere.py", tmp_path / "lh.white.surf.gii", tmp_path / "lh.sphere.surf.gii", *options)
    assert "valid spherical map" in output and "<Certificate: valid, 0 flipped faces, degree 1>" in output

    sphere, faces = sp.read_mesh(tmp_path / "lh.sphere.surf.gii")
    assert (faces == triangles).all() and sp.certify(faces, sphere)
    assert np.allclose(np.linalg.norm(sphere, axis=1), 100, rtol=1e-5)
    carried = nibabel.load(tmp_path / "lh.height.ico3.shape.gii").agg_data()
    expected = sp.Locator(faces, sphere).transfer(points[:, 2], sp.icosphere(3)[0])
    assert np.allclose(carried, expected, atol=1e-3)


def test_any_format(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    points, triangles = bumpy(3)
    sp.write_mesh(tmp_path / "in.off", points, triangles)
    assert "valid spherical map" in run("any_format.py", tmp_path / "in.off", tmp_path / "out.vtu")
    mesh = meshio.read(tmp_path / "out.vtu")
    assert (mesh.points == points).all() and (mesh.cells_dict["triangle"] == triangles).all()
    assert (mesh.point_data["sphere"] == sp.parameterize(points, triangles).sphere).all()
    assert mesh.cell_data["segment"][0].min() == 0


def test_pictures(tmp_path: Path) -> None:
    matplotlib_image = pytest.importorskip("matplotlib.image")
    sp.write_mesh(tmp_path / "in.off", *bumpy(3))
    run("pictures.py", tmp_path / "in.off", tmp_path / "out.png")
    assert matplotlib_image.imread(tmp_path / "out.png")[:, :, :3].std() > 0.05


def test_model_quality(tmp_path: Path) -> None:
    matplotlib_image = pytest.importorskip("matplotlib.image")
    header = "modes,compactness,generalization,specificity,specificity_error"
    (tmp_path / "quality.csv").write_text(f"{header}\n0,0,2,1,0\n1,3,1,1.5,0.1\n2,4,,2,0.1\n")  # as `atlas` writes it
    run("model_quality.py", tmp_path / "quality.csv", tmp_path / "out.png")
    assert matplotlib_image.imread(tmp_path / "out.png")[:, :, :3].std() > 0.05


def test_vtk_arrays() -> None:
    assert "valid spherical map" in run("vtk_arrays.py")


def test_collection(tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    pytest.importorskip("meshio")
    (tmp_path / "scans").mkdir()
    sp.write_mesh(tmp_path / "scans/a.off", *bumpy(2))
    sp.write_mesh(tmp_path / "scans/b.off", bumpy(2)[0], bumpy(2)[1][1:])
    output = run("collection.py", tmp_path / "scans", tmp_path / "results.sqlite").splitlines()
    assert output[0] == "{'BOUNDARY': 1, 'OK': 1}"
    assert output[1].endswith("a.off OK, by balanced") and "the mesh is not closed" in output[2]


def test_notebook() -> None:
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    notebook = nbformat.read(EXAMPLES / "from_a_mesh_to_a_sphere.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=300).execute()
    texts = [output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("valid spherical map" in text for text in texts)


def test_read_mesh(tmp_path: Path) -> None:
    freesurfer = pytest.importorskip("nibabel.freesurfer")
    points, triangles = bumpy(1)
    freesurfer.write_geometry(str(tmp_path / "lh.white"), points, triangles)
    found = sp.read_mesh(tmp_path / "lh.white")
    assert np.allclose(found[0], points, atol=1e-6) and (found[1] == triangles).all()
    tetrahedron = "OFF 4 4 0 # in one line\n0 0 0 1 0 0\n1 0 0\n0 1 0\n\n0 0 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
    (tmp_path / "colours.off").write_text(tetrahedron)
    assert sp.parameterize(*sp.read_mesh(tmp_path / "colours.off")).is_valid
    for wrong in (tetrahedron[:-10], tetrahedron[1:], tetrahedron.replace("1 0 0", "1 0 x")):
        (tmp_path / "wrong.off").write_text(wrong)
        with pytest.raises(OSError, match="wrong.off"):
            sp.read_mesh(tmp_path / "wrong.off")
    with_seam = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3\nf -3/4 -1/3 -2/2\n"
    (tmp_path / "seam.obj").write_text(with_seam)
    assert sp.read_mesh(tmp_path / "seam.obj")[1].tolist() == [[0, 1, 2], [0, 2, 1]]
