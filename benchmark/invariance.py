#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the isometric map moves when a mesh is renumbered, and when it is turned, scaled by 1.7 and moved.

    PYTHONPATH=build/python benchmark/invariance.py MESH...

Writes a table: energy, the largest angle in radians between positions in the map of the mesh as it is and of the changed mesh,
after the best rotation; 0 where the bits are the same.
"""

import pathlib
import sys

import numpy as np
import spherical_parameterization as sp


def largest_angle(a, b):
    """After the rotation of b that brings it nearest to a (W. Kabsch, 1976)."""
    u, _, v = np.linalg.svd(a.T @ b)
    rotation = u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
    chord = np.linalg.norm(a - b @ rotation.T, axis=1)
    return 2 * np.arcsin(np.minimum(1, chord / 2)).max()


def sphere_of(points, triangles):
    result = sp.parameterize(points, triangles, method=sp.Isometric())
    if not result:
        raise SystemExit(str(result))
    return result


def main(*files):
    random = np.random.default_rng(1)
    turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    print("| mesh | E | renumbered | similar |\n|---|---|---|---|")
    for file in files:
        points, triangles = sp.read_mesh(file)
        result = sphere_of(points, triangles)
        place = random.permutation(len(points))  # where each vertex goes
        renumbered = np.empty_like(points)
        renumbered[place] = points
        faces = place[triangles][random.permutation(len(triangles))]
        faces = np.take_along_axis(faces, (random.integers(3, size=(len(faces), 1)) + np.arange(3)) % 3, axis=1)
        maps = (
            sphere_of(renumbered, faces).sphere[place],
            sphere_of(1.7 * points @ turn.T + [3, -2, 5], triangles).sphere,
        )
        angles = [0 if (sphere == result.sphere).all() else largest_angle(result.sphere, sphere) for sphere in maps]
        print(f"| {pathlib.Path(file).stem} | {result.energy:.4f} | {angles[0]:.0e} | {angles[1]:.0e} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
