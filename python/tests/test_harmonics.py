# SPDX-License-Identifier: GPL-3.0-or-later
"""Spherical harmonics: scipy's are the other program."""

import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy, refused, rotation

special = pytest.importorskip("scipy.special")


def harmonic(l: int, m: int, x: np.ndarray) -> np.ndarray:  # noqa: E741
    """By scipy, whose functions are complex and have the Condon-Shortley phase."""
    azimuth, polar = np.arctan2(x[:, 1], x[:, 0]), np.arctan2(np.hypot(x[:, 0], x[:, 1]), x[:, 2])
    if hasattr(special, "sph_harm_y"):
        y = special.sph_harm_y(l, abs(m), polar, azimuth)
    else:
        y = special.sph_harm(abs(m), l, azimuth, polar)
    return y.real if m == 0 else 2**0.5 * (-1) ** m * (y.real if m > 0 else y.imag)


def random_harmonics(degree: int, seed: int, columns: int = 3) -> sp.Harmonics:
    rows = np.repeat(1 + np.arange(degree + 1), 2 * np.arange(degree + 1) + 1)
    return sp.Harmonics(np.random.default_rng(seed).normal(size=(len(rows), columns)) / rows[:, None])


def test_synthesis_is_scipys() -> None:
    degree = 40
    given = random_harmonics(degree, 1, 2)
    x = np.random.default_rng(2).normal(size=(50, 3))
    matrix = np.stack([harmonic(l, m, x) for l in range(degree + 1) for m in range(-l, l + 1)], axis=1)
    assert abs(given.at(x) - matrix @ given.coefficients).max() < 1e-9
    rows, columns = 7, 12
    theta, phi = np.meshgrid(np.linspace(0, np.pi, rows), np.arange(columns) * 2 * np.pi / columns, indexing="ij")
    grid = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    assert abs(given.on_grid(rows, columns) - given.at(grid.reshape(-1, 3)).reshape(rows, columns, 2)).max() < 1e-9


def test_least_squares_are_those_of_numpy() -> None:
    points, triangles = bumpy()
    sphere, degree = sp.parameterize(points, triangles, sp.Balanced()).sphere, 9
    matrix = np.stack([harmonic(l, m, sphere) for l in range(degree + 1) for m in range(-l, l + 1)], axis=1)
    expected, *_ = np.linalg.lstsq(matrix, points, rcond=None)
    found = sp.harmonics(triangles, sphere, points, degree, weights="equal", accuracy=1e-13)
    assert found.has_converged and found.degree == degree
    assert abs(found.coefficients - expected).max() < 1e-9
    assert abs(found.at(sphere) - matrix @ expected).max() < 1e-9
    single = sp.harmonics(triangles, sphere, points[:, 1], degree, weights="equal", accuracy=1e-13)
    assert single.coefficients.shape == (100,)
    assert abs(single.coefficients - expected[:, 1]).max() < 1e-9
    four = sp.harmonics(triangles, sphere, np.hstack([points, points[:, :1]]), degree, weights="equal", accuracy=1e-13)
    assert abs(four.coefficients[:, 3] - expected[:, 0]).max() < 1e-9
    for other in (
        sp.harmonics(triangles, sphere, points, degree),
        sp.harmonics(triangles, sphere, points, degree, weights="surface-area", points=points),
        sp.harmonics(triangles, sphere, points, degree, fit="integrals"),
    ):
        assert abs(other.coefficients - expected).max() < 0.05
    assert not sp.harmonics(triangles, sphere, points, degree, iterations=1).has_converged


def test_a_shape_in_any_pose() -> None:
    shape = random_harmonics(8, 3)
    shape.coefficients[1:4] += 4 * np.eye(3)[[1, 2, 0]] * [3, 2, 1]
    moved = sp.Harmonics(shape.coefficients @ rotation(4).T).rotated(rotation(5))
    moved.coefficients[0] += 7
    assert abs(moved.power_spectrum()[1:] - shape.power_spectrum()[1:]).max() < 1e-9
    assert abs(moved.aligned().coefficients - shape.aligned().coefficients).max() < 1e-9
    radii = shape.ellipsoid().radii
    assert (np.diff(radii) < 0).all() and radii[2] > 0
    x = np.random.default_rng(6).normal(size=(9, 3))
    assert abs(shape.rotated(rotation(7)).at(x @ rotation(7).T) - shape.at(x)).max() < 1e-9
    assert abs(shape.rotated(rotation(8)).best_rotation(shape) - rotation(8)).max() < 1e-6
    alignment = moved.best_alignment(shape)
    assert abs(alignment.space - rotation(4)).max() < 1e-4
    assert abs(alignment.sphere - rotation(5)).max() < 1e-4
    assert alignment.correlation == pytest.approx(1)
    assert abs(shape.mirrored().at(x * [1, 1, -1]) - shape.at(x) * [1, 1, -1]).max() < 1e-9
    smooth = shape.filtered(np.exp(-0.1 * np.arange(6) * np.arange(1, 7)))
    assert smooth.degree == 5
    assert smooth.power_spectrum()[3] == pytest.approx(np.exp(-2.4) * shape.power_spectrum()[3])


