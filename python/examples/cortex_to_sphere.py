# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps a cortical surface to a sphere, certified in the precision of the file.

    python3 cortex_to_sphere.py lh.white.surf.gii lh.sphere.surf.gii
    python3 cortex_to_sphere.py lh.white.surf.gii lh.sphere.surf.gii --overlay lh.curv.shape.gii --level 6

The sphere has the vertices and faces of the surface in their order, so that all overlays fit. With --overlay, one is
carried along to an icosphere as well: OVERLAY.ico6.shape.gii.
"""

import argparse
import os

import nibabel
import numpy as np

import spherical_parameterization as sp

parser = argparse.ArgumentParser()
parser.add_argument("surface")
parser.add_argument("sphere")
parser.add_argument("--overlay")
parser.add_argument("--level", type=int, default=6)
parser.add_argument("--area-exponent", type=float, default=1)
arguments = parser.parse_args()

points, triangles = sp.read_mesh(arguments.surface)
result = sp.parameterize(points, triangles, sp.Isometric(arguments.area_exponent))
print(result)

sp.write_mesh(arguments.sphere, result.sphere, triangles, sphere=True, like=arguments.surface)
stored, _ = sp.read_mesh(arguments.sphere)
print(f"as the file has it: {sp.certify(triangles, stored)}")
print(sp.distortion(points, triangles, stored))

if arguments.overlay:
    values = nibabel.load(arguments.overlay).agg_data()
    directions, _ = sp.icosphere(arguments.level)
    carried = sp.Locator(triangles, result.sphere).transfer(values, directions).astype(np.float32)
    name = f"{os.path.splitext(arguments.overlay)[0].removesuffix('.shape')}.ico{arguments.level}.shape.gii"
    nibabel.save(nibabel.GiftiImage(darrays=[nibabel.gifti.GiftiDataArray(carried, intent="NIFTI_INTENT_SHAPE")]), name)
    print(f"{name}: {len(carried)} values")
