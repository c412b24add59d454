# SPDX-License-Identifier: GPL-3.0-or-later
"""What is no argument is a TypeError or ValueError that names it, in every public function."""

import inspect
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spherical_parameterization as sp

SPHERE, TRIANGLES = sp.icosphere(2)
POINTS = SPHERE * [1, 2, 3]
MESH = {"points": POINTS, "triangles": TRIANGLES, "sphere": SPHERE}
LOCATOR = sp.Locator(TRIANGLES, SPHERE)
RESAMPLING = LOCATOR.linear_resampling(SPHERE)
AREAS = np.ones(len(SPHERE))
SHAPE = sp.harmonics(TRIANGLES, SPHERE, POINTS, 3)
SHAPES = {"shapes": [POINTS, POINTS + 1]}
FEATURES = {"features": POINTS, "other_features": POINTS, "feature_weight": [1, 2, 3]}
OTHER = {"other_points": POINTS, "other_triangles": TRIANGLES, "other_sphere": SPHERE}

OF_A_MAP = (
    sp.distortion, sp.face_distortion, sp.vertex_log_area_stretch, sp.segment, sp.texture_coordinates, sp.shape_signature,
    sp.stretch_histogram,
)
OPTIONS = (
    sp.Automatic, sp.Balanced, sp.Isometric, sp.SaddlePoint, sp.ClampedWeights, sp.MajorityVote, sp.RegionGrowing,
)

#: Every public function with arguments that are right.
CALLS: list[tuple[Callable[..., object], dict[str, object]]] = [
    (sp.parameterize, {"points": POINTS, "triangles": TRIANGLES}),
    (sp.certify, {"triangles": TRIANGLES, "sphere": SPHERE}),
    (sp.edges, {"triangles": TRIANGLES}),
    (sp.length_changes, {"points": POINTS, "triangles": TRIANGLES, "other_points": SPHERE}),
    (sp.mean_over_faces, {"triangles": TRIANGLES, "values": np.ones(len(TRIANGLES))}),
    (sp.texture_seams, {"triangles": TRIANGLES, "uv": np.zeros((len(TRIANGLES), 3, 2))}),
    (sp.icosphere, {"level": 1}),
    (sp.Locator, {"triangles": TRIANGLES, "sphere": SPHERE}),
    (LOCATOR.locate, {"directions": SPHERE}),
    (LOCATOR.interpolate, {"values": POINTS, "faces": [0], "weights": [[1, 0, 0]]}),
    (LOCATOR.transfer, {"values": POINTS, "directions": SPHERE}),
    (LOCATOR.linear_resampling, {"directions": SPHERE}),
    (LOCATOR.area_preserving_resampling, {"areas": AREAS, "other": LOCATOR, "other_areas": AREAS}),
    (RESAMPLING.means, {"values": POINTS}),
    (RESAMPLING.majorities, {"labels": AREAS}),
    (RESAMPLING.nearest, {"labels": POINTS}),
    (LOCATOR.resample, {"points": POINTS, "level": 1}),
    (LOCATOR.align, {"points": POINTS, "other": LOCATOR, "other_points": POINTS}),
    (sp.shape_form, {"points": POINTS, "triangles": TRIANGLES}),
    (sp.relevance, {"signatures": np.zeros((3, 96)), "forms": np.zeros((3, 112))}),
    (sp.search, {"signature": np.zeros(96), "index": np.zeros((3, 96))}),
    (sp.harmonics, {"triangles": TRIANGLES, "sphere": SPHERE, "values": POINTS, "degree": 3, "points": POINTS}),
    (sp.Harmonics, {"coefficients": np.ones((4, 3))}),
    (SHAPE.at, {"directions": SPHERE}),
    (SHAPE.on_grid, {"rows": 3, "columns": 4}),
    (SHAPE.filtered, {"factors": [1, 0.5]}),
    (SHAPE.rotated, {"rotation": np.eye(3)}),
    (SHAPE.best_rotation, {"other": SHAPE}),
    (SHAPE.best_alignment, {"other": SHAPE}),
    (sp.align_shapes, SHAPES),
    (sp.shape_statistics, SHAPES),
    (sp.left_out_errors, SHAPES),
    (sp.model_quality, {**SHAPES, "samples": 2}),
    (sp.mean_vertex_areas, {**SHAPES, "triangles": TRIANGLES}),
    (sp.register_maps, {**MESH, **OTHER, **FEATURES, "motion": "rotation"}),
    (sp.moebius_centred, {"sphere": SPHERE, "triangles": TRIANGLES, "masses": np.ones(len(SPHERE))}),
    *((function, MESH) for function in OF_A_MAP),
    *((options, {}) for options in OPTIONS),
]


