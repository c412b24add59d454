#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All models of the Princeton segmentation benchmark by `segment --prepare`, against its human segmentations; and labels
that were carried from one model of a class to the next one by `segment --like`.

    benchmark/princeton.py DATA OUTPUT [TOOL [OPTION...]]

DATA has off/N.off and seg/Benchmark/N/N_*.seg, as the benchmark's authors distribute them (Chen, Golovinskiy, Funkhouser: "A benchmark
for 3D mesh segmentation", 2009). OUTPUT gets segments/ from the tool, which resumes a run that was stopped, rows.csv with a row per
model, and princeton.md, the tables of the manual. Options are those of `segment`. The Rand index error is the share of the pairs of
faces that one segmentation keeps together and the other does not, as in `benchmark segmentation`: the mean over the humans of a model,
then over models. Humans are compared with each other. The halves are every other class, those with models in DATA counted.

Labels are carried from every model, its first human segmentation, to the next model of its class, and from the last one to the
first one. The table compares them with the human segmentations of the model that got them, by what the tool says of the
correspondence.
"""

import collections
import csv
import itertools
import json
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


def labels_in(file):
    return file.read_text().split() if file.exists() else None


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
    groups = [(name, group) for name, group in groups if group]
    for name, half in (("1st, 3rd, ... class", groups[::2]), ("2nd, 4th, ... class", groups[1::2])):
        groups.append((name, [row for _, group in half for row in group]))
    groups += [("of genus 0", [row for row in rows if row["genus"] == 0]),
               ("with handles", [row for row in rows if row["genus"] > 0]), ("**all**", rows)]
    lines = ["| class | models | with labels | humans | `segment --prepare` |", "|---|---|---|---|---|"]
    for name, group in groups:
        if group:
            lines.append(f"| {name} | {len(group)} | {sum(row['error'] is not None for row in group)} | "
                         f"{mean(group, 'humans'):.3f} | {mean(group, 'error'):.3f} |")
    return "\n".join(lines).replace("0.", ".") + "\n"


def segment(tool, *arguments):
    status = subprocess.run([tool, "segment", *arguments], check=False, stdin=subprocess.DEVNULL).returncode
    if status not in (0, 1):  # 1: some were refused
        sys.exit(f"princeton.py: {tool} has ended with status {status}")


def carry(tool, options, meshes, humans, output):
    """Rows of the models to which labels were carried."""
    output.mkdir(exist_ok=True)
    for _, group in itertools.groupby(meshes, lambda mesh: (int(mesh.stem) - 1) // 20):
        models = [mesh for mesh in group if humans[mesh.stem]]
        for mesh, other in zip(models, models[1:] + models[:1]):
            if mesh == other:
                continue
            files = {name: output / f"{mesh.stem}.{name}" for name in ("ply", "labels.txt", "json", "like.txt")}
            files["labels.txt"].unlink(missing_ok=True)
            files["like.txt"].write_text("\n".join(humans[other.stem][0]))
            segment(tool, mesh, "-o", files["ply"], "--labels", files["labels.txt"], "--report", files["json"],
                    "--like", other, "--like-labels", files["like.txt"], "--prepare", *options)
            labels = labels_in(files["labels.txt"])
            if labels:
                row = row_of(mesh, labels, humans[mesh.stem])
                yield {**row, "like": other.stem, "trust": json.loads(files["json"].read_text())["like"]["trust"]}


def table_of_carried(carried, rows):
    own = {row["model"]: row["error"] for row in rows}
    lines = ["| correspondence | models | humans | own segments | carried labels |", "|---|---|---|---|---|"]
    for name in ("sure", "unsure", "unlike", "all"):
        group = [row for row in carried if name in ("all", row["trust"])]
        if group:
            means = [statistics.mean(row["humans"] for row in group), statistics.mean(own[row["model"]] for row in group),
                     statistics.mean(row["error"] for row in group)]
            lines.append(f"| {name} | {len(group)} | " + " | ".join(f"{mean:.3f}" for mean in means) + " |")
    return "\n".join(lines).replace("0.", ".") + "\n"


def write_rows(file, rows):
    with open(file, "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


def main(data, output, tool="build/src/spherical-parameterization", *options):
    data, output = pathlib.Path(data), pathlib.Path(output)
    segment(tool, data / "off", "-o", output / "segments", "--labels", "labels.txt", "--prepare", *options)
    meshes = sorted((data / "off").glob("*.off"), key=lambda file: int(file.stem))
    humans = {mesh.stem: [labels_in(file) for file in sorted((data / "seg/Benchmark" / mesh.stem).glob("*.seg"))]
              for mesh in meshes}
    rows = [row_of(mesh, labels_in(output / "segments" / f"{mesh.stem}.labels.txt"), humans[mesh.stem]) for mesh in meshes]
    carried = list(carry(tool, options, meshes, humans, output / "carried"))
    write_rows(output / "rows.csv", rows)
    tables = table(rows)
    if carried:
        write_rows(output / "carried.csv", carried)
        tables += "\n" + table_of_carried(carried, rows)
    (output / "princeton.md").write_text(tables)
    print(tables, end="")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
