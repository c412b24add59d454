#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All models of the Princeton segmentation benchmark by `segment --prepare`, against its human segmentations.

    benchmark/princeton.py DATA OUTPUT [TOOL]

DATA has off/N.off and seg/Benchmark/N/N_*.seg, as the benchmark's authors distribute them (Chen, Golovinskiy, Funkhouser: "A benchmark
for 3D mesh segmentation", 2009); OUTPUT gets labels/N.txt, of which those that are there are not computed again, rows.csv, and
princeton.md. The Rand index error is the share of the pairs of faces that one segmentation keeps together and the other does not,
as in `benchmark segmentation`: the mean over the humans of a model, then over models. Humans are compared with each other.
"""

import collections
import csv
import pathlib
import statistics
import subprocess
import sys

CLASSES = ("human cup glasses airplane ant chair octopus table teddy hand "
           "plier fish bird spring armadillo bust mech bearing vase fourleg").split()


def rand_error(a, b):
    def squares(labels):
        return sum(n * n for n in collections.Counter(labels).values())

    n = len(a)
    return (squares(a) + squares(b) - 2 * squares(zip(a, b))) / (n * (n - 1))


def read_labels(file):
    return file.read_text().split()


def main(data, output, tool="build/src/spherical-parameterization"):
    data, output = pathlib.Path(data), pathlib.Path(output)
    (output / "labels").mkdir(parents=True, exist_ok=True)
    rows = []
    for mesh in sorted((data / "off").glob("*.off"), key=lambda file: int(file.stem)):
        labels = output / "labels" / f"{mesh.stem}.txt"
        message = ""
        if not labels.exists():
            run = subprocess.run([tool, "segment", mesh, "-o", output / "segments.ply", "--labels", labels, "--prepare",
                                  "--method", "automatic", "--policy", "sequential"],
                                 capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
            message = " ".join((run.stderr if run.returncode else run.stdout).split("\n"))
            (output / "labels" / f"{mesh.stem}.log").write_text(message)
        name = CLASSES[(int(mesh.stem) - 1) // 20]
        humans = [read_labels(file) for file in sorted((data / "seg/Benchmark" / mesh.stem).glob("*.seg"))]
        of_humans = [statistics.mean(rand_error(a, b) for b in humans if b is not a) for a in humans if len(humans) > 1]
        row = {"model": mesh.stem, "class": name, "humans": statistics.mean(of_humans) if of_humans else None,
               "segments": None, "error": None}
        if labels.exists():
            own = read_labels(labels)
            row["segments"] = len(set(own))
            row["error"] = statistics.mean(rand_error(own, human) for human in humans)
        rows.append(row)
        print(mesh.stem, name, row["humans"], row["error"], message, flush=True)
    with open(output / "rows.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)

    def mean(values):
        values = [value for value in values if value is not None]
        return statistics.mean(values) if values else float("nan")

    lines = ["| class | models | with labels | humans | ours |", "|---|---|---|---|---|"]
    for name in CLASSES + ["all models"]:
        of_class = [row for row in rows if name in (row["class"], "all models")]
        if of_class:
            lines.append(f"| {name} | {len(of_class)} | {sum(row['error'] is not None for row in of_class)} | "
                         f"{mean(row['humans'] for row in of_class):.3f} | {mean(row['error'] for row in of_class):.3f} |")
    (output / "princeton.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
