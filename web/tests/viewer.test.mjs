// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// viewer/view.html, which is in the tree so that the tool needs no npm, is what the sources make; and what it draws.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { source, web } from "./helpers.mjs";

const { refined } = await source("refine.ts");

test("viewer/view.html is built from the sources", () => {
  const file = join(web, "viewer", "view.html");
  const before = readFileSync(file, "utf8");
  try {
    execFileSync("node", [join(web, "build.mjs"), "--viewer"]);
    assert.ok(readFileSync(file, "utf8") === before, "it is another one: run node web/build.mjs --viewer, and commit it");
  } finally {
    writeFileSync(file, before);
  }
});

test("faces of a sphere are cut into short ones that cover it, also where all edges are as long", () => {
  const octahedron = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
  const points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  const { corners, faceOf, halves } = refined(Uint32Array.from(octahedron.flat()), Float32Array.from(points.flat()));
  for (let i = 0; i < halves.length; i += 2) {
    const sum = points[halves[i]].map((x, k) => x + points[halves[i + 1]][k]);
    points.push(sum.map((x) => x / Math.hypot(...sum)));
  }
  assert.deepEqual([...new Set(faceOf)], octahedron.map((_, f) => f));
  const edges = new Set();
  for (let part = 0; part < faceOf.length; ++part) {
    const [a, b, c] = corners.subarray(3 * part, 3 * part + 3);
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      assert.ok(Math.hypot(...points[from].map((x, k) => x - points[to][k])) < 0.1201);
      edges.add(`${from} ${to}`);
    }
  }
  assert.equal(edges.size, corners.length); // no edge is twice in the same direction, and
  for (const edge of edges) assert.ok(edges.has(edge.split(" ").reverse().join(" ")), edge); // its other side is there
});
