# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done with a map."""

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy, double_areas, ellipsoid, refused, rotation, tube


@pytest.fixture(scope="module")
def mapped() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    points, triangles = bumpy()
    return points, triangles, sp.parameterize(points, triangles, sp.Balanced()).sphere


def test_certify(mapped: tuple[np.ndarray, ...]) -> None:
    points, triangles, sphere = mapped
    assert sp.certify(triangles, 7 * sphere).is_valid
    assert sp.certify(triangles, sphere.astype(np.float32)).is_valid
    assert sp.certify(triangles, -sphere) == sp.Certificate(len(triangles), -1)
    folded = sphere.copy()
    folded[0] *= -1
    assert sp.certify(triangles, folded).flipped_faces > 0
    folded[0] = np.nan
    with refused("NON_FINITE_COORDINATE"):
        sp.certify(triangles, folded)


@pytest.mark.parametrize("measure", ["log_area_stretch", "angle_distortion", "dilatation", "symmetric_dirichlet"])
def test_distortion(mapped: tuple[np.ndarray, ...], measure: str) -> None:
    points, triangles, _ = mapped
    values = sp.face_distortion(*mapped, measure)
    assert values.shape == (len(triangles),)
    summary = getattr(sp.distortion(*mapped), measure)
    assert summary.mean == pytest.approx(np.average(values, weights=double_areas(points, triangles)))
    assert (summary.min, summary.max) == (values.min(), values.max())
    assert (sp.face_distortion(*mapped, measure, policy="sequential") == values).all()
    with pytest.raises(ValueError, match="measure"):
        sp.face_distortion(*mapped, "area")


def test_vertex_stretch(mapped: tuple[np.ndarray, ...]) -> None:
    points, triangles, _ = mapped
    of_faces = sp.face_distortion(*mapped)
    sums, counts = np.zeros(len(points)), np.zeros(len(points))
    np.add.at(sums, triangles, of_faces[:, None])
    np.add.at(counts, triangles, 1)
    assert np.allclose(sp.vertex_log_area_stretch(*mapped), sums / counts)
    assert (sp.mean_over_faces(triangles, of_faces) == sp.vertex_log_area_stretch(*mapped)).all()
    with pytest.raises(ValueError, match="values"):
        sp.mean_over_faces(triangles, of_faces[1:])
    for wrong, code in ((triangles[1:], "BOUNDARY"), (np.where(triangles == 7, 2**40, triangles), "BAD_INDEX")):
        with refused(code):
            sp.mean_over_faces(wrong, of_faces[: len(wrong)])
    assert "dilatation" in str(sp.distortion(*mapped))


def test_segments() -> None:
    points, triangles = sp.icosphere(4)
    points = points.copy()
    for axis in range(3):  # six arms
        is_arm = np.abs(points[:, axis]) > 0.9
        points[is_arm, axis] *= 1 + 40 * (np.abs(points[is_arm, axis]) - 0.9)
    sphere = sp.parameterize(points, triangles, sp.Balanced(), weights="clamped", warn=False).sphere  # as tuned
    labels = sp.segment(points, triangles, sphere, sp.GirthProfiles())
    assert labels.max() == 6 and set(labels) == set(range(7))
    stretch = sp.face_distortion(points, triangles, sphere)
    assert (sp.segment(points, triangles, sphere, sp.GirthProfiles(), stretch=stretch) == labels).all()
    assert sp.segment(points, triangles, sphere, sp.MajorityVote(number_of_segments=3)).max() == 2
    assert sp.segment(points, triangles, sphere, sp.RegionGrowing(threshold=0.5)).shape == labels.shape
    with pytest.raises(ValueError, match="minimum area"):
        sp.segment(points, triangles, sphere, sp.MajorityVote(minimum_area=2))


def test_texture(mapped: tuple[np.ndarray, ...]) -> None:
    for chart in ("latitude-longitude", "octahedral"):
        texture = sp.texture_coordinates(*mapped, chart=chart)
        u, v = np.moveaxis(texture.uv, 2, 0)
        assert ((u[:, 1] - u[:, 0]) * (v[:, 2] - v[:, 0]) > (u[:, 2] - u[:, 0]) * (v[:, 1] - v[:, 0])).all()
        assert texture.uv.min() >= -1 and texture.uv.max() <= 2
        seams = sp.texture_seams(mapped[1], texture.uv)
        assert len(seams) > 5 and (seams[:, 0] < seams[:, 1]).all()
        # across all other edges both faces have the same coordinates at both ends
        corners: dict[tuple[int, int], list[tuple[object, object]]] = {}
        for f, face in enumerate(mapped[1].tolist()):
            for k in range(3):
                ends = sorted(((face[k], k), (face[k - 2], (k + 1) % 3)))
                at = tuple(tuple(texture.uv[f, corner]) for _, corner in ends)
                corners.setdefault((ends[0][0], ends[1][0]), []).append(at)
        assert {e for e, (left, right) in corners.items() if left != right} == set(map(tuple, seams.tolist()))
    with pytest.raises(ValueError, match="uv"):
        sp.texture_seams(mapped[1], texture.uv[1:])
    north = sp.texture_coordinates(*mapped, axes=([0, 0, 5], [1, 0, 0]))
    assert np.allclose(north.north, [0, 0, 1]) or np.allclose(north.north, [0, 0, 5])
    latitude = np.arcsin(mapped[2][mapped[1]][:, :, 2]) / np.pi + 0.5
    assert np.allclose(north.uv[:, :, 1], latitude)
    with pytest.raises(ValueError):
        sp.texture_coordinates(*mapped, axes=([0, 0, 5], [0, 0, 1]))
    with pytest.raises(sp.MeshError):
        sp.texture_coordinates(mapped[0], mapped[1], -mapped[2])


