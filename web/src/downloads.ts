// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Results as files.

import { coloursOf, isDark, type Colouring } from "./colours";
import { drawable, meanOverFaces, normalsOf, type Mesh, type Model, type Report } from "./model";

const rowOf = (rows: ArrayLike<number>, i: number) => `${rows[3 * i]} ${rows[3 * i + 1]} ${rows[3 * i + 2]}`;

/// Lines in pieces of thousands: a string has half a gigabyte at most, and a string for every line takes more memory than all.
function lines(count: number, line: (i: number) => string): string[] {
  const size = 2 ** 16;
  const piece = (first: number) =>
    Array.from({ length: Math.min(size, count - first) }, (_, i) => line(first + i) + "\n").join("");
  return Array.from({ length: Math.ceil(count / size) }, (_, k) => piece(k * size));
}

/// Vertices and faces in their order. Numbers are the shortest that read as the same doubles.
export function offInPieces({ points, triangles }: Mesh): string[] {
  const [n, m] = [points.length / 3, triangles.length / 3];
  return [`OFF\n${n} ${m} 0\n`, ...lines(n, (v) => rowOf(points, v)), ...lines(m, (f) => `3 ${rowOf(triangles, f)}`)];
}

/// The same of a mesh that is not large.
export const off = (mesh: Mesh) => offInPieces(mesh).join("");

/// The mesh with the colours that are shown, and the values behind them.
export function colouredPly(model: Model, colouring: Colouring): string[] {
  const [n, m] = [model.points.length / 3, model.triangles.length / 3];
  const { ofVertex } = coloursOf(model, colouring);
  const ofSegments = colouring === "segments" && model.segments;
  const stretch = model.stretch && meanOverFaces(model, model.stretch);
  const properties = ["double x", "double y", "double z"];
  const colour = ["uchar red", "uchar green", "uchar blue"];
  if (!ofSegments) properties.push(...colour);
  if (stretch) properties.push("double log_area_stretch");
  const rgb = (v: number, f: number) => " " + ofVertex(v, f).map(Math.round).join(" ");
  const head = [
    "ply",
    "format ascii 1.0",
    `comment colours: ${colouring}`,
    `element vertex ${n}`,
    ...properties.map((p) => "property " + p),
    `element face ${m}`,
    "property list uchar int vertex_indices",
    ...(ofSegments ? [...colour, "int segment"].map((p) => "property " + p) : []),
    "end_header",
  ];
  return [
    head.join("\n") + "\n",
    ...lines(n, (v) => rowOf(model.points, v) + (ofSegments ? "" : rgb(v, 0)) + (stretch ? ` ${stretch[v]}` : "")),
    ...lines(m, (f) => `3 ${rowOf(model.triangles, f)}` + (ofSegments ? `${rgb(0, f)} ${ofSegments[f]}` : "")),
  ];
}

/// The report, with the names that the tool uses.
export function json(report: Report): string {
  return JSON.stringify(report, null, 2) + "\n";
}

/// The checker as a picture of longitude and latitude.
async function checkerPng(): Promise<Uint8Array> {
  const [width, height] = [1024, 512];
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = canvas.getContext("2d")!;
  const image = context.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    const longitude = (2 * Math.PI * ((i % width) + 0.5)) / width - Math.PI;
    const latitude = Math.PI / 2 - (Math.PI * (Math.floor(i / width) + 0.5)) / height;
    const c = Math.cos(latitude);
    const dark = isDark(c * Math.cos(longitude), c * Math.sin(longitude), Math.sin(latitude));
    image.data.set(dark ? [41, 77, 107, 255] : [237, 232, 219, 255], 4 * i);
  }
  context.putImageData(image, 0, 0);
  const blob = await new Promise<Blob>((done) => canvas.toBlob((b) => done(b!), "image/png"));
  return new Uint8Array(await blob.arrayBuffer());
}

/// Longitude and latitude of every corner; vertices are doubled where the picture begins again.
function unwrap(model: Model): { source: number[]; uv: number[]; index: Uint32Array } {
  const s = model.sphere!;
  const n = s.length / 3;
  const source = Array.from({ length: n }, (_, v) => v);
  const uv: number[] = [];
  for (let v = 0; v < n; ++v)
    uv.push(
      Math.atan2(s[3 * v + 1]!, s[3 * v]!) / (2 * Math.PI) + 0.5,
      0.5 - Math.asin(Math.min(1, Math.max(-1, s[3 * v + 2]!))) / Math.PI,
    );
  const index = new Uint32Array(model.triangles);
  const copies = new Map<number, number>();
  for (let f = 0; f < index.length; f += 3) {
    const us = [0, 1, 2].map((k) => uv[2 * index[f + k]!]!);
    if (Math.max(...us) - Math.min(...us) <= 0.5) continue;
    us.forEach((u, k) => {
      if (u >= 0.5) return;
      const v = index[f + k]!;
      let copy = copies.get(v);
      if (copy === undefined) {
        copies.set(v, (copy = source.push(v) - 1));
        uv.push(u + 1, uv[2 * v + 1]!);
      }
      index[f + k] = copy;
    });
  }
  return { source, uv, index };
}

