# SPDX-License-Identifier: GPL-3.0-or-later
"""parameterize(): arguments, results, errors, interruption, threads, memory."""

import importlib.util
import os
import pickle
import signal
import threading
import time
import tracemalloc
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy, cotangents, double_areas, ellipsoid, refused, torus, tube


def test_result() -> None:
    points, triangles = ellipsoid()
    result = sp.parameterize(points, triangles)
    assert result and result.is_valid and result.error is sp.ErrorCode.OK and result.error == "OK"
    assert result.sphere.shape == points.shape and result.sphere.dtype == np.float64
    assert np.allclose(np.linalg.norm(result.sphere, axis=1), 1, atol=1e-15)
    assert (result.flipped_faces, result.degree, result.method) == (0, 1, "balanced")
    assert (result.number_of_vertices, result.number_of_faces) == (len(points), len(triangles))
    assert 0 < result.residual <= 2e-9 and result.seconds.total == float(result.seconds) > 0
    assert [(a.method, a.termination) for a in result.attempts] == [("balanced", "converged")]
    assert result.termination == "converged"
    assert str(result).startswith("valid spherical map (2562 vertices, 0 flipped faces, degree 1, residual ")
    assert sp.certify(triangles, result.sphere).is_valid


@pytest.mark.parametrize("policy", ["sequential", "parallel", "opencl", "device"])
@pytest.mark.parametrize(
    "method", [sp.Automatic(), sp.Balanced(3), sp.Isometric(), sp.SaddlePoint(start="harmonic")], ids=str
)
def test_policies_give_the_same_bits(policy: str, method: object) -> None:
    if policy in ("opencl", "device") and not sp.opencl_devices():
        pytest.skip("no OpenCL device")
    where = sp.opencl_device(smallest_mesh=0) if policy == "device" else policy
    points, triangles = bumpy(3)
    first = sp.parameterize(points, triangles, method, policy="sequential", iterations=5, warn=False)
    second = sp.parameterize(points, triangles, method, policy=where, iterations=5, warn=False)
    assert (second.sphere == first.sphere).all()


@pytest.mark.parametrize("dtype", [np.int8, np.int32, np.int64, np.uint16, np.uint32, np.uint64, ">i4"])
def test_types_of_arrays(dtype: object) -> None:
    points, triangles = bumpy(1)
    expected = sp.parameterize(points, triangles).sphere
    assert (sp.parameterize(points, triangles.astype(dtype)).sphere == expected).all()
    assert (sp.parameterize(np.asfortranarray(points), np.asfortranarray(triangles)).sphere == expected).all()
    assert (sp.parameterize(points.tolist(), triangles.tolist()).sphere == expected).all()
    assert (sp.parameterize(points.astype(">f8"), triangles).sphere == expected).all()
    wide = np.zeros((len(points), 5))
    wide[:, 1:4] = points
    assert (sp.parameterize(wide[:, 1:4], triangles).sphere == expected).all()
    single = points.astype(np.float32)
    assert (sp.parameterize(single, triangles).sphere == sp.parameterize(single.astype(float), triangles).sphere).all()


def test_arguments_stay_as_they_are() -> None:
    points, triangles = bumpy(2)
    points.flags.writeable = triangles.flags.writeable = False
    start = np.ascontiguousarray(points)
    sp.parameterize(points, triangles, sp.SaddlePoint(start="given"), start=start, iterations=1, warn=False)
    assert (start == points).all()


