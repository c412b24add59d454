#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares resampling with wb_command (Debian: connectome-workbench), and prints a table for doc/inverse_map.md.

    PYTHONPATH=build/python benchmark/workbench.py SURFACE.gii SPHERE.gii

The files are those of fsaverage5. Needs nibabel and SciPy.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import nibabel as nib
import numpy as np
from scipy.spatial import cKDTree

import spherical_parameterization as sp

SCRATCH = tempfile.TemporaryDirectory()  # is removed at the end
FOLDER = Path(SCRATCH.name)


def write_surface(name: str, points: np.ndarray, triangles: np.ndarray, kind: str) -> Path:
    meta = nib.gifti.GiftiMetaData({"AnatomicalStructurePrimary": "CortexLeft", "GeometricType": kind})
    arrays = [
        nib.gifti.GiftiDataArray(np.float32(points), "NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32", meta=meta),
        nib.gifti.GiftiDataArray(np.int32(triangles), "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32"),
    ]
    nib.save(nib.gifti.GiftiImage(darrays=arrays), FOLDER / name)
    return FOLDER / name


def write_data(name: str, values: np.ndarray) -> Path:
    meta = nib.gifti.GiftiMetaData({"AnatomicalStructurePrimary": "CortexLeft"})
    image = nib.gifti.GiftiImage(meta=meta)
    is_label = values.dtype.kind == "i"
    if is_label:
        for key in np.unique(values):
            label = nib.gifti.GiftiLabel(int(key), 1, 1, 1, 1)
            label.label = f"label {key}"
            image.labeltable.labels.append(label)
    kind = ("LABEL", "INT32") if is_label else ("SHAPE", "FLOAT32")
    image.add_gifti_data_array(nib.gifti.GiftiDataArray(values, f"NIFTI_INTENT_{kind[0]}", f"NIFTI_TYPE_{kind[1]}"))
    nib.save(image, FOLDER / name)
    return FOLDER / name


def rolled(file: Path, axis: int, corner: int) -> Path:
    points, triangles = nib.load(file).agg_data()
    return write_surface(f"rolled_{file.name}", np.roll(points, axis, 1), np.roll(triangles, corner, 1), "Sphere")


def wb(command: str, *arguments: object) -> np.ndarray:
    """Runs wb_command, and reads its output."""
    out = next(a for a in arguments if isinstance(a, Path) and a.name.startswith("out"))
    subprocess.run(["wb_command", f"-{command}", *map(str, arguments)], check=True, capture_output=True)
    return nib.load(out).darrays[0].data


def radius_100(points: np.ndarray) -> np.ndarray:
    """As wb_command takes a sphere."""
    return np.float64(points) * (100 / np.linalg.norm(points, axis=1, keepdims=True))


def at_nearest_points(values: np.ndarray, triangles: np.ndarray, sphere: np.ndarray, queries: np.ndarray) -> np.ndarray:
    """Linear interpolation at the nearest point of the polyhedron: what wb_command does, here in doubles."""
    _, candidates = cKDTree(sphere[triangles].mean(axis=1)).query(queries, k=12)
    nearest, weights, corners = np.full(len(queries), np.inf), np.empty((len(queries), 3)), np.empty((len(queries), 3), int)
    for face in triangles[candidates].swapaxes(0, 1):
        a, b, c = sphere[face].swapaxes(0, 1)
        base = np.stack([b - a, c - a], axis=2)
        inner = np.linalg.solve(base.swapaxes(1, 2) @ base, (base.swapaxes(1, 2) @ (queries - a)[:, :, None]))[:, :, 0]
        tries = [np.column_stack([1 - inner.sum(axis=1), inner])]
        for i in range(3):  # the edges
            p, q = sphere[face[:, i]], sphere[face[:, i - 2]]
            t = np.clip(((queries - p) * (q - p)).sum(axis=1) / ((q - p) ** 2).sum(axis=1), 0, 1)
            tries.append(np.zeros_like(tries[0]))
            tries[-1][:, i], tries[-1][:, i - 2] = 1 - t, t
        for w in tries:
            d = np.linalg.norm(queries - (sphere[face] * w[:, :, None]).sum(axis=1), axis=1)
            is_nearer = (d < nearest) & (w.min(axis=1) >= 0)
            nearest[is_nearer], weights[is_nearer], corners[is_nearer] = d[is_nearer], w[is_nearer], face[is_nearer]
    return np.einsum("ij,ij...->i...", weights, values[corners])