/// The mesh as binary glTF, with the checker as its texture and the sphere as a morph target.
export async function texturedGlb(model: Model): Promise<Uint8Array> {
  let [largest, rounding] = [0, 0];
  const [least, most] = [Array(3).fill(Infinity), Array(3).fill(-Infinity)];
  model.points.forEach((x: number, i: number) => {
    largest = Math.max(largest, Math.abs(x));
    rounding = Math.max(rounding, Math.abs(Math.fround(x) - x));
    least[i % 3] = Math.min(least[i % 3], x);
    most[i % 3] = Math.max(most[i % 3], x);
  });
  if (!(Math.fround(largest) < Infinity && largest >= 2 ** -126))
    throw new Error(`the format holds floats, and the largest coordinate, ${largest.toPrecision(3)}, is beyond their range`);
  if (rounding > 1e-3 * Math.hypot(...least.map((x, k) => most[k] - x))) // as the tool says it
    throw new Error("the format holds floats, which would change the shape, since the mesh is far from the origin");
  const { source, uv, index } = unwrap(model);
  const position = Float32Array.from(source.flatMap((v) => [0, 1, 2].map((k) => model.points[3 * v + k]!)));
  const low = [0, 1, 2].map((k) => source.reduce((m, _, v) => Math.min(m, position[3 * v + k]!), Infinity));
  const high = [0, 1, 2].map((k) => source.reduce((m, _, v) => Math.max(m, position[3 * v + k]!), -Infinity));
  const radius = Math.max(...low.map((x, k) => high[k]! - x)) / 2;
  const centre = low.map((x, k) => (x + high[k]!) / 2);
  const morph = Float32Array.from(
    source.flatMap((v, i) => [0, 1, 2].map((k) => centre[k]! + radius * model.sphere![3 * v + k]! - position[3 * i + k]!)),
  );
  const ends = (values: Float32Array, end: (a: number, b: number) => number) =>
    [0, 1, 2].map((k) => source.reduce((m, _, v) => end(m, values[3 * v + k]!), values[k]!));
  const normals = normalsOf(drawable(model));
  const normal = Float32Array.from(source.flatMap((v) => [...normals.subarray(3 * v, 3 * v + 3)]));
  const png = await checkerPng();
  const parts: Uint8Array[] = [position, morph, Float32Array.from(uv), index, normal, png].map(
    (a) => new Uint8Array(a.buffer, a.byteOffset, a.byteLength),
  );
  let end = 0;
  const bufferViews = parts.map((part, i) => {
    const view = { buffer: 0, byteOffset: end, byteLength: part.length, ...(i < 5 ? { target: i === 3 ? 34963 : 34962 } : {}) };
    end += (part.length + 3) & ~3;
    return view;
  });
  const [FLOAT, UINT] = [5126, 5125];
  const count = source.length;
  const gltf = {
    asset: { version: "2.0", generator: "CGAL Spherical Parameterization" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: model.report.input }],
    meshes: [
      {
        primitives: [{ attributes: { POSITION: 0, NORMAL: 4, TEXCOORD_0: 2 }, indices: 3, material: 0, targets: [{ POSITION: 1 }] }],
        weights: [0],
        extras: { targetNames: ["sphere"] },
      },
    ],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: 0.8 } }],
    textures: [{ source: 0, sampler: 0 }],
    samplers: [{ wrapS: 10497, wrapT: 33071 }],
    images: [{ bufferView: 5, mimeType: "image/png" }],
    accessors: [
      { bufferView: 0, componentType: FLOAT, count, type: "VEC3", min: low, max: high },
      { bufferView: 1, componentType: FLOAT, count, type: "VEC3", min: ends(morph, Math.min), max: ends(morph, Math.max) },
      { bufferView: 2, componentType: FLOAT, count, type: "VEC2" },
      { bufferView: 3, componentType: UINT, count: index.length, type: "SCALAR" },
      { bufferView: 4, componentType: FLOAT, count, type: "VEC3" },
    ],
    bufferViews,
    buffers: [{ byteLength: end }],
  };
  const text = new TextEncoder().encode(JSON.stringify(gltf));
  const padded = (text.length + 3) & ~3;
  const glb = new Uint8Array(12 + 8 + padded + 8 + end);
  const header = new DataView(glb.buffer);
  [0x46546c67, 2, glb.length, padded, 0x4e4f534a].forEach((word, i) => header.setUint32(4 * i, word, true));
  glb.fill(32, 20, 20 + padded);
  glb.set(text, 20);
  header.setUint32(20 + padded, end, true);
  header.setUint32(24 + padded, 0x004e4942, true);
  parts.forEach((part, i) => glb.set(part, 28 + padded + bufferViews[i]!.byteOffset));
  return glb;
}

/// Lets the browser save a file.
export function save(name: string, pieces: (string | Uint8Array)[], type: string): void {
  const url = URL.createObjectURL(new Blob(pieces as BlobPart[], { type }));
  Object.assign(document.createElement("a"), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
