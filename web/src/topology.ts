// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Where a mesh is not a sphere: what to mark on it, when the core has refused it.

import type { Mesh } from "./model";

export interface Trouble {
  kind: "boundary" | "non-manifold" | "orientation" | "component" | "handle";
  lines: Uint32Array; // pairs of points
  count: number; // loops, edges, components or handles
}

interface Edge {
  a: number;
  b: number;
  faces: number[];
  forward: number; // how many faces run from the smaller point to the larger one
}

function edgesOf(mesh: Mesh): Edge[] {
  const n = mesh.points.length / 3;
  const edges = new Map<number, Edge>();
  const t = mesh.triangles;
  for (let c = 0; c < t.length; ++c) {
    const from = t[c]!;
    const to = t[c % 3 === 2 ? c - 2 : c + 1]!;
    if (from === to) continue; // the face has no area, and no edge here
    const a = Math.min(from, to);
    const b = Math.max(from, to);
    let edge = edges.get(a * n + b);
    if (!edge) edges.set(a * n + b, (edge = { a, b, faces: [], forward: 0 }));
    edge.faces.push((c / 3) | 0);
    if (from === a) ++edge.forward;
  }
  return [...edges.values()];
}

/// Disjoint sets.
class Sets {
  parent: Int32Array;
  constructor(n: number) {
    this.parent = Int32Array.from({ length: n }, (_, i) => i);
  }
  root(i: number): number {
    while (this.parent[i] !== i) i = this.parent[i] = this.parent[this.parent[i]!]!;
    return i;
  }
  join(i: number, j: number): boolean {
    const [a, b] = [this.root(i), this.root(j)];
    if (a === b) return false;
    this.parent[Math.max(a, b)] = Math.min(a, b);
    return true;
  }
}

const linesOf = (edges: Edge[]) => Uint32Array.from(edges.flatMap((e) => [e.a, e.b]));

function number(edges: Edge[], points: number): number {
  const sets = new Sets(points);
  for (const e of edges) sets.join(e.a, e.b);
  return new Set(edges.map((e) => sets.root(e.a))).size;
}

/// Shortest loops through the handles of a closed oriented surface: a tree of shortest paths, a spanning tree of the
/// dual graph that does not cross it and prefers edges that close long loops, and what is left. J. Erickson, K.
/// Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005.
function handles(mesh: Mesh, edges: Edge[], root: number): Uint32Array[] {
  const n = mesh.points.length / 3;
  const p = mesh.points;
  const length = (e: Edge) =>
    Math.hypot(...[0, 1, 2].map((k) => p[3 * e.a + k]! - p[3 * e.b + k]!));
  const around: Edge[][] = Array.from({ length: n }, () => []);
  for (const e of edges) {
    around[e.a]!.push(e);
    around[e.b]!.push(e);
  }
  // by rounds, until nothing gets shorter: as good as Dijkstra's queue for a mesh, and without one
  const distance = new Float64Array(n).fill(Infinity);
  const before: (Edge | undefined)[] = new Array(n);
  distance[root] = 0;
  for (let front = [root]; front.length > 0; ) {
    const next = new Set<number>();
    for (const v of front)
      for (const e of around[v]!) {
        const w = e.a === v ? e.b : e.a;
        const d = distance[v]! + length(e);
        if (d < distance[w]! * (1 - 1e-12)) {
          distance[w] = d;
          before[w] = e;
          next.add(w);
        }
      }
    front = [...next];
  }
  const inTree = new Set(before.filter((e) => e !== undefined));
  const rest = edges
    .filter((e) => !inTree.has(e) && e.faces.length === 2)
    .sort((e, f) => distance[f.a]! + distance[f.b]! + length(f) - (distance[e.a]! + distance[e.b]! + length(e)));
  const dual = new Sets(mesh.triangles.length / 3);
  const generators = rest.filter((e) => !dual.join(e.faces[0]!, e.faces[1]!));
  return generators.map((e) => {
    const path = (v: number) => {
      const result: Edge[] = [];
      for (let f = before[v]; f; f = before[v]) {
        result.push(f);
        v = f.a === v ? f.b : f.a;
      }
      return result;
    };
    const [one, other] = [path(e.a), path(e.b)];
    while (one.length > 0 && one[one.length - 1] === other[other.length - 1]) {
      one.pop();
      other.pop();
    }
    return linesOf([...one, e, ...other]);
  });
}

/// What to mark; empty if this is a sphere.
export function troublesOf(mesh: Mesh): Trouble[] {
  const n = mesh.points.length / 3;
  const edges = edgesOf(mesh);
  const troubles: Trouble[] = [];
  const add = (kind: Trouble["kind"], which: Edge[], count = which.length) => {
    if (count > 0) troubles.push({ kind, lines: linesOf(which), count });
  };
  const border = edges.filter((e) => e.faces.length === 1);
  add("boundary", border, number(border, n));
  add("non-manifold", edges.filter((e) => e.faces.length > 2));
  add("orientation", edges.filter((e) => e.faces.length === 2 && e.forward !== 1));
  if (troubles.length > 0) return troubles;

  const sets = new Sets(n);
  for (const e of edges) sets.join(e.a, e.b);
  const size = new Map<number, number>();
  for (const e of edges) size.set(sets.root(e.a), (size.get(sets.root(e.a)) ?? 0) + 1);
  const largest = [...size.keys()].reduce((a, b) => (size.get(b)! > size.get(a)! ? b : a), edges[0]?.a ?? 0);
  if (size.size > 1) add("component", edges.filter((e) => sets.root(e.a) !== largest), size.size);
  else if (edges.length > 0 && edges.length <= 1_500_000 && !isPinched(mesh, edges)) {
    const loops = handles(mesh, edges, largest);
    if (loops.length > 0)
      troubles.push({
        kind: "handle",
        lines: Uint32Array.from(loops.flatMap((loop) => [...loop])),
        count: loops.length / 2,
      });
  }
  return troubles;
}

/// Whether parts of a closed surface only touch in a vertex: then it has no loops to show.
function isPinched(mesh: Mesh, edges: Edge[]): boolean {
  const fans = new Sets(mesh.triangles.length);
  const corner = (f: number, v: number) => [0, 1, 2].map((k) => 3 * f + k).find((c) => mesh.triangles[c] === v)!;
  for (const { a, b, faces } of edges) for (const v of [a, b]) fans.join(corner(faces[0]!, v), corner(faces[1]!, v));
  return new Set(Array.from(mesh.triangles, (_, c) => fans.root(c))).size > new Set(mesh.triangles).size;
}

/// In words.
export function nameOfTrouble({ kind, count }: Trouble): string {
  const many = (one: string, more: string) => `${count.toLocaleString("en")} ${count === 1 ? one : more}`;
  switch (kind) {
    case "boundary":
      return many("hole", "holes");
    case "non-manifold":
      return many("edge with more than two faces", "edges with more than two faces");
    case "orientation":
      return many("edge between faces of opposite orientations", "edges between faces of opposite orientations");
    case "component":
      return many("component", "components");
    case "handle":
      return many("handle", "handles");
  }
}
