// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

import { Matrix3, Matrix4, Quaternion } from "three";

import type { Coordinates } from "./model";

/// The rotation that turns the sphere so that its points look where those of the mesh do, as seen from its middle: then
/// one camera shows the same side of both. B. K. P. Horn, "Closed-form solution of absolute orientation using unit
/// quaternions", 1987; the largest eigenvector by powers.
export function bestRotation(points: Coordinates, center: readonly number[], sphere: Coordinates): Matrix3 {
  const m = [0, 0, 0, 0, 0, 0, 0, 0, 0]; // sum of sphere_i mesh_j
  const step = 3 * Math.max(1, Math.floor(points.length / 3 / 20000));
  for (let v = 0; v < points.length; v += step)
    for (let i = 0; i < 3; ++i)
      for (let j = 0; j < 3; ++j) m[3 * i + j]! += sphere[v + i]! * (points[v + j]! - center[j]!);
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m as [number, number, number, number, number, number, number, number, number];
  const a = [
    [xx + yy + zz, yz - zy, zx - xz, xy - yx],
    [yz - zy, xx - yy - zz, xy + yx, zx + xz],
    [zx - xz, xy + yx, yy - xx - zz, yz + zy],
    [xy - yx, zx + xz, yz + zy, zz - xx - yy],
  ];
  const shift = 2 * Math.max(1e-300, Math.hypot(...a.flat())); // makes the largest eigenvalue the one of largest size
  let q = [0.9, 0.3, 0.2, 0.1];
  for (let i = 0; i < 500; ++i) {
    const next = a.map((row, r) => row.reduce((sum, x, c) => sum + x * q[c]!, shift * q[r]!));
    const length = Math.hypot(...next);
    q = next.map((x) => x / length);
  }
  const [w, x, y, z] = q as [number, number, number, number];
  return new Matrix3().setFromMatrix4(new Matrix4().makeRotationFromQuaternion(new Quaternion(x, y, z, w)));
}
