# SPDX-License-Identifier: GPL-3.0-or-later
"""Registration of maps."""

import os
import signal

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy, ellipsoid, refused, rotation


def mapped(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    points, triangles = bumpy(3, seed)
    return points, triangles, sp.parameterize(points, triangles, sp.Isometric()).sphere


def test_a_turned_map_is_brought_back() -> None:
    points, triangles, sphere = mapped(1)
    turned = sphere[:, [1, 2, 0]]
    r = sp.register_maps(points, triangles, turned, points, triangles, sphere)
    assert sp.certify(triangles, r.sphere).is_valid
    assert np.abs(r.sphere - sphere).max() < 0.02
    assert max(r.mismatch_before, r.mismatch) < 0.01 and r.distortion < 4.001
    there = sp.Locator(triangles, sphere).transfer(points, r.sphere)
    changes = sp.length_changes(points, triangles, there)
    assert changes.of_faces.shape == (len(triangles),) and changes.of_faces.min() >= 1
    assert changes.factor.median < 1.05 and changes.share_of_large == 0
    stretched = sp.length_changes(points, triangles, points * [1, 1, 20])
    assert stretched.factor.median > 2 and stretched.share_of_large > 0.3
    with pytest.raises(ValueError, match="other_points"):
        sp.length_changes(points, triangles, points[1:])


def test_landmarks_are_put_onto_each_other() -> None:
    points, triangles, sphere = mapped(2)
    other = mapped(3)
    pairs = [[0, 0], [40, 40], [100, 100], [300, 300]]  # in the same directions
    r = sp.register_maps(points, triangles, sphere, *other, landmarks=pairs)
    assert r.start == "spectrum" and r.margin >= -0.1 and 0 <= r.signature_difference <= 1
    assert r.trust in ("sure", "unsure", "unlike")
    assert sp.register_maps(points, triangles, sphere, *other, motion="rotation").trust == "unknown"
    assert sp.certify(triangles, r.sphere).is_valid
    distance = np.linalg.norm(r.sphere[[i for i, _ in pairs]] - other[2][[j for _, j in pairs]], axis=1)
    assert distance.max() <= r.largest_landmark_distance + 1e-12 and distance.max() < 1e-12


def test_own_features_turn_what_has_no_form() -> None:
    sphere, triangles = sp.icosphere(4)
    turn = rotation(1)
    paint = [np.sin(5 * p + [1, 2, 3]) for p in (sphere @ turn.T, sphere)]
    ball = (sphere, triangles, sphere, sphere, triangles, sphere)
    given = {"features": paint[0], "other_features": paint[1]}
    r = sp.register_maps(*ball, **given, feature_weight=[20, 10, 10], curvature_weight=0)
    assert np.linalg.norm(r.sphere - sphere @ turn.T, axis=1).mean() < 0.03
    assert np.linalg.norm(sp.register_maps(*ball).sphere - sphere @ turn.T, axis=1).mean() > 0.3


def test_wrong_arguments() -> None:
    a = mapped(1)
    for wrong in ({"motion": "shear"}, {"curvature_weight": -1}, {"landmarks": [[0, 642]]}, {"landmarks": [0, 1]}, {"features": a[0]}):
        with pytest.raises(ValueError):
            sp.register_maps(*a, *a, **wrong)  # type: ignore[arg-type]
    with refused("NOT_BIJECTIVE"):
        sp.register_maps(a[0], a[1], -a[2], *a)


def test_centring_undoes_a_boost() -> None:
    points, triangles, sphere = mapped(1)
    masses = np.random.default_rng(1).uniform(1, 2, len(points))
    centred = sp.moebius_centred(sphere, triangles, masses)
    assert np.abs(masses @ centred).max() < 1e-9 * masses.sum()
    c = np.array([0.3, -0.2, 0.4])
    d = sphere - c
    boosted = (1 - c @ c) / (d * d).sum(axis=1)[:, None] * d - c
    again = sp.moebius_centred(boosted, triangles, masses)
    assert np.abs(again @ again.T - centred @ centred.T).max() < 1e-9  # the same but for a rotation
    with pytest.raises(sp.MeshError):
        sp.moebius_centred(sphere, triangles, -masses)


def test_progress_and_time_limit_end_it_with_a_certified_map() -> None:
    a, b = mapped(1), mapped(2)
    fractions: list[float] = []
    assert sp.register_maps(*a, *b, progress=fractions.append).is_complete
    assert fractions == sorted(fractions) and all(0 <= x <= 1 for x in fractions)
    stopped = sp.register_maps(*a, *b, maximum_running_time=0)
    assert not stopped.is_complete and sp.certify(a[1], stopped.sphere).is_valid
    with pytest.raises(ValueError):
        sp.register_maps(*a, *b, maximum_running_time=float("nan"))


def test_ctrl_c_ends_it() -> None:
    a, b = mapped(1), mapped(2)
    fractions: list[float] = []

    def progress(fraction: float) -> None:
        fractions.append(fraction)
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        sp.register_maps(*a, *b, progress=progress)
    assert len(fractions) == 1 and fractions[0] < 1


def test_morph_keeps_the_ends_and_does_not_shrink_on_a_turn() -> None:
    points, _ = ellipsoid(3)
    turned = points[:, [1, 2, 0]]
    way = sp.morph(points, turned, 7)
    assert way.shape == (8, *points.shape)
    assert (way[0] == points).all() and (way[-1] == turned).all()
    size = np.linalg.norm(points, axis=1)
    assert max(abs(np.linalg.norm(shape, axis=1) - size).max() for shape in way) < 1e-12
    for scale in (2.0**-700, 2.0**700, 2.0**1021):  # squares would vanish or overflow, and sums
        assert (sp.morph(points * scale, turned * scale, 7) == way * scale).all()
    for wrong in ((points, points[1:]), (points, turned, 0), (points, points * np.nan), (points[:0], points[:0])):
        with pytest.raises(ValueError):
            sp.morph(*wrong)