def test_locate(mapped: tuple[np.ndarray, ...]) -> None:
    points, triangles, sphere = mapped
    locator = sp.Locator(triangles, sphere)
    directions = np.random.default_rng(0).normal(size=(1000, 3))
    faces, weights = locator.locate(directions)
    assert np.allclose(weights.sum(axis=1), 1) and weights.min() >= 0
    images = (sphere[triangles[faces]] * weights[:, :, None]).sum(axis=1)
    images /= np.linalg.norm(images, axis=1)[:, None]
    assert np.allclose(images, directions / np.linalg.norm(directions, axis=1)[:, None], atol=1e-9)
    expected = (points[triangles[faces]] * weights[:, :, None]).sum(axis=1)
    assert np.allclose(locator.interpolate(points, faces, weights), expected)
    assert np.allclose(locator.transfer(points[:, 1], directions), expected[:, 1])
    alone = sp.Locator(triangles, sphere, policy="sequential")
    assert all((a == b).all() for a, b in zip(alone.locate(directions), (faces, weights)))
    assert np.allclose(locator.transfer(points, sphere), points)
    result = sp.parameterize(points, triangles)  # a map as directions
    assert (locator.transfer(points, result) == locator.transfer(points, result.sphere)).all()
    assert (locator.linear_resampling(result).means(points) == locator.transfer(points, result)).all()
    shape = sp.harmonics(triangles, sphere, points, 3)
    assert (shape.at(result) == shape.at(result.sphere)).all()
    labels = np.arange(len(triangles)).astype(str)
    assert (locator.transfer_faces(labels, triangles, sphere) == labels).all()
    with pytest.raises(ValueError, match="rows"):
        locator.transfer_faces(labels[1:], triangles, sphere)
    halves = np.where(points[triangles].mean(axis=1)[:, 0] < 0, "left", "right")
    segments = (halves == "left") + 2 * np.arange(len(triangles))
    assert (locator.transfer_segment_labels(halves, points, triangles, sphere, segments) == halves).all()
    whole = locator.transfer_segment_labels(halves, points, triangles, sphere, 0 * segments)
    assert set(whole) < {"left", "right"}
    with pytest.raises(ValueError, match="rows"):
        locator.transfer_segment_labels(halves, points, triangles, sphere, segments[1:])
    with pytest.raises(sp.MeshError):
        locator.locate([[0, 0, 0]])
    with refused("NOT_BIJECTIVE"):
        sp.Locator(triangles, -sphere)
    with pytest.raises(ValueError, match="rows"):
        locator.transfer(points[1:], directions)
    for wrong in (-1, len(triangles)):
        with pytest.raises(IndexError):
            locator.interpolate(points, [wrong], [[1, 0, 0]])


def test_resample(mapped: tuple[np.ndarray, ...]) -> None:
    points, triangles, sphere = sp.Locator(*mapped[1:]).resample(mapped[0], 3)
    assert len(points) == len(sphere) == 642 and sp.certify(triangles, sphere)
    with pytest.raises(ValueError, match="level"):
        sp.icosphere(13)


def test_resampling(mapped: tuple[np.ndarray, ...]) -> None:
    points, triangles, sphere = mapped
    images, other_triangles = sp.icosphere(2)
    locator, other = sp.Locator(triangles, sphere), sp.Locator(other_triangles, images)
    linear = locator.linear_resampling(images)
    np.testing.assert_allclose(linear.means(points), locator.transfer(points, images), atol=1e-12)
    labels = np.where(points[:, 0] > 0, "right", "left")
    assert (linear.nearest(labels) == locator.transfer(labels, images, nearest=True)).all()
    areas = [sp.mean_vertex_areas([p], t) for p, t in ((points, triangles), (linear.means(points), other_triangles))]
    kept = locator.area_preserving_resampling(areas[0], other, areas[1])
    assert len(kept.offsets) == len(images) + 1 and (kept.means(np.full(len(points), 0.1)) == 0.1).all()
    assert (kept.offsets.dtype, kept.vertices.dtype, kept.weights.dtype) == (np.int64, np.int32, np.float64)
    assert (kept.means(points)[:, 1] == kept.means(points[:, 1])).all() and kept.means(points[:, :0]).shape == (len(images), 0)
    assert set(kept.vertices) == set(range(len(points)))  # the new mesh is coarser
    matrix = np.zeros((len(images), len(points)))
    for i, (first, last) in enumerate(zip(kept.offsets, kept.offsets[1:])):
        matrix[i, kept.vertices[first:last]] = kept.weights[first:last]
    np.testing.assert_allclose(matrix @ points, kept.means(points), atol=1e-12)
    votes = matrix @ (labels == "right") - matrix @ (labels == "left")
    assert ((kept.majorities(labels) == "right") == (votes > 0))[abs(votes) > 1e-9].all()
    with pytest.raises(ValueError, match="other_areas: finite"):
        locator.area_preserving_resampling(areas[0], other, -areas[1])


