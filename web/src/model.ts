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
  fallback_reason?: string | null;
  policy?: string;
  device?: string;
  settings?: Record<string, unknown>;
  start_iterations?: number;
  iterations?: number;
  residual?: number;
  energy?: number;
  flipped_faces?: number;
  moved_vertices?: number;
  degree?: number;
  distortion?: Record<string, unknown>;
  seconds?: Record<string, number>;
  error: string | null; // null: certified
  error_code: string;
}

/// How a mesh changes into another one.
export interface Way {
  shapes: Coordinates[];
  names: [string, string]; // of the files at its ends
  text: string; // on how good it is
  isGood: boolean;
}

/// A mesh with its map, or on its way to another shape: all that is shown.
export interface Model extends Mesh {
  sphere?: Coordinates; // unit vectors, one per point
  way?: Way;
  stretch?: Coordinates; // of faces: logarithm of the area stretch
  angle?: Coordinates; // of faces: angle distortion in radians
  segments?: Int32Array; // of faces
  unsegmented?: string; // why it has none
  report: Report;
}

/// For every vertex the mean of the values of its faces.
export function meanOverFaces(mesh: Mesh, values: Coordinates): Float32Array {
  const n = mesh.points.length / 3;
  const sum = new Float32Array(n);
  const count = new Uint32Array(n);
  for (let corner = 0; corner < mesh.triangles.length; ++corner) {
    const v = mesh.triangles[corner]!;
    sum[v]! += values[(corner / 3) | 0]!;
    count[v]!++;
  }
  for (let v = 0; v < n; ++v) sum[v]! /= Math.max(1, count[v]!);
  return sum;
}

/// The values below which these shares of the values lie.
export function quantiles(values: ArrayLike<number>, shares: number[]): number[] {
  const sorted = Float64Array.from(values).sort();
  return shares.map((share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0);
}

/// Calls `visit` for every face with the cross product of two of its edges (twice its area, outwards), and with the
/// places of its corners in the coordinates. In plain numbers: meshes are large, and the page must not wait.
export function forEachFace(
  { points, triangles }: Mesh,
  visit: (x: number, y: number, z: number, a: number, b: number, c: number, face: number) => void,
): void {
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!;
    const b = 3 * triangles[t + 1]!;
    const c = 3 * triangles[t + 2]!;
    const ux = points[b]! - points[a]!;
    const uy = points[b + 1]! - points[a + 1]!;
    const uz = points[b + 2]! - points[a + 2]!;
    const vx = points[c]! - points[a]!;
    const vy = points[c + 1]! - points[a + 1]!;
    const vz = points[c + 2]! - points[a + 2]!;
    visit(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, a, b, c, t / 3);
  }
}

/// Areas of the faces.
export function faceAreas(mesh: Mesh): Float64Array {
  const areas = new Float64Array(mesh.triangles.length / 3);
  forEachFace(mesh, (x, y, z, _a, _b, _c, face) => (areas[face] = Math.sqrt(x * x + y * y + z * z) / 2));
  return areas;
}

/// The model at a size at which squares of coordinates neither overflow nor vanish, also as floats: the same, as a rule.
export function drawable(model: Model): Model {
  let largest = 0;
  for (const points of model.way?.shapes ?? [model.points]) for (const x of points) largest = Math.max(largest, Math.abs(x));
  if (!(largest > 1e15 || (largest > 0 && largest < 1e-15))) return model;
  const unit = 2 ** Math.floor(Math.log2(largest));
  const scaled = (points: Coordinates) => Float64Array.from(points, (x) => x / unit);
  return { ...model, points: scaled(model.points), ...(model.way && { way: { ...model.way, shapes: model.way.shapes.map(scaled) } }) };
}

/// Normals of the vertices, weighted by the areas of the faces.
export function normalsOf(mesh: Mesh): Float32Array {
  const normals = new Float32Array(mesh.points.length);
  const add = (v: number, x: number, y: number, z: number) => {
    normals[v]! += x;
    normals[v + 1]! += y;
    normals[v + 2]! += z;
  };
  forEachFace(mesh, (x, y, z, a, b, c) => {
    add(a, x, y, z);
    add(b, x, y, z);
    add(c, x, y, z);
  });
  for (let v = 0; v < normals.length; v += 3) {
    const [x, y, z] = [normals[v]!, normals[v + 1]!, normals[v + 2]!];
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    normals[v] = x / length;
    normals[v + 1] = y / length;
    normals[v + 2] = z / length;
  }
  return normals;
}