@pytest.mark.parametrize("extension", ["csv", "json", "coef"])
def test_files(tmp_path: Path, extension: str) -> None:
    given, file = random_harmonics(7, 9), tmp_path / f"a.{extension}"
    given.save(file)
    assert abs(sp.read_harmonics(file).coefficients - given.coefficients).max() < 1e-15
    packed = tmp_path / f"a.{extension}.gz"
    given.save(os.fsencode(packed))
    assert np.array_equal(sp.read_harmonics(packed).coefficients, sp.read_harmonics(file).coefficients)
    packed.unlink()
    file.write_text("nonsense")
    with pytest.raises(ValueError, match="no file of harmonic coefficients"):
        sp.read_harmonics(file)
    file.write_bytes(b"\xff\xfe")
    with pytest.raises(ValueError, match="no file of harmonic coefficients"):
        sp.read_harmonics(file)
    with pytest.raises(ValueError, match="extension"):
        given.save(tmp_path / "a.txt")
    with pytest.raises(ValueError, match="three functions, not of 2"):
        random_harmonics(7, 9, 2).save(tmp_path / "b.coef")
    with pytest.raises(OSError):
        given.save("/dev/full/a.csv")
    assert list(tmp_path.iterdir()) == [file]
    pipe = tmp_path / f"pipe.{extension}"
    os.mkfifo(pipe)
    with ThreadPoolExecutor(1) as pool:
        text = pool.submit(pipe.read_text)
        given.save(pipe)
        given.save(file)
        assert text.result() == file.read_text()
    assert pipe.is_fifo()


def test_conventions() -> None:
    given = random_harmonics(5, 10, 1)
    table = given.to_pyshtools()
    assert table.shape == (1, 2, 6, 6)
    assert table[0, 0, 4, 3] == given.coefficients[4 * 4 + 4 + 3, 0]
    assert table[0, 1, 4, 3] == given.coefficients[4 * 4 + 4 - 3, 0]
    assert (table[0, 1, :, 0] == 0).all()


def test_maps_that_are_not_valid_are_refused() -> None:
    sphere, triangles = sp.icosphere(3)
    folded = sphere.copy()
    folded[0] *= -1
    for wrong in (-sphere, folded):
        for fit in ("least-squares", "integrals"):
            with refused("NOT_BIJECTIVE"):
                sp.harmonics(triangles, wrong, sphere, 4, fit=fit)
    large, unit = (sp.harmonics(triangles, radius * sphere, sphere, 4).coefficients for radius in (100, 1))
    assert np.allclose(large, unit)


def test_wrong_arguments() -> None:
    sphere, triangles = sp.icosphere(1)
    for arguments, word in [
        (dict(degree=6), "42"),
        (dict(degree=2, fit="lumped"), "fit"),
        (dict(degree=2, weights="area"), "weights"),
        (dict(degree=2, weights="surface-area"), "points"),
        (dict(degree=2, accuracy=0), "accuracy"),
    ]:
        with pytest.raises(ValueError, match=word):
            sp.harmonics(triangles, sphere, sphere, **arguments)
    with pytest.raises(ValueError, match="values"):
        sp.harmonics(triangles, sphere, sphere[:-1], 2)
    with pytest.raises(ValueError, match="coefficients"):
        sp.Harmonics(np.zeros(5))
    with pytest.raises(ValueError, match="three functions"):
        sp.Harmonics(np.zeros(4)).ellipsoid()
    with pytest.raises(ValueError, match="functions"):
        sp.Harmonics(np.zeros(4)).best_rotation(sp.Harmonics(np.zeros((4, 3))))
    with pytest.raises(sp.MeshError):
        sp.harmonics(triangles, sphere, np.full(len(sphere), np.nan), 2)


def test_the_radius_of_a_map_does_not_matter() -> None:
    sphere, triangles = sp.icosphere(3)
    points = sphere * [1, 2, 3]
    for weights in ("equal", "sphere-area", "surface-area"):
        one = sp.harmonics(triangles, sphere, points, 6, weights=weights, points=points).coefficients
        other = sp.harmonics(triangles, 100 * sphere, points, 6, weights=weights, points=points).coefficients
        assert np.allclose(one, other, rtol=0, atol=1e-10)
