#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of `register` on the public sets of poses and bodies, beside the maps of other programs that lie there.

    benchmark/correspondences.py OUTPUT TOOL DATASET SET:STEP...

DATASET is the folder of that name of https://github.com/llorz/SGA18_orientation_BCICP_dataset: of the pairs of each SET (FAUST,
TOSCA_Isometric, TOSCA_nonIsometric) every STEP-th is registered with `--prepare`, and the maps in SET/vtx_5k/maps/*.zip are measured on
the same pairs. Errors are those of registration.py.

OUTPUT gets rows.csv (a line for each pair and program), and correspondences.svg, the cumulative curves. Needs numpy, scipy, matplotlib.
"""

import concurrent.futures
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import zipfile

import matplotlib
import numpy as np

from comparison import read_off
from registration import errors_of, graph_of, write_rows

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

PROGRAMS = {"BIM": "BIM (2011)", "PMF_hk": "PMF (2017)", "WKSini_direct": "functional map of WKS, not refined",
            "SEGini_direct_BCICP": "BCICP from segments (2018)", "WKSini_direct_BCICP": "BCICP from signatures (2018)"}


def read_map(archive, pair):
    """The vertex of B of each vertex of A, -1 if there is none; or None if the pair is not there."""
    with zipfile.ZipFile(archive) as files:
        names = {pathlib.Path(name).name: name for name in files.namelist()}
        file = names.get("_".join(pair) + ".map")
        if file is None:
            return None
        vertex = np.loadtxt(io.StringIO(files.read(file).decode()))
    first = 0 if archive.stem == "BIM" else 1
    return np.where(np.isfinite(vertex), vertex - first, -1).astype(int)


def measure(tool, folder, pair):
    """By the name of the program: the errors. Nothing for a pair that is refused, with a line that says why."""
    meshes = [folder / f"{name}.off" for name in pair]
    of_a, of_b = (np.loadtxt(folder / "corres" / f"{name}.vts", dtype=int) - 1 for name in pair)
    number = min(len(of_a), len(of_b))
    of_a, of_b = of_a[:number], of_b[:number]
    points, triangles = read_off(meshes[1])
    graph = graph_of(points, triangles)
    errors = {}
    with tempfile.TemporaryDirectory() as scratch:
        carried = pathlib.Path(scratch) / "carried.off"
        run = subprocess.run([tool, "-q", "register", *meshes, "--prepare", "-o", carried], capture_output=True, text=True)
        if run.returncode == 0:
            errors["register"] = errors_of(read_off(carried)[0][of_a], of_b, points, triangles, graph)
        else:
            print(*pair, run.stderr.strip(), flush=True)
    for file, program in PROGRAMS.items():
        archive = folder / "maps" / f"{file}.zip"
        vertex = read_map(archive, pair) if archive.exists() else None
        if vertex is not None:
            known = vertex[of_a] >= 0
            errors[program] = errors_of(points[vertex[of_a[known]]], of_b[known], points, triangles, graph)
    return errors


def main(output, tool, dataset, *sets):
    output = pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    rows = []
    figure, axes = pyplot.subplots(1, len(sets), figsize=(5 * len(sets), 5), squeeze=False)
    for axis, (name, step) in zip(axes[0], (s.split(":") for s in sets)):
        folder = pathlib.Path(dataset) / name / "vtx_5k"
        pairs = [line.split() for line in (folder.parent / "test_pairs.txt").read_text().splitlines() if line.strip()][:: int(step)]
        curves = {}
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for pair, errors in zip(pairs, pool.map(lambda p, f=folder: measure(tool, f, p), pairs), strict=True):
                for program, error in errors.items():
                    curves.setdefault(program, []).append(error)
                    rows.append({"set": name, "a": pair[0], "b": pair[1], "program": program, "mean": error.mean(),
                                 "90 %": np.quantile(error, 0.9), "below 0.1": (error < 0.1).mean()})
        for (program, of_pairs), style in zip(curves.items(), ("-", "--", ":", "-.", (0, (1, 4)))):
            error = np.concatenate(of_pairs)
            mean = np.mean([e.mean() for e in of_pairs])
            print(f"{name}: {program}: {len(of_pairs)} of {len(pairs)} pairs, mean {mean:.4f}, {(error < 0.1).mean():.3f} below 0.1")
            percent = np.linspace(0, 100, 401)
            axis.plot(np.percentile(error, percent), percent, linestyle=style, color="black", label=f"{program}: {mean:.3f}")
        axis.set(title=f"{name}, {len(pairs)} pairs", xlabel="geodesic error / square root of the area", ylabel="% of the vertices",
                 xlim=(0, 0.25), ylim=(0, 100))
        axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2))  # below: curves are everywhere
        axis.grid(alpha=0.3)
    write_rows(output / "rows.csv", rows)
    figure.tight_layout()
    figure.savefig(output / "correspondences.svg", metadata={"Date": None})


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