def names(calls: list[Any]) -> list[tuple[Any, ...]]:
    return [(f, given, name) for f, given in calls for name in inspect.signature(f).parameters]


@pytest.mark.parametrize(("function", "given", "name"), names(CALLS), ids=lambda x: getattr(x, "__qualname__", None) or str(x)[:20])
def test_every_argument_of_every_function(function: Any, given: dict[str, object], name: str) -> None:
    function(**given)
    is_optional = inspect.signature(function).parameters[name].default is None
    wrong = [object(), 1j, {1: object()}, "nonsense", b"nonsense", [[1, 2], [3]], np.full((2, 2), 1j), *[None] * (not is_optional)]
    for value in wrong:
        with pytest.raises((TypeError, ValueError)) as caught:
            function(**{**given, name: value})
        message = str(caught.value)
        assert name in message, f"{value!r}: {message}"
        assert not re.search("incompatible function arguments|attribute|unsized|arg0", message), f"{value!r}: {message}"


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"method": "foo"}, ValueError, "method 'foo': one of 'automatic', 'balanced', 'isometric', 'saddle-point'"),
        ({"method": None}, TypeError, "method: one of .*Isometric.* is needed, not NoneType"),
        ({"method": 3}, TypeError, "method: .* not int"),
        ({"method": sp.MajorityVote()}, TypeError, "method: .* not MajorityVote"),
        ({"maximum_running_time": "3"}, TypeError, "maximum_running_time: a number is needed, not str"),
        ({"maximum_running_time": -3}, ValueError, "maximum_running_time: 0 to inf is needed, not -3"),
        ({"iterations": 1.5}, TypeError, "iterations: a whole number or None is needed, not float"),
        ({"iterations": True}, TypeError, "iterations"),
        ({"iterations": -1}, ValueError, "iterations: 0 to 2147483647 is needed, not -1"),
        ({"progress": 3}, TypeError, "progress: a function, or a bar of tqdm, is needed, not int"),
        ({"fixed": [0, 1, 2]}, TypeError, "fixed: a mapping of vertices to directions, or a pair .* not list"),
        ({"fixed": ([0.5], [[1, 0, 0]])}, TypeError, "fixed: vertices: .* not float64"),
        ({"policy": 3}, TypeError, "policy: .* not int"),
        ({"points": POINTS + 1j}, TypeError, "points: an array of real numbers is needed, not complex128"),
        ({"points": POINTS[:, :2]}, ValueError, r"points: shape \(n, 3\) is needed, not \(162, 2\)"),
        ({"triangles": np.zeros((4, 3))}, TypeError, "triangles: integers are needed, not float64"),
        ({"triangles": np.zeros(3, dtype=int)}, ValueError, r"triangles: shape \(m, 3\) is needed, not \(3,\)"),
        ({"weights": None}, TypeError, "weights"),
        ({"weights": sp.ClampedWeights(0, 85)}, ValueError, "the angles of clamped weights"),
        ({"accuracy": -1.0}, ValueError, "the accuracy has to be positive"),
        ({"accuracy": float("nan")}, ValueError, "accuracy: "),
        ({"method": sp.Balanced(1)}, ValueError, "the spring exponent"),
        ({"method": sp.SaddlePoint(relaxation=7)}, ValueError, "the relaxation"),
        ({"maximum_running_time": float("nan")}, ValueError, "maximum_running_time: 0 to inf is needed, not nan"),
        ({"start": SPHERE}, ValueError, r"start: only SaddlePoint\(start='given'\)"),
        ({"start": SPHERE, "method": sp.SaddlePoint()}, ValueError, "start: only"),
        ({"method": sp.SaddlePoint(start="given")}, ValueError, "start: .* needs a map"),
        ({"progress": lambda fraction: 1 / 0}, ZeroDivisionError, "division by zero"),
    ],
)
def test_of_parameterize(
    arguments: dict[str, Any], error: type[Exception], message: str, capfd: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(error, match=message) as caught:
        sp.parameterize(**{"points": POINTS, "triangles": TRIANGLES, **arguments})
    assert type(caught.value) is error
    assert capfd.readouterr() == ("", "")


def test_of_others() -> None:
    for wrong, error in (("a", TypeError), (2.0, TypeError), (-1, ValueError)):
        with pytest.raises(error, match="degree: "):
            sp.harmonics(TRIANGLES, SPHERE, POINTS, wrong)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="index: one signature or more"):
        sp.search(np.zeros(96), [])
    with pytest.raises(TypeError, match="method: .*GirthProfiles.* not Isometric"):
        sp.segment(POINTS, TRIANGLES, SPHERE, sp.Isometric())  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="spring_exponent: a number is needed, not str"):
        sp.Balanced("3")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="coefficients: all have to be finite"):
        sp.Harmonics(np.full((9, 1), np.nan))


