# SPDX-License-Identifier: GPL-3.0-or-later
"""From any format of meshio to any other: the sphere as data of the points, stretch and segments as data of the cells.

    python3 any_format.py bunny.ply bunny.vtu        # for ParaView
"""

import sys

import meshio

import spherical_parameterization as sp

points, triangles = sp.read_mesh(sys.argv[1])
result = sp.parameterize(points, triangles, weights="conformal")
print(result)
cell_data = {
    "log_area_stretch": [sp.face_distortion(points, triangles, result.sphere)],
    "segment": [sp.segment(points, triangles, result.sphere)],
}
meshio.Mesh(points, [("triangle", triangles)], point_data={"sphere": result.sphere}, cell_data=cell_data).write(sys.argv[2])
