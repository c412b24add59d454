# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces as VTK and PyVista keep them, [3, a, b, c, 3, d, e, f, ...], and as this package does.

With PyVista: `points, faces = mesh.points, mesh.faces`, and `mesh.point_data["sphere"] = sphere` at the end.
"""

import numpy as np

import spherical_parameterization as sp

points, triangles = sp.icosphere(4)
points = points * [1, 1, 3]
faces = np.column_stack([np.full(len(triangles), 3), triangles]).ravel()  # what a vtkPolyData has

triangles = faces.reshape(-1, 4)[:, 1:]
result = sp.parameterize(points, triangles)
print(result)
sphere_faces = np.insert(triangles, 0, 3, axis=1).ravel()
assert (sphere_faces == faces).all()
