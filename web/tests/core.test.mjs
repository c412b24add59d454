// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The package of npm and the native tool: the same bits, the same verdicts, the same words.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

import { different, native, own, said, scratch, source, tool, web, write } from "./helpers.mjs";

const folder = scratch("core");
const { load } = await import(pathToFileURL(join(web, "dist", "package", "index.js")));
const sp = await load();
const { examples, small, torus } = await source("examples.ts");
const { off } = await source("downloads.ts");

const defaults = { method: "balanced", weights: "conformal", spring_exponent: 2, area_exponent: 1, triangulate: false };

function mapFile(file, { triangulate, ...options }) {
  try {
    const mesh = sp.readMesh(basename(file), readFileSync(file), { triangulate });
    return sp.parameterize(mesh.points, mesh.triangles, options);
  } catch (error) {
    return { error_code: error.code, error: error.message, detail: said(error.message) };
  }
}

/// Maps a file by both, and compares.
function compare(file, settings = {}) {
  const all = { ...defaults, ...settings };
  const options = ["--method", all.method, "--weights", all.weights];
  if (all.method === "balanced" || all.method === "automatic") options.push("--spring-exponent", String(all.spring_exponent));
  if (all.method === "isometric" || all.method === "automatic") options.push("--area-exponent", String(all.area_exponent));
  if (all.triangulate) options.push("--triangulate");
  const expected = native(file, folder, options);
  const found = mapFile(file, all);
  const what = `${basename(file)} ${options.join(" ")}`;
  if (expected.error === null) {
    assert.equal(found.error, "", what);
    assert.equal(found.flipped_faces, 0, what);
    assert.equal(found.degree, 1, what);
    assert.equal(different(found.sphere, expected.sphere), 0, `${what}: bits`);
  } else {
    // the remedies differ, where the tool has options for them
    assert.notEqual(found.error_code, "OK", what);
    const words = found.sphere ? found.error : found.detail;
    assert.equal(words.split(/[:;]/)[0], said(expected.error).split(/[:;]/)[0], what);
  }
  return found;
}

/// Every setting on a small mesh, the page's defaults on its examples.
const settings = [
  ...["conformal", "clamped", "barycentric", "mean-value"].map((weights) => ({ method: "balanced", weights })),
  ...[2.3, 2.5, 3].map((spring_exponent) => ({ method: "balanced", spring_exponent })),
  ...[0, 0.3, 0.5, 1, 2].map((area_exponent) => ({ method: "isometric", area_exponent })),
];
const cases = [
  ...settings.map((one) => ({ file: "small.off", mesh: small, settings: one })),
  ...examples.map(({ file, mesh }) => ({ file, mesh, settings: { method: "automatic" } })),
];
for (const { file, mesh, settings } of cases)
  test(`bits: ${file}, ${Object.values(settings).join(", ")}`, () => void compare(write(folder, file, off(mesh())), settings));

test("a torus is refused in the words of the tool", () => {
  const found = compare(write(folder, "torus.off", off(torus(40, 20))));
  assert.equal(found.error_code, "WRONG_GENUS");
});

const cube =
  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" +
  "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const tetrahedron = "4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const stl = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map((f) => f.map((v) => `vertex ${["0 0 0", "1 0 0", "0 1 0", "0 0 1"][v]}`));