def area_of(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    return sp.mean_vertex_areas([np.float64(points)], triangles)


class Source:
    """A surface with its sphere, its curvature, and labels."""

    def __init__(self, points: np.ndarray, triangles: np.ndarray, sphere: np.ndarray) -> None:
        self.points, self.triangles, self.sphere = np.float32(points), triangles, radius_100(np.float32(sphere))
        self.surface_file = write_surface("in.surf.gii", points, triangles, "Anatomical")
        self.sphere_file = write_surface("sphere.surf.gii", sphere, triangles, "Sphere")
        self.curvature = wb("surface-curvature", self.surface_file, "-mean", FOLDER / "out.shape.gii")
        self.metric_file = write_data("in.shape.gii", self.curvature)
        centres = np.random.default_rng(1).normal(size=(36, 3))
        self.labels = np.int32(1 + (sphere @ (centres / np.linalg.norm(centres, axis=1)[:, None]).T).argmax(axis=1))
        self.label_file = write_data("in.label.gii", self.labels)

    def compare(self, name: str, directions: np.ndarray, triangles: np.ndarray) -> None:
        to_file = write_surface("to.surf.gii", 100 * directions, triangles, "Sphere")
        directions = radius_100(nib.load(to_file).agg_data()[0])  # as it is stored
        spheres = (self.sphere_file, to_file)
        wb_points = wb("surface-resample", self.surface_file, *spheres, "BARYCENTRIC", FOLDER / "out.surf.gii")
        areas = ("-area-surfs", self.surface_file, write_surface("area.surf.gii", wb_points, triangles, "Anatomical"))
        wb_linear = wb("metric-resample", self.metric_file, *spheres, "BARYCENTRIC", FOLDER / "out.shape.gii")
        wb_again = [  # what is the same but for rounding: other names of the axes, other first corners of the faces
            wb("metric-resample", self.metric_file, *others, "BARYCENTRIC", FOLDER / "out.shape.gii")
            for axis, corner in np.ndindex(3, 3)
            for others in [[rolled(file, axis, corner) for file in spheres]]
        ]
        wb_kept = wb("metric-resample", self.metric_file, *spheres, "ADAP_BARY_AREA", FOLDER / "out.shape.gii", *areas)
        wb_labels = wb("label-resample", self.label_file, *spheres, "ADAP_BARY_AREA", FOLDER / "out.label.gii", *areas)
        locator = sp.Locator(self.triangles, self.sphere)
        linear = locator.linear_resampling(directions)
        kept = locator.area_preserving_resampling(
            area_of(self.points, self.triangles), sp.Locator(triangles, directions), area_of(wb_points, triangles)
        )
        both = np.column_stack([self.points, self.curvature])
        nearest = at_nearest_points(both, self.triangles, self.sphere, directions)

        def difference(a: np.ndarray, b: np.ndarray, of: np.ndarray) -> str:
            return f"{np.abs(a - b).max() / np.abs(of).max():.1e}"

        cells = [
            name,
            difference(linear.means(self.points), wb_points, self.points),
            difference(linear.means(self.curvature), wb_linear, self.curvature),
            difference(kept.means(self.curvature), wb_kept, self.curvature),
            f"{(kept.majorities(self.labels) != wb_labels).sum()} of {len(wb_labels)}",
            difference(nearest[:, :3], wb_points, self.points),
            difference(nearest[:, 3], wb_linear, self.curvature),
            difference(np.max(wb_again, axis=0), np.min(wb_again, axis=0), self.curvature),
        ]
        print(f"| {' | '.join(cells)} |", flush=True)


def main() -> None:
    points, triangles = nib.load(sys.argv[1]).agg_data()
    sphere = nib.load(sys.argv[2]).agg_data()[0]
    turn = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    levels = {level: sp.icosphere(level) for level in (4, 5, 6)}
    print("| from, to | points | curvature | curvature, area-preserving | labels that differ "
          "| points, nearest point | curvature, nearest point | curvature, wb_command and itself |\n|---|---|---|---|---|---|---|---|")
    own = Source(points, triangles, sphere)
    own.compare("fsaverage5, itself", np.float64(sphere) / 100, triangles)
    own.compare("fsaverage5, itself rotated", radius_100(sphere) / 100 @ turn.T, triangles)
    own.compare("fsaverage5, 2,562 vertices", levels[4][0] @ turn.T, levels[4][1])
    own.compare("fsaverage5, 40,962 vertices", levels[6][0] @ turn.T, levels[6][1])
    at_icosphere = sp.Locator(triangles, sphere).linear_resampling(levels[5][0]).means(points)
    nested = Source(at_icosphere, levels[5][1], 100 * levels[5][0])
    nested.compare("icosphere of level 5, level 4", *levels[4])
    nested.compare("icosphere of level 5, level 6", *levels[6])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main()