def test_weights() -> None:
    points, triangles = bumpy()
    edges = sp.edges(triangles)
    assert len(edges) == 3 * len(triangles) // 2 and (edges[:, 0] < edges[:, 1]).all()
    barycentric = sp.parameterize(points, triangles, weights="barycentric").sphere
    assert (sp.parameterize(points, triangles, weights=np.full(len(edges), 1.0)).sphere == barycentric).all()
    conformal = sp.parameterize(points, triangles, weights="conformal").sphere
    assert (sp.parameterize(points, triangles).sphere == conformal).all()
    clamped = sp.parameterize(points, triangles, weights="clamped").sphere
    assert (clamped != conformal).any()
    assert (sp.parameterize(points, triangles, weights=sp.ClampedWeights()).sphere == clamped).all()
    assert (sp.parameterize(points, triangles, weights=sp.ClampedWeights(20, 80)).sphere != clamped).any()
    assert (sp.parameterize(points, triangles, weights="mean-value").sphere != conformal).any()

    bounds = 1 / np.tan(np.radians([85, 5]))  # as the core clamps
    across = np.sort(np.stack([np.roll(triangles, -1, axis=1), np.roll(triangles, 1, axis=1)], axis=-1), axis=-1)
    keys = {tuple(e): i for i, e in enumerate(edges.tolist())}
    own = np.zeros(len(edges))
    for edge, value in zip(across.reshape(-1, 2).tolist(), np.clip(cotangents(points, triangles), *bounds).ravel()):
        own[keys[tuple(edge)]] += value / 2
    assert np.allclose(sp.parameterize(points, triangles, weights=own).sphere, clamped, atol=1e-6)
    with pytest.raises(ValueError, match="weights"):
        sp.parameterize(points, triangles, weights=own[1:])


def test_fixed_vertices() -> None:
    points, triangles = ellipsoid(3)
    fixed = {0: [1.0, 0, 0], 100: [0, 1.0, 0], 300: [0, 0, 2.0]}
    result = sp.parameterize(points, triangles, fixed=fixed, warn=False)
    assert (result.sphere[[0, 100, 300]] == np.eye(3)).all()
    again = sp.parameterize(points, triangles, fixed=([0, 100, 300], [[1, 0, 0], [0, 1, 0], [0, 0, 2]]), warn=False)
    assert (again.sphere == result.sphere).all()
    for wrong in ({0: [1, 0, 0]}, {-1: [1, 0, 0]}, {10**6: [1, 0, 0]}):
        with refused("BAD_CONSTRAINTS"):
            sp.parameterize(points, triangles, fixed=wrong)


POINTS, TRIANGLES = np.vstack([np.zeros(3), np.eye(3)]), np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
BROKEN = {
    "EMPTY_MESH": (POINTS, TRIANGLES[:0]),
    "NOT_TRIANGULAR": (POINTS, np.array([[0, 1, 2, 3]])),
    "ISOLATED_VERTEX": (np.vstack([POINTS, [5, 5, 5]]), TRIANGLES),
    "BOUNDARY": (POINTS, TRIANGLES[1:]),
    "NON_MANIFOLD": (POINTS, np.vstack([TRIANGLES, TRIANGLES[:1]])),
    "INCONSISTENT_ORIENTATION": (POINTS, np.vstack([TRIANGLES[:1, ::-1], TRIANGLES[1:]])),
    "SEVERAL_COMPONENTS": (np.vstack([POINTS, POINTS + 9]), np.vstack([TRIANGLES, TRIANGLES + 4])),
    "WRONG_GENUS": torus(),
    "NON_FINITE_COORDINATE": (POINTS * np.array([[np.nan], [1], [1], [1]]), TRIANGLES),
    "DEGENERATE_FACE": (POINTS * 0, TRIANGLES),
    "BAD_INDEX": (POINTS, np.vstack([TRIANGLES[:3], [[2, 0, 2**32 + 3]]])),
}


@pytest.mark.parametrize("code", BROKEN)
def test_errors_of_meshes(code: str) -> None:
    with pytest.raises(sp.MeshError) as caught:
        sp.parameterize(*BROKEN[code], sp.Balanced(), weights="mean-value")
    error = caught.value
    assert error.code is sp.ErrorCode[code] and error.detail
    assert str(error) == f"{error.code.message}: {error.detail}"
    copy = pickle.loads(pickle.dumps(error))
    assert (copy.code, copy.detail, str(copy)) == (error.code, error.detail, str(error))


def test_landmarks() -> None:
    points, triangles = ellipsoid(3)
    fixed = {0: [1.0, 0, 0], 100: [0, 1.0, 0], 300: [0, 0, 1.0], 500: [0, -1.0, 0]}
    result = sp.parameterize(points, triangles, sp.Isometric(), fixed=fixed)
    assert result and all((result.sphere[v] == p).all() for v, p in fixed.items())
    soft = sp.parameterize(points, triangles, sp.Isometric(landmark_weight=1), fixed=fixed)
    assert soft and not any((soft.sphere[v] == p).all() for v, p in fixed.items())


