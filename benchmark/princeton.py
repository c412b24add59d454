#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All models of the Princeton segmentation benchmark by `segment --prepare`, against its human segmentations.

    benchmark/princeton.py DATA OUTPUT [TOOL [OPTION...]]

DATA has off/N.off and seg/Benchmark/N/N_*.seg, as the benchmark's authors distribute them (Chen, Golovinskiy, Funkhouser: "A benchmark
for 3D mesh segmentation", 2009). OUTPUT gets segments/ from the tool, which resumes a run that was stopped, rows.csv with a row per
model, and princeton.md, the table of the manual. Options are those of `segment`. The Rand index error is the share of the pairs of
faces that one segmentation keeps together and the other does not, as in `benchmark segmentation`: the mean over the humans of a model,
then over models. Humans are compared with each other.
"""

import collections
import csv
import itertools
import pathlib
import statistics
import subprocess
import sys

CLASSES = ("human cup glasses airplane ant chair octopus table teddy hand "
           "plier fish bird spring armadillo bust mech bearing vase fourleg").split()


def pairs(labels):
    """Ordered pairs of faces with the same label."""
    return sum(n * (n - 1) for n in collections.Counter(labels).values())


def rand_error(a, b):
    return (pairs(a) + pairs(b) - 2 * pairs(zip(a, b))) / (len(a) * (len(a) - 1))


def genus(mesh):
    """Of a closed, connected surface."""
    vertices, faces, _ = map(int, mesh.read_text().split("\n", 2)[1].split())
    return (2 - vertices + faces // 2) // 2


def row_of(mesh, labels, humans):
    row = {"model": mesh.stem, "class": CLASSES[(int(mesh.stem) - 1) // 20], "genus": genus(mesh), "humans": None,
           "segments": None, "error": None}
    if len(humans) > 1:
        row["humans"] = statistics.mean(rand_error(a, b) for a, b in itertools.combinations(humans, 2))
    if labels:
        row["segments"] = len(set(labels))
        row["error"] = statistics.mean(rand_error(labels, human) for human in humans)
    return row


def table(rows):
    def mean(rows, key):
        return statistics.mean(row[key] for row in rows if row[key] is not None)

    groups = [(name, [row for row in rows if row["class"] == name]) for name in CLASSES]
    groups += [("of genus 0", [row for row in rows if row["genus"] == 0]),
               ("with handles", [row for row in rows if row["genus"] > 0]), ("**all**", rows)]
    lines = ["| class | models | with labels | humans | `segment --prepare` |", "|---|---|---|---|---|"]
    for name, group in groups:
        if group:
            lines.append(f"| {name} | {len(group)} | {sum(row['error'] is not None for row in group)} | "
                         f"{mean(group, 'humans'):.3f} | {mean(group, 'error'):.3f} |")
    return "\n".join(lines).replace("0.", ".") + "\n"


def main(data, output, tool="build/src/spherical-parameterization", *options):
    data, output = pathlib.Path(data), pathlib.Path(output)
    subprocess.run([tool, "segment", data / "off", "-o", output / "segments", "--labels", "labels.txt", "--prepare", *options],
                   check=False, stdin=subprocess.DEVNULL)
    rows = []
    for mesh in sorted((data / "off").glob("*.off"), key=lambda file: int(file.stem)):
        labels = output / "segments" / f"{mesh.stem}.labels.txt"
        humans = [file.read_text().split() for file in sorted((data / "seg/Benchmark" / mesh.stem).glob("*.seg"))]
        rows.append(row_of(mesh, labels.read_text().split() if labels.exists() else None, humans))
    with open(output / "rows.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    (output / "princeton.md").write_text(table(rows))
    print(table(rows), end="")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
