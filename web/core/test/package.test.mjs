// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The package by itself: npm test.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

import { load, MeshError } from "../index.js";

const sp = await load();

/// A sphere of n rings of m quadrangles, cut in two, with bumps.
function body(n, m) {
  const points = [0, 0, 1.2];
  for (let i = 1; i < n; ++i)
    for (let j = 0; j < m; ++j) {
      const [a, b] = [(Math.PI * i) / n, (2 * Math.PI * j) / m];
      const r = 1 + 0.3 * Math.sin(3 * a) * Math.cos(2 * b);
      points.push(r * Math.sin(a) * Math.cos(b), r * Math.sin(a) * Math.sin(b), 1.2 * r * Math.cos(a));
    }
  const last = points.push(0, 0, -1.2) / 3 - 1;
  const at = (i, j) => (i === 0 ? 0 : i === n ? last : 1 + (i - 1) * m + (j % m));
  const triangles = [];
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < m; ++j) {
      if (i > 0) triangles.push(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i < n - 1) triangles.push(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return { points: Float64Array.from(points), triangles: Uint32Array.from(triangles) };
}
const { points, triangles } = body(24, 32);
const off = (p, t) =>
  `OFF\n${p.length / 3} ${t.length / 3} 0\n` +
  Array.from(p, (x, i) => x + (i % 3 === 2 ? "\n" : " ")).join("") +
  Array.from(t, (v, i) => (i % 3 === 0 ? "3 " : "") + v + (i % 3 === 2 ? "\n" : " ")).join("");
const bytesOf = (text) => new TextEncoder().encode(text);

/// Twelve times the volumes of the tetrahedra between the origin and the faces: positive where no face is turned over.
function volumes(p, t) {
  return Array.from({ length: t.length / 3 }, (_, f) => {
    const [a, b, c] = [0, 1, 2].map((k) => p.slice(3 * t[3 * f + k], 3 * t[3 * f + k] + 3));
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  });
}

for (const method of ["automatic", "balanced", "isometric", "saddle-point"])
  for (const weights of ["conformal", "clamped", "barycentric", "mean-value"])
    test(`${method}, ${weights}`, () => {
      const result = sp.parameterize(points, triangles, { method, weights });
      assert.equal(result.error_code, "OK");
      assert.deepEqual([result.valid, result.error, result.flipped_faces, result.degree], [true, "", 0, 1]);
      assert.equal(result.sphere.length, points.length);
      for (let v = 0; v < points.length; v += 3) assert.ok(Math.abs(Math.hypot(...result.sphere.slice(v, v + 3)) - 1) < 1e-12);
      assert.ok(volumes(result.sphere, triangles).every((volume) => volume > 0));
      assert.ok(["converged", "iterations", "stalled"].includes(result.termination));
    });

test("arrays are not written to, and may have other types", () => {
  const result = sp.parameterize(points, triangles);
  const again = sp.parameterize(points.slice(), Int32Array.from(triangles), { method: "automatic", progress: undefined });
  assert.deepEqual(again.sphere, result.sphere);
  assert.deepEqual({ points, triangles }, body(24, 32));
  const floats = Float32Array.from(points);
  assert.deepEqual(sp.parameterize(floats, triangles).sphere, sp.parameterize(Float64Array.from(floats), triangles).sphere);
});

test("cores do not disturb each other", async () => {
  const other = await load();
  assert.deepEqual(other.parameterize(points, triangles).sphere, sp.parameterize(points, triangles).sphere);
});

test("what is no sphere is said in the result", () => {
  const refused = (p, t, code) => {
    const result = sp.parameterize(Float64Array.from(p), Uint32Array.from(t));
    assert.deepEqual([result.valid, result.error_code, result.sphere], [false, code, undefined]);
    assert.ok(result.error.length > 10 && result.detail.length > 0, JSON.stringify(result));
  };
  refused(points, triangles.slice(3), "BOUNDARY");
  refused(points, [...triangles.slice(3), triangles[1], triangles[0], triangles[2]], "INCONSISTENT_ORIENTATION");
  refused([...points, 0, 0, 0], triangles, "ISOLATED_VERTEX");
  refused(points, [...triangles.slice(3), 0, 1, 4_294_967_295], "BAD_INDEX");
  refused([NaN, ...points.slice(1)], triangles, "NON_FINITE_COORDINATE");
  refused([], [], "EMPTY_MESH");
});

test("progress is heard, and ends the work", () => {
  const shares = [];
  sp.parameterize(points, triangles, { progress: (share) => void shares.push(share) });
  assert.ok(shares.length > 2 && shares.every((s, i) => s >= 0 && s <= 1 && (i === 0 || s >= shares[i - 1])), String(shares));
  const ended = sp.parameterize(points, triangles, { progress: (share) => share < 0.2 });
  assert.deepEqual([ended.valid, ended.error_code, ended.termination], [false, "INTERRUPTED", "callback"]);
  assert.equal(ended.sphere.length, points.length);
  const early = sp.parameterize(points, triangles, { progress: () => false });
  assert.deepEqual([early.error_code, early.termination, early.sphere], ["INTERRUPTED", "callback", undefined]);
  const late = sp.parameterize(points, triangles, { maximum_running_time: 0 });
  assert.equal(late.error_code, "INTERRUPTED");
  const broken = () => {
    throw new Error("of the caller");
  };
  assert.throws(() => sp.parameterize(points, triangles, { progress: broken }), /of the caller/);
  assert.ok(sp.parameterize(points, triangles).valid);
});

test("wrong arguments", () => {
  const wrong = (kind, words, ...args) => assert.throws(() => sp.parameterize(...args), (e) => e instanceof kind && words.test(e.message));
  wrong(TypeError, /points has to be a Float64Array/, [0, 0, 0], triangles);
  wrong(TypeError, /triangles has to be a Int32Array or Uint32Array, and is Float64Array/, points, points);
  wrong(RangeError, /three numbers each/, points.slice(1), triangles);
  wrong(TypeError, /no option 'metod'/, points, triangles, { metod: "balanced" });
  wrong(RangeError, /method has to be one of automatic, balanced/, points, triangles, { method: "harmonic" });
  wrong(TypeError, /accuracy has to be a number/, points, triangles, { accuracy: "1e-3" });
  wrong(RangeError, /./, points, triangles, { accuracy: -1 });
  wrong(RangeError, /./, points, triangles, { iterations: -1 });
  wrong(RangeError, /./, points, triangles, { maximum_running_time: -1 });
  wrong(RangeError, /./, points, triangles, { method: "balanced", spring_exponent: 1 });
});

test("measures do not depend on the radius of the sphere", () => {
  const { sphere } = sp.parameterize(points, triangles);
  const measures = sp.measure(points, triangles, sphere);
  assert.equal(measures.face_stretch.length, triangles.length / 3);
  assert.ok(measures.face_angle_distortion.every((x) => x >= 0 && x < Math.PI));
  assert.ok(measures.distortion.dilatation.min >= 1 && measures.distortion.symmetric_dirichlet.min >= 4 - 1e-9);
  const large = sp.measure(points, triangles, sphere.map((x) => 100 * x));
  measures.face_stretch.forEach((x, f) => assert.ok(Math.abs(x - large.face_stretch[f]) < 1e-9));
  assert.throws(() => sp.measure(points, triangles, sphere.slice(3)), RangeError);
  assert.throws(() => sp.measure(points, triangles, sphere.map(() => 0)), (e) => e instanceof MeshError && e.code === "NON_FINITE_COORDINATE");
  const segments = sp.segment(points, triangles, sphere);
  assert.ok(segments.length === triangles.length / 3 && segments.includes(0));
});

test("files are read, compressed ones, too", () => {
  const text = off(points, triangles);
  for (const bytes of [bytesOf(text), new Uint8Array(gzipSync(text))]) {
    const mesh = sp.readMesh("body.off", bytes);
    assert.deepEqual([mesh.points, mesh.triangles], [points, Int32Array.from(triangles)]);
  }
  const refused = (bytes, code, words) =>
    assert.throws(() => sp.readMesh("body.off", bytes), (e) => e instanceof MeshError && e.code === code && words.test(e.message));
  refused(new Uint8Array(gzipSync(text)).slice(0, 999), "UNREADABLE_FILE", /^body.off: .*cut short/);
  refused(bytesOf(text.slice(0, 999)), "UNREADABLE_FILE", /^body.off: /);
  refused(new Uint8Array(), "UNREADABLE_FILE", /is empty/);
  const square = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  refused(bytesOf(square), "NOT_TRIANGULAR", /first: face 0 with 4 vertices/);
  assert.equal(sp.readMesh("square.off", bytesOf(square), { triangulate: true }).triangles.length, 6);
});