def test_values_that_make_no_sense() -> None:
    columns = np.ones((len(SPHERE), 2))
    of_faces = np.zeros(len(TRIANGLES), dtype=int)
    with pytest.raises(ValueError, match=r"labels: shape \(162,\) is needed, not \(162, 2\)"):
        RESAMPLING.majorities(columns)
    for labels, segments in ((np.ones((320, 2)), of_faces), (of_faces, np.ones((320, 2), dtype=int))):
        with pytest.raises(ValueError, match=r": shape \(320,\) is needed"):
            LOCATOR.transfer_segment_labels(labels, POINTS, TRIANGLES, SPHERE, segments)
    for shift in (-1, 1):
        with pytest.raises(sp.MeshError, match="numbered from 0"):
            LOCATOR.transfer_faces(of_faces, TRIANGLES + shift, SPHERE)
    with pytest.raises(IndexError):
        LOCATOR.interpolate(POINTS, [2**32], [[1, 0, 0]])
    for wrong in (np.diag([1, 1, -1]), 2 * np.eye(3), np.zeros((3, 3)), np.full((3, 3), np.nan)):
        with pytest.raises(ValueError, match="rotation: an orthogonal matrix"):
            SHAPE.rotated(wrong)
    with pytest.raises(ValueError, match="other_points: all have to be finite"):
        sp.length_changes(POINTS, TRIANGLES, POINTS * np.nan)
    with pytest.raises(ValueError, match="signatures: all have to be finite"):
        sp.relevance(np.full((3, 96), np.nan), np.zeros((3, 112)))
    for name, value in (("low", -np.inf), ("high", np.inf)):
        with pytest.raises(ValueError, match=f"{name}: a finite number"):
            sp.stretch_histogram(**MESH, **{name: value})  # type: ignore[arg-type]


def test_arrays_that_are_not_here() -> None:
    class Elsewhere:
        def __array__(self, *arguments: object, **settings: object) -> None:
            raise TypeError("copy it to the host first")

    for name in ("points", "triangles"):
        with pytest.raises(TypeError, match=f"{name}: copy it to the host first"):
            sp.parameterize(**{"points": POINTS, "triangles": TRIANGLES, name: Elsewhere()})  # type: ignore[arg-type]


def test_arrays_that_are_not_aligned() -> None:
    from spherical_parameterization.arrays import index_triples, vectors

    for array in (POINTS, TRIANGLES):
        shifted = np.frombuffer(b"x" + array.tobytes(), array.dtype, offset=1).reshape(array.shape)
        given = vectors("points", shifted) if array is POINTS else index_triples(shifted)
        assert given.flags.aligned and (given == array).all()


def test_a_locator_can_be_pickled() -> None:
    again = pickle.loads(pickle.dumps(LOCATOR))
    assert (again.transfer(POINTS, -SPHERE) == LOCATOR.transfer(POINTS, -SPHERE)).all()


def test_a_resampling_can_be_pickled() -> None:
    resampling = LOCATOR.linear_resampling(-SPHERE)
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(resampling, protocol))
        assert (again.means(POINTS) == resampling.means(POINTS)).all()
        assert (again.offsets == resampling.offsets).all()