def test_densities() -> None:
    sphere, triangles = sp.icosphere(4)
    of_triangles = np.where(sphere[triangles].sum(axis=1)[:, 2] > 0, 4.0, 1.0)
    result = sp.parameterize(sphere, triangles, density=of_triangles)
    assert result and result.method == "isometric" and 0 < result.density_deviation < 0.25
    area = double_areas(result.sphere, triangles)
    assert abs(area[of_triangles == 4].sum() / area.sum() - 0.8) < 0.02
    of_points = np.exp(sphere[:, 2])
    results = [sp.parameterize(sphere, triangles, sp.Isometric(e), density=of_points) for e in (1, 10, 30)]
    assert results[0].density_deviation > results[1].density_deviation > results[2].density_deviation
    assert (sp.parameterize(sphere, triangles, sp.Isometric(), density=of_points).sphere == results[1].sphere).all()
    assert sp.parameterize(sphere, triangles).density_deviation == 0
    of_points[5] = 0
    with refused("BAD_DENSITY", "vertex 5 has the density 0"):
        sp.parameterize(sphere, triangles, density=of_points)
    with pytest.raises(ValueError, match=r"density: shape \(2562,\) or \(5120,\) is needed, not \(7,\)"):
        sp.parameterize(sphere, triangles, density=np.ones(7))
    with pytest.raises(ValueError, match="densities need the isometric or the automatic method"):
        sp.parameterize(sphere, triangles, sp.Balanced(), density=of_triangles)


def test_other_errors() -> None:
    points, triangles = ellipsoid(2)
    with refused("BAD_WEIGHT"):
        sp.parameterize(points, triangles, weights=-np.ones(len(sp.edges(triangles))))
    i, j, k = triangles[0]
    with refused("BAD_CONSTRAINTS"):
        sp.parameterize(points, triangles, sp.Isometric(), fixed={i: [1, 0, 0], k: [0, 1, 0], j: [0, 0, 1]})
    with pytest.warns(sp.MapWarning, match="did not reach the accuracy"):
        result = sp.parameterize(points, triangles, sp.Balanced(), iterations=1)
    assert result.termination == "iterations" and result.attempts[0].termination == "iterations"
    assert result.error == "NOT_CONVERGED" and not result and result.sphere.any() and result.detail
    # which tubes converge to a map that doubles do not resolve is a matter of rounding
    options = {"method": sp.Balanced(), "weights": "barycentric"}
    rings = next(n for n in range(160, 200, 2) if sp.parameterize(*tube(n), **options, warn=False).error == "NOT_BIJECTIVE")
    with pytest.warns(sp.MapWarning, match="not bijective"):
        result = sp.parameterize(*tube(rings), **options)
    assert result.error == "NOT_BIJECTIVE" and result.flipped_faces > 0
    certificate = sp.certify(tube(rings)[1], result.sphere)
    assert not certificate and certificate == sp.Certificate(result.flipped_faces, result.degree)


def test_automatic_falls_back() -> None:
    result = sp.parameterize(*tube())
    assert result.is_valid and len(result.attempts) > 1 and result.fallback_reason
    assert result.attempts[0].error is not sp.ErrorCode.OK and result.attempts[-1].error is sp.ErrorCode.OK


def test_results_can_be_pickled() -> None:
    result = sp.parameterize(*ellipsoid(2))
    copy = pickle.loads(pickle.dumps(result))
    assert (copy.sphere == result.sphere).all() and copy.seconds == result.seconds and str(copy) == str(result)


def test_progress() -> None:
    fractions: list[float] = []
    result = sp.parameterize(*bumpy(6), sp.Isometric(), progress=fractions.append)
    assert result.is_valid and fractions == sorted(fractions) and fractions[-1] == 1 and len(fractions) > 2


def test_tqdm() -> None:
    tqdm = pytest.importorskip("tqdm")
    with tqdm.tqdm(total=100, disable=False, file=open(os.devnull, "w")) as bar:
        sp.parameterize(*bumpy(4), progress=bar)
        assert bar.n == pytest.approx(100)


def endless() -> dict[str, object]:
    """Settings of a call that does not come to an end, and has a map all the time."""
    method = sp.SaddlePoint(start="harmonic", check_interval=1)
    return {"method": method, "accuracy": 1e-300, "iterations": 10**9}