const files = {
  "cube.obj": cube,
  "tetrahedron.off": "OFF\n" + tetrahedron,
  "tetrahedron.ply":
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 4\n" +
    "property list uchar int vertex_indices\nend_header\n" + tetrahedron.split("\n").slice(1).join("\n"),
  "tetrahedron.stl":
    "solid t\n" + stl.map((f) => `facet normal 0 0 0\nouter loop\n${f.join("\n")}\nendloop\nendfacet\n`).join("") + "endsolid t\n",
  "open.off": "OFF\n" + tetrahedron.replace("4 4 0", "4 3 0").replace("3 2 0 3\n", ""),
  "turned.off": "OFF\n" + tetrahedron.replace("3 2 0 3", "3 0 2 3"),
  "two.off": "OFF\n8 8 0\n" + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n".repeat(2) +
    [0, 4].map((k) => [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map((f) => `3 ${f.map((v) => v + k).join(" ")}\n`).join("")).join(""),
  "nan.off": "OFF\n" + tetrahedron.replace("1 0 0", "nan 0 0"),
  "cut.off": "OFF\n" + tetrahedron.slice(0, 40),
  "words.off": "OFF\n" + tetrahedron.replace("1 0 0", "one 0 0"),
  "far.off": "OFF\n" + tetrahedron.replace("3 1 2 3", "3 1 2 9"),
  "mesh.xyz": "0 0 0\n",
  "empty.off": "",
};
for (const [name, text] of Object.entries(files)) test(`verdict: ${name}`, () => void compare(write(folder, name, text)));
test("polygons are cut where asked", () => void compare(write(folder, "cube.obj", cube), { triangulate: true }));

// every format that the tool writes, as it is and compressed
const page = readFileSync(join(web, "src", "page.html"), "utf8");
const help = execFileSync(tool, ["map", "--help"], { encoding: "utf8" });
for (const format of /--format \{(.*)\}/.exec(help)[1].split(","))
  test(`verdict: ${format}`, () => {
    const name = format === "freesurfer" ? "lh.written" : `written.${format === "gifti" ? "surf.gii" : format}`;
    execFileSync(tool, ["map", write(folder, "small.off", off(small())), "-o", join(folder, name), "--format", format]);
    assert.equal(compare(join(folder, name)).error_code, "OK");
    writeFileSync(join(folder, `${name}.gz`), gzipSync(readFileSync(join(folder, name))));
    assert.equal(compare(join(folder, `${name}.gz`)).error_code, "OK");
    const extension = basename(name).split(".").pop();
    assert.ok(format === "freesurfer" || new RegExp(`accept="[^"]*\\.${extension},`).test(page), `${extension} can be chosen`);
  });

for (const file of own) test(`unseen: ${basename(file)}`, () => void compare(file));

test("numbers beyond 32 bits are what they are", () => {
  const glb = join(folder, "good.glb");
  execFileSync(tool, ["map", write(folder, "small.off", off(small())), "-o", glb]);
  const bytes = readFileSync(glb);
  const size = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString("utf8", 20, 20 + size));
  const changed = (change) => {
    const copy = structuredClone(json);
    change(copy);
    const text = Buffer.from(JSON.stringify(copy));
    const padded = Buffer.concat([text, Buffer.alloc(-text.length & 3, " ")]);
    const head = Buffer.from(bytes.subarray(0, 20));
    head.writeUInt32LE(bytes.length - size + padded.length, 8);
    head.writeUInt32LE(padded.length, 12);
    return Buffer.concat([head, padded, bytes.subarray(20 + size)]);
  };
  for (const [name, change] of Object.entries({
    offset: (j) => (j.bufferViews[0].byteOffset = 2 ** 32),
    length: (j) => (j.bufferViews[0].byteLength += 2 ** 32),
    count: (j) => (j.accessors[0].count = 2 ** 30 + 12),
    begin: (j) => (j.accessors[0].byteOffset = 2 ** 32 - 8),
  })) {
    writeFileSync(join(folder, `${name}.glb`), changed(change));
    assert.match(compare(join(folder, `${name}.glb`)).error, /cut short/);
  }
  const stl = Buffer.alloc(84 + 4 * 50);
  stl.writeUInt32LE(0x80000004, 80);
  writeFileSync(join(folder, "over.stl"), stl);
  assert.match(compare(join(folder, "over.stl")).error, /cut short/);
});

test("wrong arguments are a TypeError or a RangeError", () => {
  const mesh = small();
  const map = (options) => sp.parameterize(mesh.points, mesh.triangles, options);
  assert.throws(() => map({ method: "balanced", accuracy: Infinity }), RangeError);
  assert.equal(map({ method: "balanced", iterations: 2 ** 32 }).error_code, "OK");
  const bytes = new TextEncoder().encode(off(mesh));
  for (const wrong of [undefined, null, [1, 2], new DataView(bytes.buffer), new Float64Array(2), "OFF"])
    assert.throws(() => sp.readMesh("a.off", wrong), TypeError);
  assert.throws(() => sp.readMesh(5, bytes), TypeError);
  for (const options of [{ triangulat: true }, { triangulate: "yes" }]) assert.throws(() => sp.readMesh("a.off", bytes, options), TypeError);
  assert.equal(sp.readMesh("a.off", bytes, {}).points.length, mesh.points.length);
});

test("orientations are exact", async () => {
  copyFileSync(join(web, "build", "core", "core.js"), join(folder, "core.cjs")); // no ES module
  const core = await createRequire(import.meta.url)(join(folder, "core.cjs"))();
  /// The determinant in integers: every double is one times 2^-1074.
  const integer = (x) => {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, x);
    const bits = view.getBigUint64(0);
    const exponent = Number((bits >> 52n) & 0x7ffn);
    const fraction = bits & 0xfffffffffffffn;
    const size = exponent === 0 ? fraction : (fraction | 0x10000000000000n) << BigInt(exponent - 1);
    return bits >> 63n ? -size : size;
  };
  const sign = (c) => {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = c.map(integer);
    const d = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    return d > 0n ? 1 : d < 0n ? -1 : 0;
  };
  let state = 12345;
  const random = () => (state = (1103515245 * state + 12345) % 2147483648) / 2147483648 - 0.5;
  const unit = () => {
    const v = [random(), random(), random()];
    return v.map((x) => x / Math.hypot(...v));
  };
  const seen = new Set();
  for (let i = 0; i < 2000; ++i) {
    const [a, b, s, t] = [unit(), unit(), random(), random()];
    const c = a.map((x, k) => s * x + t * b[k]); // in one plane with a, b and 0, but for rounding
    const scale = i % 4 === 0 ? 1e-160 : 1; // products underflow
    const coordinates = [...a, ...b, ...c].map((x) => x * scale);
    assert.equal(core.orientation(coordinates), sign(coordinates));
    seen.add(core.orientation(coordinates));
  }
  assert.equal(core.orientation([1, 0, 0, 0, 1, 0, 1, 1, 0]), 0);
  assert.ok(seen.has(1) && seen.has(-1));
});