COLUMN = sp.VertexColumn("a", np.zeros(len(POINTS)))


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda file: sp.read_mesh(5), TypeError, "path: the name of a file is needed, not int"),
        (lambda file: sp.read_data(5, 2), TypeError, "path: the name of a file is needed, not int"),
        (lambda file: sp.write_data(file, [np.zeros(3)]), TypeError, "columns: a list of VertexColumn is needed"),
        (lambda file: sp.write_data(file, COLUMN), TypeError, "columns: a list of VertexColumn is needed"),
        (lambda file: sp.write_data(file, [sp.VertexColumn(5, [1.0])]), TypeError, "name: a string is needed, not int"),
        (lambda file: sp.write_data(file, [sp.VertexColumn("", [1.0])]), ValueError, "columns: a name is empty"),
        (lambda file: sp.write_mesh(file, POINTS, TRIANGLES, data=5), TypeError, "columns: a list of VertexColumn is needed"),
        *(
            (lambda file, labels=labels: sp.write_data(file, [sp.VertexColumn("a", [1.0], labels)]), TypeError, "a: labels: a dict")
            for labels in (3, {0: "a"}, {0: ("a", (1, 2, 3))}, {0.5: ("a", (1, 1, 1, 1))}, {0: (b"a", (1, 1, 1, 1))})
        ),
        *((lambda file, wrap=wrap: sp.prepare(POINTS, TRIANGLES, wrap=wrap), TypeError, "wrap: ") for wrap in (5, None, ("a", "b"))),
        *((lambda file, wrap=wrap: sp.prepare(POINTS, TRIANGLES, wrap=wrap), ValueError, "wrap: ") for wrap in ((1,), (1, 0))),
        (lambda file: sp.atlas(5), TypeError, "meshes: a list of .* not int"),
        (lambda file: sp.atlas([POINTS, TRIANGLES]), TypeError, "meshes: mesh 0: a pair .* not ndarray"),
        (lambda file: sp.opencl_device([1]), TypeError, "name: a string is needed, not list"),
        (lambda file: LOCATOR.interpolate(POINTS, 3, [[1, 0, 0]]), ValueError, "faces: "),
        (lambda file: sp.parameterize(POINTS, TRIANGLES, accuracy=10**400), ValueError, "accuracy: "),
        (lambda file: sp.collection.map(["a"], len, store=5), TypeError, "store: the name of a file is needed, not int"),
        (lambda file: sp.parameterize(POINTS, TRIANGLES, fixed=([0, 0, 1, 2], np.eye(4, 3))), ValueError, "fixed: .* once"),
        (lambda file: sp.parameterize(POINTS, TRIANGLES, fixed=(np.eye(4, 1, dtype=int), np.eye(4, 3))), ValueError, "fixed: "),
        (lambda file: sp.Eigenpairs(np.ones(9), np.ones((5, 3)), np.ones(5)), ValueError, "values, functions and masses: "),
        (lambda file: sp.edges([[2**40, 2**40 + 1, 2**40 + 2]]), sp.MeshError, "a triangle names a point"),
    ],
)
def test_arguments_of_files_and_others(call: Callable[[str], object], error: type[Exception], message: str, tmp_path: Path) -> None:
    with pytest.raises(error, match=message):
        call(str(tmp_path / "out.ply"))
    assert not list(tmp_path.iterdir())


def test_directions_and_spheres_may_have_any_size() -> None:
    for scale in (1e-200, 1e200):
        assert np.allclose(SHAPE.at(SPHERE * scale), SHAPE.at(SPHERE), atol=1e-14)
        assert np.allclose(sp.Locator(TRIANGLES, SPHERE * scale).locate(SPHERE[:1])[1], LOCATOR.locate(SPHERE[:1])[1], atol=1e-12)


def test_segments_are_any_integers() -> None:
    labels = np.where(POINTS[TRIANGLES].mean(axis=1)[:, 0] < 0, "left", "right")
    segments = np.where(labels == "left", 0, 2**32)
    assert (LOCATOR.transfer_segment_labels(labels, POINTS, TRIANGLES, SPHERE, segments) == labels).all()


def test_a_locator_has_its_own_arrays() -> None:
    sphere, triangles = SPHERE.copy(), TRIANGLES.copy()
    locator = sp.Locator(triangles, sphere)
    expected = locator.transfer(AREAS.cumsum(), SPHERE, nearest=True)
    sphere[:], triangles[:] = 0, 0
    assert (locator.transfer(AREAS.cumsum(), SPHERE, nearest=True) == expected).all()


def test_methods_by_word_by_class_and_by_subclass() -> None:
    class Mine(sp.Isometric):
        pass

    expected = sp.parameterize(POINTS, TRIANGLES, sp.Isometric())
    for method in ("isometric", sp.Isometric, Mine()):
        result = sp.parameterize(POINTS, TRIANGLES, method)
        assert result.method == "isometric" and (result.sphere == expected.sphere).all()
    assert sp.parameterize(POINTS, TRIANGLES, "saddle-point", warn=False).method.startswith("saddle")

    class Growing(sp.RegionGrowing):
        pass

    bumps = POINTS * (1 + 0.3 * np.sin(5 * POINTS[:, :1]))
    labels = sp.segment(bumps, TRIANGLES, SPHERE, sp.RegionGrowing(threshold=0.1))
    assert (sp.segment(bumps, TRIANGLES, SPHERE, Growing(threshold=0.1)) == labels).all()
    assert (labels != sp.segment(bumps, TRIANGLES, SPHERE, "majority-vote")).any()


