#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of `register` where the true correspondence is known: by rotation, by a Moebius transformation, by deformation.

    benchmark/registration.py OUTPUT TOOL NAME:A:B:LEVEL...         # B has the vertices of A in their order
    benchmark/registration.py OUTPUT TOOL NAME:A:B:TRUTH_A:TRUTH_B... # files of corresponding vertices, from 1 on, a line each

NAME is the curve to which a pair belongs. With LEVEL, what is registered is B sampled at an icosphere of this level, a mesh that
has nothing to do with that of A. Of 1,000 vertices of A, the error is the distance on B from where a vertex was carried to where it
belongs: to the vertex of B that is nearest to the first, and on along edges and the diagonals of pairs of faces. That is not less than
the geodesic distance. It is given over the square root of the area of B, as in V. Kim, Y. Lipman, T. Funkhouser, "Blended intrinsic
maps", 2011.

OUTPUT gets rows.csv (a line for each pair and motion), and registration.svg, the cumulative curves. Needs numpy, scipy, matplotlib.
"""

import concurrent.futures
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import matplotlib
import numpy as np
import scipy.sparse
import scipy.sparse.csgraph
import scipy.spatial

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

SAMPLES = 1000
MOTIONS = ("rotation", "moebius", "deformation")


def read_ply(file):
    """Points and triangles of a binary PLY file of the tool."""
    data = file.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode().split("\n")
    count = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element")}
    number = "<f4" if any(line.startswith("property float x") for line in header) else "<f8"
    points = np.frombuffer(data, number, 3 * count["vertex"], end).reshape(-1, 3)
    faces = np.frombuffer(data, np.dtype([("n", "u1"), ("v", "<i4", 3)]), count["face"], end + points.nbytes)
    return points.astype(float), faces["v"]


def graph_of(points, triangles):
    """The edges and the unfolded diagonals of pairs of faces, with their lengths."""
    edge = {}
    for a, b, c in triangles:
        for i, j, k in ((a, b, c), (b, c, a), (c, a, b)):
            edge.setdefault((min(i, j), max(i, j)), []).append(k)
    ends = np.array(list(edge))
    apex = np.array([(opposite * 2)[:2] for opposite in edge.values()])  # of a border one, twice
    p, q = points[ends[:, 0]], points[ends[:, 1]]
    length = np.linalg.norm(q - p, axis=1)
    along = (q - p) / length[:, None]
    x, y = [], []
    for side in (0, 1):
        r = points[apex[:, side]] - p
        x.append((r * along).sum(1))
        y.append(np.linalg.norm(r - x[-1][:, None] * along, axis=1))
    crossing = x[0] + (x[1] - x[0]) * y[0] / np.maximum(y[0] + y[1], 1e-300)
    is_inside = (crossing >= 0) & (crossing <= length)
    diagonal = np.hypot(x[1] - x[0], y[0] + y[1])
    i = np.concatenate([ends[:, 0], apex[is_inside, 0]])
    j = np.concatenate([ends[:, 1], apex[is_inside, 1]])
    weight = np.concatenate([length, diagonal[is_inside]])
    return scipy.sparse.csr_matrix((weight, (i, j)), (len(points), len(points)))


def area_of(points, triangles):
    sides = points[triangles]
    return np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1).sum() / 2


def errors_of(carried, vertices, points, triangles, graph):
    """Of SAMPLES vertices of A or a few more, that belong to these vertices of B, over the square root of the area of B."""
    sample = np.arange(0, len(vertices), max(1, len(vertices) // SAMPLES))
    near, vertex = scipy.spatial.cKDTree(points).query(carried[sample])
    way = scipy.sparse.csgraph.dijkstra(graph, directed=False, indices=vertex)
    return (near + way[np.arange(len(sample)), vertices[sample]]) / np.sqrt(area_of(points, triangles))


def write_rows(file, rows):
    """As CSV, with the names of the columns."""
    with open(file, "w", newline="") as out:
        writer = csv.DictWriter(out, rows[0])
        writer.writeheader()
        writer.writerows(rows)


def measure(tool, pair, folder):
    """By the motion: the errors, and a row of the table. Files go to the folder."""
    folder = pathlib.Path(folder)

    def run(*arguments):
        subprocess.run([tool, "-q", *map(str, arguments)], check=True)

    name, a, b, *truth = pair.split(":")
    run("prepare", b, "-o", folder / "b.ply")  # the same mesh as PLY
    points, triangles = read_ply(folder / "b.ply")
    of_a = of_b = np.arange(len(points))
    registered = b
    if len(truth) == 1:
        registered = folder / "b_sampled.ply"
        run("resample", b, "--level", truth[0], "-o", registered)
    else:
        of_a, of_b = (np.loadtxt(file, dtype=int) - 1 for file in truth)
    for mesh, sphere in ((a, "a_sphere.ply"), (registered, "b_sphere.ply")):
        run("map", mesh, "--method", "isometric", "-o", folder / sphere)
    graph = graph_of(points, triangles)
    errors, rows = {}, []
    for motion in MOTIONS:
        run("register", a, registered, "--sphere", folder / "a_sphere.ply", folder / "b_sphere.ply", "--motion", motion,
            "-o", folder / "carried.ply", "--report", folder / "report.json")
        report = json.loads((folder / "report.json").read_text())
        error = errors_of(read_ply(folder / "carried.ply")[0][of_a], of_b, points, triangles, graph)
        errors[motion] = error
        rows.append({"curve": name, "a": pathlib.Path(a).name, "b": pathlib.Path(b).name, "motion": motion,
                     "mean": error.mean(), "median": np.median(error), "90 %": np.quantile(error, 0.9), "largest": error.max(),
                     "below 0.05": (error < 0.05).mean(), "flipped faces": report["flipped_faces"], "start": report["start"],
                     "mismatch": report["mismatch"], "stretching": report["stretching"], "distortion": report["distortion"],
                     "seconds": report["seconds"]["register"]})
        print({key: round(x, 4) if isinstance(x, float) else x for key, x in rows[-1].items()}, flush=True)
    return name, errors, rows


def main(output, tool, *pairs):
    output = pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    rows, curves = [], {}

    def work(pair):
        with tempfile.TemporaryDirectory() as folder:
            return measure(tool, pair, folder)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, errors, of_pair in pool.map(work, pairs):
            rows += of_pair
            for motion in MOTIONS:
                curves.setdefault((name, motion), []).append(errors[motion])
    write_rows(output / "rows.csv", rows)

    names = list(dict.fromkeys(name for name, _ in curves))
    figure, axes = pyplot.subplots(1, len(names), figsize=(5 * len(names), 3.6), squeeze=False)
    for axis, name in zip(axes[0], names):
        for motion, style in zip(MOTIONS, ("--", ":", "-")):
            error = np.sort(np.concatenate(curves[name, motion]))
            axis.plot(error, 100 * np.arange(1, len(error) + 1) / len(error), style, color="black", label=motion)
        axis.set(title=name, xlabel="geodesic error / square root of the area", ylabel="% of the vertices",
                 xlim=(0, 0.04 if error.max() < 0.1 else 0.2), ylim=(0, 100))
        axis.legend(loc="lower right")
        axis.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(output / "registration.svg", metadata={"Date": None})


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
