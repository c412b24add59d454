// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Runs the compiled core away from the page, so that this never waits for it.

import { load, MeshError, start, type Measures, type Options, type Result, type SphericalParameterization } from "../core/index";
import type { Mesh, Report } from "./model";

/// How to map.
export interface Settings extends Required<Pick<Options, "method" | "weights" | "spring_exponent" | "area_exponent">> {
  triangulate: boolean;
}

/// A file to map, or a map to segment.
export type Job = MapJob | Mapped;
export interface MapJob {
  name: string;
  bytes: Uint8Array;
  settings: Settings;
  permit: string; // an address that is there as long as the job may go on
}
export interface Mapped {
  mesh: Mesh;
  sphere: Float64Array;
}

/// A report with arrays.
export type Answer = Report & Partial<Pick<Measures, "face_stretch" | "face_angle_distortion">> & Pick<Result, "sphere">;

export type Message =
  | { kind: "ready"; version: string; policy: string }
  | { kind: "mesh"; mesh: Mesh }
  | { kind: "progress"; fraction: number }
  | { kind: "answer"; answer: Answer }
  | { kind: "segments"; segments?: Int32Array; why?: string } // why there are none
  | { kind: "failed"; why: string };

const post = (message: Message, transfer: Transferable[] = []) =>
  (self as unknown as { postMessage(m: Message, t: Transferable[]): void }).postMessage(message, transfer);

/// What C++ throws, for want of memory mostly, is no Error of JavaScript and has no words.
const wordsOf = (error: unknown) => (error instanceof Error ? error.message : "there is not enough memory, or an internal error");

let policy = "sequential"; // in the words of the tool

/// Where a server permits that threads share memory, the core beside the page that uses all of the machine's.
async function allCores(): Promise<SphericalParameterization> {
  const scope = self as unknown as { name: string; importScripts(url: string): void; createCore: (options: object) => Promise<unknown> };
  const address = (name: string) => new URL(name, scope.name).href;
  scope.importScripts(address("threads.js"));
  const place = { mainScriptUrlOrBlob: address("threads.js"), locateFile: () => address("threads.worker.js") };
  const result = await start(() => scope.createCore(place));
  policy = "tbb";
  return result;
}

const core = self.crossOriginIsolated ? allCores().catch(load) : load(); // the files of all cores may not be there
core.then(
  ({ version }) => post({ kind: "ready", version, policy }),
  (error: unknown) => post({ kind: "failed", why: wordsOf(error) }),
);

/// Whether an address is there: that of an empty script. A worker that computes hears no messages, but it can load.
function isThere(address: string): boolean {
  try {
    (self as unknown as { importScripts(url: string): void }).importScripts(address);
    return true;
  } catch {
    return false;
  }
}

async function map({ name, bytes, settings, permit }: MapJob): Promise<void> {
  const sp = await core;
  const start = performance.now();
  const { triangulate, ...options } = settings;
  const mesh = sp.readMesh(name, bytes, { triangulate });
  post({ kind: "mesh", mesh });
  const read = (performance.now() - start) / 1000;
  let told = start;
  let asked = start;
  const canAsk = isThere(permit); // not in a page from a disk
  const progress = (fraction: number) => {
    const now = performance.now();
    if (now - told > 100) { // since the page is drawn again for each
      told = now;
      post({ kind: "progress", fraction });
    }
    if (!canAsk || now - asked < 200) return true;
    asked = now;
    return isThere(permit);
  };
  const { valid, error, detail, seconds, ...result } = sp.parameterize(mesh.points, mesh.triangles, { ...options, progress });
  const measures = result.sphere && sp.measure(mesh.points, mesh.triangles, result.sphere);
  const answer: Answer = {
    ...result,
    ...measures,
    input: name,
    vertices: mesh.points.length / 3,
    faces: mesh.triangles.length / 3,
    fallback_reason: result.fallback_reason || null,
    ...(seconds && { seconds: { ...seconds, read: seconds.read + read, total: seconds.total + read } }),
    error: valid ? null : [name, error, detail].filter(Boolean).join(": "),
  };
  const arrays = Object.values(answer).filter((x): x is Float64Array => ArrayBuffer.isView(x));
  post({ kind: "answer", answer }, arrays.map((a) => a.buffer));
}

self.onmessage = async ({ data: job }: MessageEvent<Job>) => {
  try {
    if ("bytes" in job) return await map(job);
    const { mesh, sphere } = job;
    post({ kind: "segments", segments: (await core).segment(mesh.points, mesh.triangles, sphere) });
  } catch (error) {
    if (error instanceof MeshError)
      post(
        "bytes" in job
          ? { kind: "answer", answer: { input: job.name, error: error.message, error_code: error.code } }
          : { kind: "segments", why: error.message },
      );
    else post({ kind: "failed", why: wordsOf(error) });
  }
};
