#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of `register` at feature points that people marked: shapes of one class, beside blended intrinsic maps.

    benchmark/feature_points.py OUTPUT.csv TOOL BENCHMARK [STEP [FIRST]]

BENCHMARK is the unpacked correspondence benchmark of V. Kim, Y. Lipman, T. Funkhouser, "Blended intrinsic maps", 2011, whose
Results have the errors of that method. Of its pairs of SHREC 2007, every STEP-th is registered, from the one numbered FIRST on. The
error is the mean distance on B, along edges and the diagonals of pairs of faces, over the square root of its area. "mirrored" is the
smaller one of this and the mean with left and right exchanged. Needs numpy, scipy, matplotlib.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np
import scipy.sparse.csgraph

from comparison import read_off
from registration import area_of, graph_of, write_rows

SHAPES_PER_CLASS = 20


def class_of(shape):
    return (int(shape) - 1) // SHAPES_PER_CLASS + 1


def mirrored(file, number):
    """The feature points with left and right exchanged."""
    result = np.arange(number)
    for line in file.read_text().splitlines() if file.exists() else []:
        if len(line.split()) == 2:
            i, j = map(int, line.split())
            result[[i, j]] = j, i
    return result


def measure(tool, data, a, b):
    """What the tool says of its answer, and the errors at the feature points, as they are and mirrored; or None and why the shapes were refused."""
    with tempfile.TemporaryDirectory() as folder:
        places, report = pathlib.Path(folder) / "places.csv", pathlib.Path(folder) / "report.json"
        meshes = [data / "Meshes" / f"{shape}.off" for shape in (a, b)]
        run = subprocess.run([tool, "-q", "register", *meshes, "--prepare", "--correspondence", places, "--report", report], capture_output=True,
                             text=True)
        if run.returncode != 0:
            return None, run.stderr.strip()
        trust = json.loads(report.read_text())["trust"]
        table = np.loadtxt(places, delimiter=",", skiprows=1)
    of_a, of_b = (np.loadtxt(data / "Corrs" / f"{shape}.vts")[:, 0].astype(int) for shape in (a, b))
    points, triangles = read_off(meshes[1])
    corner = triangles[table[of_a, 1].astype(int)]
    carried = np.einsum("vk,vkx->vx", table[of_a, 2:], points[corner])
    way = scipy.sparse.csgraph.dijkstra(graph_of(points, triangles), directed=False, indices=of_b)
    near = np.linalg.norm(points[corner] - carried[:, None], axis=2)

    def error(order):
        return np.min(near + way[order[:, None], corner], axis=1).mean() / np.sqrt(area_of(points, triangles))

    return trust, error(np.arange(len(of_b))), error(mirrored(data / "Corrs" / f"{class_of(b)}.sym.info", len(of_b)))


def main(output, tool, benchmark, step=1, first=0):
    benchmark = pathlib.Path(benchmark)
    published = {}
    for file in (benchmark / "Results" / "Results_Corr_SHREC").glob("BenchResult_BlendedMap_*_to_*.txt"):
        pair = tuple(map(int, re.findall(r"\d+", file.name)))
        published[pair] = [float(x) for x in re.findall(r"(?:Stats|StatsWithFlip):\s+Average\s*\[(.*?)\]", file.read_text())]
    pairs = sorted(published)[int(first)::int(step)]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        data = benchmark / "Data" / "watertight_shrec07"
        for pair, (trust, *errors) in zip(pairs, pool.map(lambda p: measure(tool, data, *p), pairs), strict=True):
            if trust is None:
                print(*pair, *errors, flush=True)
                continue
            direct, other = errors
            rows.append({"a": pair[0], "b": pair[1], "trust": trust, "error": direct, "mirrored": min(direct, other),
                         "BIM": published[pair][0], "BIM mirrored": published[pair][1]})
            print(rows[-1], flush=True)
    write_rows(output, rows)
    columns = list(rows[0])[3:]
    table = np.array([[row[c] for c in columns] for row in rows])
    number = np.array([class_of(row["a"]) for row in rows])
    for name, some in [(f"class {c}", number == c) for c in sorted(set(number))] + [("all", number > 0)]:
        print(name, some.sum(), *(f"{c} {table[some, k].mean():.3f} ({(table[some, k] < 0.1).sum()} below 0.1)"
                                  for k, c in enumerate(columns)), sep="  ")
    for trust in sorted({row["trust"] for row in rows}):
        errors = [row["error"] for row in rows if row["trust"] == trust]
        print(f"{trust}: {len(errors)}, {sum(e < 0.1 for e in errors)} below 0.1, {sum(e > 0.2 for e in errors)} above 0.2")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
