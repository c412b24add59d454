# SPDX-License-Identifier: LGPL-3.0-or-later
"""Alignment, mean and principal components of shapes."""

import signal
import subprocess
import time

import numpy as np
import pytest
import spherical_parameterization as sp
from conftest import bumpy, refused, rotation


def test_statistics_are_those_of_numpy():
    random = np.random.default_rng(1)
    shapes = random.normal(size=(7, 50, 3))
    weights = random.uniform(0.1, 1, 50)
    found = sp.shape_statistics(shapes, weights=weights)
    share = np.sqrt(weights / weights.sum())[:, None]
    centred = ((shapes - shapes.mean(axis=0)) * share).reshape(7, -1)
    values = np.linalg.svd(centred, compute_uv=False)[:6]
    np.testing.assert_allclose(found.variances, values**2 / 6)
    np.testing.assert_allclose(found.mean, shapes.mean(axis=0), atol=1e-14)
    np.testing.assert_allclose(found.scores.var(axis=0, ddof=1), found.variances)
    gram = np.einsum("v,ivc,jvc->ij", weights / weights.sum(), found.modes, found.modes)
    np.testing.assert_allclose(gram, np.eye(6), atol=1e-12)
    for i in range(7):
        np.testing.assert_allclose(found.shape(found.scores[i]), shapes[i], atol=1e-12)
    assert found.explained.sum() == pytest.approx(1)
    some = sp.shape_statistics(shapes, weights=weights, modes=2)
    np.testing.assert_array_equal(some.modes, found.modes[:2])
    assert some.total_variance == found.total_variance


def test_alignment_undoes_motions():
    random = np.random.default_rng(2)
    body = random.normal(size=(40, 3))
    shapes = [s * body @ rotation(s).T + random.normal(size=3) for s in (1, 2, 3)]
    rigid = sp.align_shapes(shapes)
    assert rigid.has_converged and rigid.deviation > 0.1
    moved = np.einsum("n,nab,nvb->nva", rigid.scales, rigid.rotations, np.array(shapes))
    np.testing.assert_allclose(moved + rigid.translations[:, None], rigid.shapes, atol=1e-12)
    assert sp.align_shapes(shapes, scale=True).deviation < 1e-9
    np.testing.assert_array_equal(rigid.rotations[0], np.eye(3))


def test_statistics_of_harmonics():
    random = np.random.default_rng(3)
    shapes = [sp.Harmonics(random.normal(size=(16, 3))) for _ in range(5)]
    found = sp.shape_statistics(shapes)
    table = np.array([shape.coefficients for shape in shapes])
    centred = (table - table.mean(axis=0)).reshape(5, -1) / np.sqrt(4 * np.pi)
    np.testing.assert_allclose(found.variances, np.linalg.svd(centred, compute_uv=False)[:4] ** 2 / 4)
    assert sp.Harmonics(found.mean).degree == 3
    assert sp.align_shapes(shapes).shapes.shape == (5, 16, 3)
    with pytest.raises(ValueError, match="coefficients have none"):
        sp.shape_statistics(shapes, weights=np.ones(16))


def test_errors_of_the_left_out():
    random = np.random.default_rng(4)
    shapes = random.normal(size=(6, 30, 3))
    errors = sp.left_out_errors(shapes)
    mean = [(shapes[i] - np.delete(shapes, i, axis=0).mean(axis=0)) for i in range(6)]
    assert errors[0] == pytest.approx(np.sqrt((np.array(mean) ** 2).sum() / 30 / 6))
    assert len(errors) == 5 and (np.diff(errors) <= 0).all()
    assert len(sp.left_out_errors(shapes, groups=2)) == 3


def test_quality_of_a_model():
    shapes = np.random.default_rng(4).normal(size=(6, 30, 3))
    quality, statistics = sp.model_quality(shapes), sp.shape_statistics(shapes)
    np.testing.assert_allclose(quality.compactness, [0, *np.cumsum(statistics.variances)])
    assert (quality.generalization == sp.left_out_errors(shapes)).all()
    scores = np.random.default_rng(5).normal(size=(5000, 5)) * np.sqrt(statistics.variances)
    distances = np.linalg.norm(scores[:, None] - statistics.scores, axis=2).min(axis=1)
    error = np.hypot(quality.specificity_error[5], distances.std() / np.sqrt(5000))
    assert abs(quality.specificity[5] - distances.mean()) < 4 * error
    assert (sp.model_quality(shapes, seed=2).specificity[1:] != quality.specificity[1:]).all()


def long_statistics():
    sp.left_out_errors(np.random.default_rng(1).normal(size=(80, 20000, 3)), policy="sequential")


