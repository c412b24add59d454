#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How well `search` and `search --form` find the other shapes of a class, in a whole public collection.

    benchmark/retrieval.py DATA OUTPUT [TOOL]

DATA has folders CLASS/FILE, or off/N.off as the Princeton segmentation benchmark has them (see princeton.py). OUTPUT gets index.db,
which a second run brings up to date, rows.csv with a row per query and order, and retrieval.md, the tables of the manual. Every mesh is a
query among all others, in per cent: nearest neighbour, first and second tier, average precision, as in `benchmark retrieval`, which compares
descriptors. The halves are every other class, in their order.
"""

import csv
import json
import pathlib
import statistics
import subprocess
import sys

from princeton import CLASSES

MEASURES = "nearest neighbour", "first tier", "second tier", "average precision"


def class_of(file):
    return CLASSES[(int(file.stem) - 1) // 20] if file.parent.name == "off" else file.parent.name


def measures_of(hits, members):
    """Of a query: whether each of the ranked others is of its class."""
    ranks = [rank for rank, hit in enumerate(hits, 1) if hit]
    return (100 * hits[0], 100 * sum(hits[:members]) / members, 100 * sum(hits[:2 * members]) / members,
            100 * sum(n / rank for n, rank in enumerate(ranks, 1)) / members)


def rows_of(meshes, index, order, options, report, tool):
    for mesh in meshes:
        subprocess.run([tool, "search", mesh, "--index", index, "-k", str(len(meshes)), "--prepare", "--report", report, *options],
                       check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        found = [pathlib.Path(hit["name"]) for hit in json.loads(report.read_text())["found"]]
        hits = [class_of(file) == class_of(mesh) for file in found if file != mesh]
        if any(hits):
            yield {"mesh": mesh.name, "class": class_of(mesh), "order": order,
                   **dict(zip(MEASURES, measures_of(hits, sum(hits))))}


def tables(rows):
    classes = list(dict.fromkeys(row["class"] for row in rows))
    orders = list(dict.fromkeys(row["order"] for row in rows))

    def means(order, those, measures=MEASURES):
        group = [row for row in rows if row["order"] == order and row["class"] in those]
        return " | ".join(f"{statistics.mean(row[measure] for row in group):.1f}" for measure in measures)

    lines = ["| queries of | order | " + " | ".join(MEASURES) + " |", "|---|---|" + "---|" * len(MEASURES)]
    for name, those in (("1st, 3rd, ... class", classes[::2]), ("2nd, 4th, ... class", classes[1::2]), ("**all**", classes)):
        lines += [f"| {name} | {order} | {means(order, those)} |" for order in orders]
    lines += ["", "| first tier | " + " | ".join(orders) + " |", "|---|" + "---|" * len(orders)]
    lines += [f"| {name} | " + " | ".join(means(order, [name], MEASURES[1:2]) for order in orders) + " |" for name in classes]
    return "\n".join(lines) + "\n"


def main(data, output, tool="build/src/spherical-parameterization"):
    data, output = pathlib.Path(data), pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    folder, index = (data / "off" if (data / "off").is_dir() else data), output / "index.db"
    signed = subprocess.run([tool, "signature", folder, "-o", index, "--prepare"], check=False, stdin=subprocess.DEVNULL)
    if signed.returncode not in (0, 1) or not index.exists():  # 1: some meshes were refused
        sys.exit("no index could be made")
    meshes = sorted((file for file in folder.rglob("*") if file.is_file()),
                    key=lambda file: (int(file.stem),) if folder.name == "off" else (file.parent.name, file.name))
    rows = [row for order, options in (("`search`", ()), ("`search --form`", ("--form",)))
            for row in rows_of(meshes, index, order, options, output / "report.json", tool)]
    with open(output / "rows.csv", "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    (output / "retrieval.md").write_text(tables(rows))
    print(tables(rows), end="")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
