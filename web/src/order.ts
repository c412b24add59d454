// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

/// The triangles in an order in which vertices are used again while the renderer still remembers them: files often have
/// them in any order. P. Sander, D. Nehab, J. Barczak, "Fast triangle reordering for vertex locality and reduced
/// overdraw", SIGGRAPH 2007. Corners keep their order.
export function localOrder(corners: Uint32Array, vertices: number): Uint32Array {
  const memory = 16;
  const first = new Uint32Array(vertices + 1); // of the faces round a vertex
  for (const v of corners) first[v + 1]!++;
  for (let v = 0; v < vertices; ++v) first[v + 1]! += first[v]!;
  const around = new Uint32Array(corners.length);
  const end = first.slice();
  corners.forEach((v, c) => (around[end[v]!++] = (c / 3) | 0));

  const left = Int32Array.from({ length: vertices }, (_, v) => first[v + 1]! - first[v]!);
  const used = new Int32Array(vertices); // when
  const isDone = new Uint8Array(corners.length / 3);
  const recent: number[] = [];
  const result = new Uint32Array(corners.length);
  let written = 0;
  let now = memory + 1;
  let next = 0; // where to look for a vertex with faces left
  for (let fan = 0; fan >= 0; ) {
    const seen = recent.length;
    for (let i = first[fan]!; i < first[fan + 1]!; ++i) {
      const face = around[i]!;
      if (isDone[face]) continue;
      isDone[face] = 1;
      for (let k = 0; k < 3; ++k) {
        const v = corners[3 * face + k]!;
        result[written++] = v;
        recent.push(v);
        --left[v]!;
        if (now - used[v]! > memory) used[v] = now++;
      }
    }
    fan = -1;
    let best = -1;
    for (let i = seen; i < recent.length; ++i) {
      const v = recent[i]!;
      if (left[v]! <= 0) continue;
      const age = now - used[v]!;
      const rank = age + 2 * left[v]! <= memory ? age : 0;
      if (rank > best) [best, fan] = [rank, v];
    }
    while (fan < 0 && recent.length > 0) {
      const v = recent.pop()!;
      if (left[v]! > 0) fan = v;
    }
    while (fan < 0 && next < vertices) {
      if (left[next]! > 0) fan = next;
      else ++next;
    }
  }
  return result;
}

/// Fewer triangles between some of the vertices, for those who draw slowly: all vertices in a cell of a grid become one.
/// Positions are in [-1, 1]; there are `cells` cells along every edge of that box.
export function coarsened(corners: Uint32Array, position: Float32Array, cells: number): Uint32Array {
  const one = new Int32Array(cells ** 3).fill(-1);
  const cellOf = (x: number) => Math.min(cells - 1, Math.floor(((x + 1) / 2) * cells));
  const standsFor = new Uint32Array(position.length / 3);
  for (let v = 0; v < standsFor.length; ++v) {
    const cell = (cellOf(position[3 * v]!) * cells + cellOf(position[3 * v + 1]!)) * cells + cellOf(position[3 * v + 2]!);
    if (one[cell] === -1) one[cell] = v;
    standsFor[v] = one[cell]!;
  }
  const result = new Uint32Array(corners.length);
  let written = 0;
  for (let c = 0; c < corners.length; c += 3) {
    const [x, y, z] = [standsFor[corners[c]!]!, standsFor[corners[c + 1]!]!, standsFor[corners[c + 2]!]!];
    if (x === y || y === z || z === x) continue;
    result[written++] = x;
    result[written++] = y;
    result[written++] = z;
  }
  return result.slice(0, written);
}
