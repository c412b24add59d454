// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

/// Coordinates one after the other: three numbers per point.
export type Coordinates = Float32Array | Float64Array;

/// A mesh, as a file has it.
export interface Mesh {
  points: Coordinates;
  triangles: Int32Array; // three numbers of points per face
}

/// What is known of a map besides its coordinates, by the names of the tool's report.
export interface Report {
  version?: string;
  input: string;
  vertices?: number;
  faces?: number;
  weights?: string;
  method?: string;
  method_used?: string;
  fallback_reason?: string;
  settings?: Record<string, unknown>;
  start_iterations?: number;
  iterations?: number;
  residual?: number;
  energy?: number;
  flipped_faces?: number;
  degree?: number;
  distortion?: Record<string, unknown>;
  seconds?: Record<string, number>;
  error: string | null; // null: certified
  error_code: string;
}

/// A mesh with its map: all that is shown.
export interface Model extends Mesh {
  sphere?: Coordinates; // unit vectors, one per point
  stretch?: Coordinates; // of faces: logarithm of the area stretch
  angle?: Coordinates; // of faces: angle distortion in radians
  segments?: Int32Array; // of faces
  report: Report;
}

/// For every vertex the mean of the values of its faces.
export function meanOverFaces(mesh: Mesh, values: Coordinates): Float32Array {
  const n = mesh.points.length / 3;
  const sum = new Float32Array(n);
  const count = new Uint32Array(n);
  mesh.triangles.forEach((v, corner) => {
    sum[v]! += values[(corner / 3) | 0]!;
    count[v]!++;
  });
  return sum.map((s, v) => (count[v] ? s / count[v]! : 0));
}

/// The value below which the share `share` of the values lies.
export function quantile(values: ArrayLike<number>, share: number): number {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
}

/// Areas of the faces.
export function faceAreas(mesh: Mesh): Float64Array {
  const { points, triangles } = mesh;
  const areas = new Float64Array(triangles.length / 3);
  for (let f = 0; f < areas.length; ++f) {
    const [a, b, c] = [0, 1, 2].map((i) => 3 * triangles[3 * f + i]!) as [number, number, number];
    const [ux, uy, uz] = [0, 1, 2].map((k) => points[b + k]! - points[a + k]!) as [number, number, number];
    const [vx, vy, vz] = [0, 1, 2].map((k) => points[c + k]! - points[a + k]!) as [number, number, number];
    areas[f] = Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
  }
  return areas;
}
