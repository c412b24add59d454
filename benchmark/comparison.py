#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of doc/comparison.md: our maps of some meshes, and beside them the spheres of other programs.

    benchmark/comparison.py OUTPUT MESH.off... [--others FOLDER] [--repetitions N] [--tool TOOL]

The tool maps every mesh in five ways, on one core, in turn, N times. FOLDER has the spheres of other programs, NAME.PROGRAM.off
for NAME.off with the same vertices and faces in the same order, and, where they are known, their seconds in
NAME.PROGRAM.seconds. All spheres are judged by `certify --report`, and valid ones measured once more here, by other formulas:
where both do not agree the script stops. OUTPUT gets the spheres, rows.csv, and tables.md. Other formats are converted by
`spherical-parameterization prepare IN --steps merge -o MESH.off`.

Seconds are user and system time of the whole process, the least of N runs: busy machines lengthen them by little. A mesh costs
some seconds. Needs NumPy.
"""

import argparse
import csv
import json
import pathlib
import resource
import subprocess
import sys

import numpy as np

OURS = {
    "conformal": ["--method", "balanced", "--weights", "conformal"],
    "clamped": ["--method", "balanced", "--weights", "clamped"],
    "isometric": ["--method", "isometric"],
    "areas": ["--method", "isometric", "--area-exponent", "30"],
    "automatic": ["--method", "automatic"],
}
TABLES = {  # titles of the tables, and what stands in them
    "qc": "Ratio of the principal stretches, mean over the faces (1 is conformal)",
    "symmetric_dirichlet": "Symmetric Dirichlet energy, mean over the area (4 is isometric)",
    "log_area_deviation": "Standard deviation of the logarithm of the area stretch, over the area (0 preserves areas)",
    "seconds": "CPU seconds",
}


def read_off(file):
    numbers = np.array(file.read_text().split()[1:], dtype=float)  # behind OFF: counts, points, faces
    vertices, faces = int(numbers[0]), int(numbers[1])
    points, triangles = numbers[3:3 + 3 * vertices].reshape(-1, 3), numbers[3 + 3 * vertices:].reshape(faces, 4)
    return points, triangles[:, 1:].astype(int)


def measure(mesh, sphere):
    """Distortion from Gram matrices of the edges of flat triangles: of all faces, and weighted by their areas in the mesh."""
    def gram(points, triangles):
        p, q = (points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
        products = [(a * b).sum(1) for a, b in ((p, p), (p, q), (q, q))]
        return *products, np.linalg.norm(np.cross(p, q), axis=1) / 2

    (points, triangles), (positions, _) = read_off(mesh), read_off(sphere)
    positions = positions / np.linalg.norm(positions, axis=1)[:, None]
    e, f, g, area = gram(points, triangles)
    E, F, G, image = gram(positions, triangles)
    with np.errstate(all="ignore"):
        squares = (e * G - 2 * f * F + g * E) / (4 * area * area)  # sum of the squared stretches
        half = squares * area / image / 2
        qc = half + np.sqrt(np.maximum(half * half - 1, 0))
        scale = area.sum() / image.sum()
        dirichlet = squares * scale + squares * (area / image) ** 2 / scale
        return {"qc": qc.mean(), "qc_of_area": (qc * area).sum() / area.sum(),
                "symmetric_dirichlet": (dirichlet * area).sum() / area.sum()}


def cpu_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(report, *command):
    """The report, which it writes for refused meshes, too, and CPU seconds."""
    report.unlink(missing_ok=True)
    before = cpu_seconds()
    done = subprocess.run([*command, "--report", report], capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    seconds = cpu_seconds() - before
    if not report.exists():
        sys.exit(f"comparison.py: {' '.join(map(str, command))}: no report, exit status {done.returncode}\n{done.stderr}")
    return json.loads(report.read_text()), seconds


def judge(tool, mesh, sphere, report_file):
    report, _ = run(report_file, tool, "certify", mesh, sphere)
    row = {"flipped_faces": report["flipped_faces"], "degree": report["degree"], "error": report["error_code"]}
    if not report["distortion"]:
        return row
    distortion = report["distortion"]
    row["log_area_deviation"] = distortion["log_area_stretch"]["standard_deviation"]
    row["qc_of_area"] = distortion["dilatation"]["mean"]
    row["symmetric_dirichlet"] = distortion["symmetric_dirichlet"]["mean"]
    again = measure(mesh, sphere)
    row["qc"] = again["qc"]
    for key in ("qc_of_area", "symmetric_dirichlet"):
        # Where faces are smaller than the rounding of their corners neither has correct digits.
        if not row["flipped_faces"] and row[key] < 1e4 and not np.isclose(row[key], again[key], rtol=1e-4):
            sys.exit(f"comparison.py: {sphere}: {key} is {row[key]} in the report, and {again[key]} here")
    return row


def cell(row, key):
    if not row:
        return "-"
    value, flips = row.get(key), row["flipped_faces"]
    if flips and key not in ("qc", "seconds"):
        return f"({flips})"
    if value is None:
        return "-" if key == "seconds" or row["error"] == "OK" else row["error"]
    if key == "seconds":
        return f"{value:.2f}" if value < 10 else f"{value:.0f}"
    text = f"{value:.3g}" if value >= 100 or key == "log_area_deviation" else f"{value:.3f}"
    return f"{text} ({flips})" if flips else text


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path, nargs="+")
    parser.add_argument("--others", type=pathlib.Path)
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--tool", default="build/src/spherical-parameterization")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows = {}
    for mesh in arguments.meshes:
        seconds, reports = {name: [] for name in OURS}, {}
        for _ in range(arguments.repetitions):
            for name, options in OURS.items():
                sphere = arguments.output / f"{mesh.stem}.{name}.off"
                reports[name], time = run(sphere.with_suffix(".json"), arguments.tool, "map", mesh, "-o", sphere,
                                          "--policy", "sequential", *options)
                seconds[name].append(time)
        for name, report in reports.items():
            row = {"mesh": mesh.stem, "vertices": report["vertices"], "program": name, "method_used": report["method_used"],
                   "seconds": min(seconds[name]), "error": report["error_code"], "flipped_faces": 0}
            if report["error_code"] == "OK":
                row.update(judge(arguments.tool, mesh, arguments.output / f"{mesh.stem}.{name}.off",
                                 arguments.output / f"{mesh.stem}.{name}.certify.json"))
            rows[mesh.stem, name] = row
        for sphere in sorted(arguments.others.glob(f"{mesh.stem}.*.off")) if arguments.others else []:
            name = sphere.suffixes[-2][1:]
            file = sphere.with_suffix(".seconds")
            rows[mesh.stem, name] = {"mesh": mesh.stem, "vertices": report["vertices"], "program": name,
                                     "seconds": float(file.read_text()) if file.exists() else None,
                                     **judge(arguments.tool, mesh, sphere, arguments.output / f"{mesh.stem}.{name}.json")}
        print(mesh.stem, flush=True)
    keys = list(dict.fromkeys(key for row in rows.values() for key in row))
    with open(arguments.output / "rows.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, keys)
        writer.writeheader()
        writer.writerows(rows.values())
    programs = list(dict.fromkeys(name for _, name in rows))
    lines = []
    for key, title in TABLES.items():
        lines += [f"### {title}", "", f"| mesh | {' | '.join(programs)} |", "|---" * (len(programs) + 1) + "|"]
        lines += [f"| {mesh.stem} | " + " | ".join(cell(rows.get((mesh.stem, name)), key) for name in programs) + " |"
                  for mesh in arguments.meshes] + [""]
    (arguments.output / "tables.md").write_text("\n".join(lines))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