def test_progress_stops() -> None:
    calls: list[float] = []

    def progress(fraction: float) -> bool:
        calls.append(fraction)
        return len(calls) < 3

    with pytest.warns(sp.MapWarning, match="interrupted"):
        result = sp.parameterize(*bumpy(5), **endless(), progress=progress)
    assert result.error == "INTERRUPTED" and result.degree == 1 and len(calls) == 3 and result.termination == "callback"


def test_false_of_numpy_ends_a_call() -> None:
    result = sp.parameterize(*bumpy(5), **endless(), progress=lambda fraction: np.bool_(fraction == 0), warn=False)
    assert result.termination == "callback"


def test_time_limit() -> None:
    start = time.monotonic()
    with pytest.warns(sp.MapWarning, match="the time limit was reached"):
        result = sp.parameterize(*bumpy(5), **endless(), maximum_running_time=0.2)
    assert result.termination == "time"
    assert result.error == "INTERRUPTED" and 0.2 <= time.monotonic() - start < 10


def test_ctrl_c_gives_the_best_map() -> None:
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    start = time.monotonic()
    result = sp.parameterize(*bumpy(6), **endless(), warn=False)
    assert result.error == "INTERRUPTED" and result.degree == 1 and time.monotonic() - start < 20


def test_ctrl_c_without_a_map() -> None:
    def progress(fraction: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sp.parameterize(*bumpy(6), sp.Isometric(), progress=progress, policy="sequential")


def test_ctrl_c_ends_what_would_go_on_with_the_map(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    points, triangles = bumpy(4)
    sp.write_mesh(tmp_path / "a.off", points, triangles)

    def progress(fraction: float) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(sp.maps, "callback_of", lambda given: progress)
    with pytest.raises(KeyboardInterrupt):
        sp.collection.map_file(str(tmp_path / "a.off"), policy="parallel")
    with pytest.raises(KeyboardInterrupt):
        sp.shape_signature(points, triangles)
    with pytest.raises(KeyboardInterrupt):
        sp.atlas([(points, triangles)] * 2)
    if importlib.util.find_spec("spherical_parameterization._preparation"):
        with pytest.raises(KeyboardInterrupt):
            sp.view(points, triangles)


def test_other_threads_go_on() -> None:
    """The interpreter's lock is free while a map is computed."""
    with ThreadPoolExecutor(1) as pool:
        mapped = pool.submit(sp.parameterize, *bumpy(6), sp.Isometric(), policy="sequential")
        counts = 0
        while not mapped.done():
            counts += 1
            time.sleep(0.001)
    assert counts > 100 * min(mapped.result().seconds.total, 1)


def test_threads_map_meshes() -> None:
    def sphere(seed: int) -> np.ndarray:
        return sp.parameterize(*bumpy(5, seed), policy="sequential").sphere

    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(sphere, range(4)))
    assert all((found[seed] == sphere(seed)).all() for seed in range(4))


@pytest.mark.parametrize("dtype", ["int32", "int64"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_are_not_copied(dtype: str, order: str) -> None:
    from spherical_parameterization.arrays import index_triples, vectors

    points, triangles = ellipsoid()
    points, triangles = np.asarray(points, order=order), np.asarray(triangles, dtype=dtype, order=order)
    assert np.shares_memory(vectors("points", points), points) == (order == "C")
    assert np.shares_memory(index_triples(triangles), triangles) == (order == "C")


@pytest.mark.parametrize("dtype", ["int32", "int64"])
def test_memory_of_a_call(dtype: str) -> None:
    """The sphere, and nothing else of its size."""
    points, triangles = ellipsoid(6)
    triangles = triangles.astype(dtype)
    tracemalloc.start()
    try:
        result = sp.parameterize(points, triangles, sp.Balanced(), policy="sequential")
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert result.sphere.nbytes <= peak < 1.1 * result.sphere.nbytes


def test_progress_stops_short_calls_too() -> None:
    with pytest.raises(sp.MeshError, match="before there was a map") as refused:
        sp.parameterize(*bumpy(2), progress=lambda fraction: False)
    assert refused.value.code == "INTERRUPTED"
