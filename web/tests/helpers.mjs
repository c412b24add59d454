// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const web = dirname(dirname(fileURLToPath(import.meta.url)));
export const tool = process.env.SPHERICAL_PARAMETERIZATION_TOOL;

/// A folder for what tests write, empty at the beginning.
export function scratch(name) {
  const folder = join(web, "build", "tests", name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}

/// A module of src/.
export async function source(name) {
  const result = await build({ entryPoints: [join(web, "src", name)], bundle: true, format: "esm", write: false });
  return import("data:text/javascript;base64," + Buffer.from(result.outputFiles[0].contents).toString("base64"));
}

/// What the native tool makes of a file, on one core: coordinates, or the words of its refusal.
export function native(file, folder, options = []) {
  const out = join(folder, "native.off");
  rmSync(out, { force: true });
  const run = spawnSync(tool, ["map", file, "-o", out, "--policy", "sequential", ...options], { encoding: "utf8" });
  if (run.status !== 0) {
    const line = run.stderr.trim().replace(/^spherical-parameterization: /, "");
    return { error: line.replace(file, basename(file)).replace("; the command 'prepare' does it", "") }; // only the tool has it
  }
  return { error: null, sphere: readOff(readFileSync(out, "utf8")).points };
}

/// What is wrong, without the name of the file.
export const said = (error) => error.replace(/^[^:]*: (has )?/, "");

/// Points and triangles of an OFF file, one after the other.
export function readOff(text) {
  const words = text.split(/\s+/);
  const [n, m] = [Number(words[1]), Number(words[2])];
  const points = Float64Array.from(words.slice(4, 4 + 3 * n), Number);
  const triangles = Array.from({ length: m }, (_, f) => words.slice(5 + 3 * n + 4 * f, 8 + 3 * n + 4 * f).map(Number));
  return { points, triangles: triangles.flat() };
}

/// How many numbers are not the same doubles.
export function different(a, b) {
  if (a.length !== b.length) return Infinity;
  let count = 0;
  for (let i = 0; i < a.length; ++i) if (!Object.is(a[i], b[i])) ++count;
  return count;
}

/// Meshes of one's own, in formats that the page reads: SPHERICAL_PARAMETERIZATION_MESHES=FOLDER.
const folderOfOwn = process.env.SPHERICAL_PARAMETERIZATION_MESHES;
export const own = !folderOfOwn
  ? []
  : readdirSync(folderOfOwn).filter((n) => /\.(off|obj|ply|stl|glb)$|^[lr]h\./.test(n)).map((n) => join(folderOfOwn, n));

export function write(folder, name, text) {
  const file = join(folder, name);
  writeFileSync(file, text);
  return file;
}