def test_align(mapped: tuple[np.ndarray, ...]) -> None:
    points, triangles, sphere = mapped
    a, b = sp.Locator(triangles, sphere), sp.Locator(triangles, sphere @ rotation(1).T)
    found = a.align(points, b, points)
    assert np.allclose(found, rotation(1), atol=0.02) and np.linalg.det(found) == pytest.approx(1)
    with pytest.raises(ValueError, match="shape"):
        a.align(points[1:], b, points)


def test_search() -> None:
    shapes = [ellipsoid(), tube(30), bumpy(4, 1), bumpy(4, 2)]
    index = np.array([sp.shape_signature(*shape) for shape in shapes])
    assert index.shape == (4, 96) and index.min() >= 0
    points, triangles = shapes[1]
    turned = np.random.default_rng(1).permutation(np.eye(3)) @ points.T * 7
    numbers, distances = sp.search(sp.shape_signature(turned.T, triangles), index, k=2)
    assert numbers[0] == 1 and distances[0] < 0.01 < distances[1]
    assert distances[1] == pytest.approx(np.abs(index[numbers[1]] - index[1]).sum(), abs=0.01)
    with pytest.raises(ValueError, match="96"):
        sp.search(index[0], index[:, 1:])


def test_relevance() -> None:
    triangles = sp.icosphere(3)[1]
    shapes = [sp.icosphere(3)[0] * (1, 1, z) for z in (1, 1.1, 1.2, 1.3, 3, 3.2, 3.4)]
    signatures = [sp.shape_signature(points, triangles) for points in shapes]
    forms = [sp.shape_form(points, triangles) for points in shapes]
    assert np.allclose([form[:64].sum() * 0.435 for form in forms], 1)
    found = sp.relevance(signatures, forms)
    assert found[0] == 1 and found[1:4].min() > found[4:].max() >= 0
    with pytest.raises(ValueError, match="forms: 7 rows"):
        sp.relevance(signatures, forms[1:])
    with pytest.raises(ValueError, match="signatures: shape"):
        sp.relevance([], [])


def test_histogram(mapped: tuple[np.ndarray, ...]) -> None:
    for sampling in ("exact-areas", "uniform", "random", "vertices"):
        shares = sp.stretch_histogram(*mapped, sampling=sampling, bins=8, low=-2, high=2)
        assert shares.shape == (8,) and shares.sum() == pytest.approx(1)


def test_devices() -> None:
    for device in sp.opencl_devices():
        assert device["name"] and device["memory"] > 0
    with pytest.raises((sp.DeviceError, ValueError), match="no OpenCL"):
        sp.opencl_device("no such device")


def test_labels_are_those_of_the_nearest_corner() -> None:
    points, triangles = sp.icosphere(3)
    names = np.array([f"label {i}" for i in range(len(points))])
    locator = sp.Locator(triangles, points)
    nearby = points + 1e-3 * np.random.default_rng(0).normal(size=points.shape)
    assert (locator.transfer(names, nearby, nearest=True) == names).all()
    faces, weights = locator.locate(points[triangles].mean(axis=1))
    assert np.array_equal(triangles[faces, weights.argmax(axis=1)], locator.transfer(np.arange(len(points)), points[triangles].mean(axis=1), nearest=True))
    with pytest.raises(ValueError, match="rows are needed"):
        locator.transfer(names[1:], nearby, nearest=True)


def test_lengths_of_the_vectors_of_a_map_do_not_matter() -> None:
    sphere, triangles = sp.icosphere(2)
    lengths = 1 + 0.3 * np.random.default_rng(1).random((len(sphere), 1))
    directions = np.random.default_rng(2).normal(size=(50, 3))
    faces, weights = sp.Locator(triangles, sphere).locate(directions)
    same_faces, same_weights = sp.Locator(triangles, lengths * sphere).locate(directions)
    assert np.array_equal(faces, same_faces)
    assert np.allclose(weights, same_weights, rtol=0, atol=1e-12)
