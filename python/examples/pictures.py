# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape and sphere side by side, coloured by the stretch, with matplotlib.

    python3 pictures.py bunny.ply bunny.png
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import spherical_parameterization as sp


def draw(axes, points, triangles, values, limit):
    """Faces in colours, with a little shade; those that look away are left out."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    light = 0.35 + 0.65 * np.clip(normals @ np.array([0.3, -0.8, 0.5]), 0, 1)
    colours = plt.get_cmap("coolwarm")(0.5 + 0.5 * np.clip(values / limit, -1, 1))
    colours[:, :3] *= light[:, None]
    axes.add_collection3d(Poly3DCollection(corners, facecolors=colours))
    centre, size = points.mean(0), np.ptp(points, axis=0).max() / 2
    for name, middle in zip("xyz", centre):
        getattr(axes, f"set_{name}lim")(middle - 0.7 * size, middle + 0.7 * size)
    axes.set_box_aspect((1, 1, 1))
    axes.view_init(elev=15, azim=-90)
    axes.set_axis_off()


points, triangles = sp.read_mesh(sys.argv[1])
result = sp.parameterize(points, triangles)
stretch = sp.face_distortion(points, triangles, result.sphere)
limit = np.quantile(np.abs(stretch), 0.95)
figure = plt.figure(figsize=(9, 4.5))
for place, positions in enumerate((points, result.sphere), 1):
    draw(figure.add_subplot(1, 2, place, projection="3d"), positions, triangles, stretch, limit)
figure.suptitle(str(result), fontsize=7)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=150)
