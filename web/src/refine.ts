// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

/// Faces in parts that look round on the sphere.
export interface Refined {
  corners: Uint32Array<ArrayBuffer>; // of the parts
  faceOf: Uint32Array<ArrayBuffer>; // of every part: its face, in the order of the faces
  halves: Uint32Array<ArrayBuffer>; // of every new vertex, behind the others: the two between which it is
}

/// Cuts faces in two until no edge on the sphere is long: then the chord is less than half a pixel from the sphere in a view
/// of 600 pixels. Where an edge is cut depends on nothing but the edge, so that neighbours fit.
export function refined(corners: Uint32Array, sphere: Float32Array): Refined {
  const longest = 0.12;
  const points = Array.from(sphere);
  const square = (a: number, b: number) => {
    const [x, y, z] = [0, 1, 2].map((k) => points[3 * a + k]! - points[3 * b + k]!) as [number, number, number];
    return x * x + y * y + z * z;
  };
  const halves: number[] = [];
  const middles = new Map<number, number>();
  const middle = (a: number, b: number) => {
    const key = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
    let m = middles.get(key);
    if (m === undefined) {
      middles.set(key, (m = points.length / 3));
      let sum = [0, 1, 2].map((k) => points[3 * a + k]! + points[3 * b + k]!);
      if (Math.hypot(...sum) < 1e-6) {
        // opposite ends: any point between them will do that is opposite to no other one
        const [x, y, z] = points.slice(3 * a, 3 * a + 3) as [number, number, number];
        const [p, q, r] = [0.31, 0.59, 0.75];
        sum = [y * r - z * q, z * p - x * r, x * q - y * p];
      }
      const length = Math.hypot(...sum);
      points.push(...sum.map((x) => x / length));
      halves.push(a, b);
    }
    return m;
  };
  const result: number[] = [];
  const faceOf: number[] = [];
  const cut = (face: number, a: number, b: number, c: number): void => {
    const [ab, bc, ca] = [square(a, b), square(b, c), square(c, a)];
    const most = Math.max(ab, bc, ca);
    if (!(most > longest * longest)) {
      result.push(a, b, c);
      faceOf.push(face);
    } else if (most === ab) {
      // first: of edges of the same length another one would turn the corners for ever
      const m = middle(a, b);
      cut(face, a, m, c);
      cut(face, m, b, c);
    } else if (most === bc) cut(face, b, c, a);
    else cut(face, c, a, b);
  };
  for (let f = 0; f < corners.length / 3; ++f) cut(f, corners[3 * f]!, corners[3 * f + 1]!, corners[3 * f + 2]!);
  return { corners: Uint32Array.from(result), faceOf: Uint32Array.from(faceOf), halves: Uint32Array.from(halves) };
}