def test_no_fixed_vertices() -> None:
    free = sp.parameterize(POINTS, TRIANGLES).sphere
    for nothing in ({}, ([], []), ([], np.zeros((0, 3)))):
        assert (sp.parameterize(POINTS, TRIANGLES, fixed=nothing).sphere == free).all()


def test_weights_of_corners_agree_on_every_edge() -> None:
    edges = sp.edges(TRIANGLES)
    of_edges = np.random.default_rng(1).uniform(1, 2, len(edges))
    number = {tuple(e): w for e, w in zip(edges.tolist(), of_edges)}
    corners = [[number[tuple(sorted((t[k], t[(k + 1) % 3])))] for k in range(3)] for t in TRIANGLES.tolist()]
    expected = sp.parameterize(POINTS, TRIANGLES, weights=of_edges).sphere
    assert (sp.parameterize(POINTS, TRIANGLES, weights=corners).sphere == expected).all()
    corners[7][1] += 0.5
    with pytest.raises(ValueError, match=r"weights: an edge of triangle \d+ has another weight in the triangle beyond it"):
        sp.parameterize(POINTS, TRIANGLES, weights=corners)


@pytest.mark.parametrize("radius", [100, 1e-200, 1e200])
def test_spheres_of_any_radius(radius: float) -> None:
    """Also of float32, whose vectors are not quite of that length."""
    result = sp.parameterize(POINTS, TRIANGLES)
    sphere, large = result.sphere, result.sphere * radius
    summary = sp.distortion(POINTS, TRIANGLES, sphere)
    for name in ("log_area_stretch", "angle_distortion", "dilatation", "symmetric_dirichlet", "spherical_symmetric_dirichlet"):
        there = getattr(sp.distortion(POINTS, TRIANGLES, large), name)
        assert there.mean == pytest.approx(getattr(summary, name).mean, rel=1e-9, abs=1e-12)
        assert there.max == pytest.approx(getattr(summary, name).max, rel=1e-9, abs=1e-12)
    for measure in (sp.face_distortion, sp.vertex_log_area_stretch, sp.segment, sp.shape_signature, sp.stretch_histogram):
        assert np.allclose(measure(POINTS, TRIANGLES, large), measure(POINTS, TRIANGLES, sphere), atol=1e-9)
    assert np.allclose(sp.texture_coordinates(POINTS, TRIANGLES, large).uv, sp.texture_coordinates(POINTS, TRIANGLES, sphere).uv)
    single = sphere.astype(np.float32)
    exactly = sp.face_distortion(POINTS, TRIANGLES, single)
    assert (exactly == sp.face_distortion(POINTS, TRIANGLES, single.astype(float))).all()
    assert sp.distortion(POINTS, TRIANGLES, result) == summary  # the Result itself
    assert (sp.segment(POINTS, TRIANGLES, result) == sp.segment(POINTS, TRIANGLES, sphere)).all()
    for nowhere in (0, np.nan, np.inf):
        large[3] = nowhere
        with pytest.raises(sp.MeshError, match="sphere: row 3 is no direction"):
            sp.distortion(POINTS, TRIANGLES, large)


def test_masses_that_cannot_be_centred() -> None:
    masses = np.full(len(SPHERE), 1e-3)
    masses[5] = 1
    with pytest.warns(sp.MapWarning, match="cannot be centred.* off"):
        sp.moebius_centred(SPHERE, TRIANGLES, masses)


def test_what_is_printed_is_one_line() -> None:
    result = sp.parameterize(POINTS, TRIANGLES)
    things = [result, SHAPE, LOCATOR, sp.certify(TRIANGLES, SPHERE), SHAPE.ellipsoid(), sp.texture_coordinates(**MESH)]
    things += [sp.register_maps(**MESH, **OTHER, motion="rotation"), sp.shape_statistics(**SHAPES), sp.align_shapes(**SHAPES)]
    for thing in things:
        assert "\n" not in repr(thing) and len(repr(thing)) < 400 and type(thing).__name__ in repr(thing)
    assert repr(sp.certify(TRIANGLES, SPHERE)) == "<Certificate: valid, 0 flipped faces, degree 1>"
    assert "not valid" in repr(sp.certify(TRIANGLES, -SPHERE))


def test_codes_are_those_of_the_header() -> None:
    header = Path(__file__).parents[2] / "include/CGAL/Spherical_parameterization/values/Error.h"
    listed = re.findall(r'CODE\((\w+), "(.*)"\)', header.read_text())
    assert [(code.value, code.message) for code in sp.ErrorCode] == listed and len(listed) == 19
    assert all(f"{name}\n    {sentence}" in str(sp.ErrorCode.__doc__) for name, sentence in listed)