def long_harmonics():
    sphere, triangles = sp.icosphere(6)
    sp.harmonics(triangles, sphere, sphere, 80, fit="integrals", policy="sequential")


def long_signature():
    sphere, triangles = sp.icosphere(7)
    sp.shape_signature(sphere, triangles, sphere, policy="sequential")


@pytest.mark.parametrize("work", [long_statistics, long_harmonics, long_signature])
def test_ctrl_c_ends_what_takes_long(work):
    def press(*_):
        raise KeyboardInterrupt

    start = time.process_time()
    work()
    needed = time.process_time() - start
    before = signal.signal(signal.SIGPROF, press)
    try:
        start = time.process_time()
        signal.setitimer(signal.ITIMER_PROF, needed / 4)
        with pytest.raises(KeyboardInterrupt):
            work()
        assert time.process_time() - start < 0.8 * needed  # of the processor: other programs do not count
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def test_vertices_count_with_their_area():
    sphere, triangles = sp.icosphere(3)
    areas = sp.mean_vertex_areas([sphere, 3 * sphere], triangles)
    assert areas.sum() == pytest.approx(5 * 4 * np.pi, rel=0.02)


@pytest.mark.parametrize(
    "call",
    [
        lambda: sp.shape_statistics(np.zeros((3, 2))),
        lambda: sp.shape_statistics([np.zeros((3, 3)), np.zeros((4, 3))]),
        lambda: sp.shape_statistics(np.zeros((2, 4, 3)), weights=np.zeros(4)),
        lambda: sp.shape_statistics(np.zeros((2, 4, 3)), modes=-1),
        lambda: sp.left_out_errors(np.zeros((1, 4, 3))),
        lambda: sp.align_shapes([]),
        lambda: sp.align_shapes(np.full((2, 4, 3), np.nan)),
        lambda: sp.shape_statistics(np.ones((2, 4, 3))).shape([1.0]),
    ],
)
def test_what_makes_no_sense_is_refused(call):
    with pytest.raises(ValueError):
        call()


def test_atlas_of_a_family():
    points, triangles = sp.icosphere(3)
    limbs = np.array([[1, 0, 0], [-0.5, 0.8, 0.2], [-0.4, -0.6, 0.7], [0, -0.3, -1]])
    limbs /= np.linalg.norm(limbs, axis=1, keepdims=True)
    body = points * (1 + np.exp(12 * (points @ limbs.T) - 12) @ [1.5, 1.5, 1.2, 0.8])[:, None]
    open_mesh = (points, triangles[1:])
    family = [(body * [x, 1, 1], triangles) for x in (1, 1.15, 1.3)]
    quads = points, np.zeros((9, 4), dtype=int)
    result = sp.atlas([open_mesh, *family, quads], level=3, align="centre")
    assert result.members == [1, 2, 3]
    assert "closed" in result.refused[0] and "4 corners" in result.refused[4]
    assert result.statistics.explained[0] > 0.99
    first = result.statistics.scores[:, 0]
    assert (np.diff(first) > 0).all() or (np.diff(first) < 0).all()
    assert result.shapes.shape == (3, len(result.sphere), 3)
    with pytest.raises(ValueError, match="has no map"):
        sp.atlas([open_mesh, *family], template=0)
    for few in ([], family[:1]):
        with pytest.raises(ValueError, match=f"meshes: two or more are needed, not {len(few)}"):
            sp.atlas(few)
    for few, wrong in (([open_mesh], "no mesh has a map"), ([open_mesh, family[0]], "two or more shapes are needed")):
        with refused("BOUNDARY", wrong + "; mesh 0: .*closed"):
            sp.atlas(few)


def test_the_tool_makes_the_same_atlas(program, tmp_path):
    (tmp_path / "in").mkdir()
    family = [bumpy(3, seed) for seed in range(3)]
    for i, mesh in enumerate(family):
        sp.write_mesh(tmp_path / f"in/{i}.ply", *mesh)
    options = ["--level", "3", "--rounds", "2", "--modes", "1", "--align", "similarity"]
    run = [program, "atlas", tmp_path / "in", "-o", tmp_path / "out", *options]
    subprocess.run(run, check=True, capture_output=True)
    found = sp.atlas(family, level=3, rounds=2, modes=1, align="similarity")
    mean, triangles = sp.read_mesh(tmp_path / "out/mean.ply")
    assert np.array_equal(found.statistics.mean, mean) and np.array_equal(found.triangles, triangles)
    plus, _ = sp.read_mesh(tmp_path / "out/modes/mode_1_plus.ply")
    assert np.array_equal(found.statistics.shape([2 * np.sqrt(found.statistics.variances[0])]), plus)
