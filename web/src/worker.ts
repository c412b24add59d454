// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Runs the compiled core away from the page, so that this never waits for it.

import createCore from "core";

import type { Mesh, Report } from "./model";

/// How to map, by the names of the tool's options.
export interface Settings {
  weights: "conformal" | "clamped" | "barycentric" | "mean-value";
  method: "balanced" | "automatic" | "isometric" | "saddle-point";
  spring_exponent: number;
  area_exponent: number;
  triangulate: boolean;
}

/// A file to map, or the wish for the segments of the last one.
export type Job = MapJob | "segments";
export interface MapJob {
  name: string;
  bytes: Uint8Array;
  settings: Settings;
  permit: string; // an address that is there as long as the job may go on
}

/// What `mapFile()` returns: a report with arrays.
export type Answer = Report & {
  sphere?: Float64Array;
  face_stretch?: Float64Array;
  face_angle_distortion?: Float64Array;
};

export type Message =
  | { kind: "ready"; version: string }
  | { kind: "mesh"; mesh: Mesh }
  | { kind: "progress"; fraction: number }
  | { kind: "answer"; answer: Answer; total: number }
  | { kind: "segments"; segments: Int32Array | undefined }
  | { kind: "failed"; why: string };

const post = (message: Message, transfer: Transferable[] = []) =>
  (self as unknown as { postMessage(m: Message, t: Transferable[]): void }).postMessage(message, transfer);

const core = createCore();
core.then(
  ({ version }) => post({ kind: "ready", version }),
  (error: unknown) => post({ kind: "failed", why: String(error) }),
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
  const { mapFile } = await core;
  const start = performance.now();
  let told = start;
  let asked = start;
  const canAsk = isThere(permit); // not in a page from a disk
  const hear = (what: string, payload: unknown) => {
    if (what === "mesh") {
      const mesh = payload as Mesh;
      post({ kind: "mesh", mesh }, [mesh.points.buffer, mesh.triangles.buffer]);
    } else if (performance.now() - told > 30) {
      told = performance.now();
      post({ kind: "progress", fraction: payload as number });
    }
    if (!canAsk || performance.now() - asked < 200) return true;
    asked = performance.now();
    return isThere(permit);
  };
  const answer = mapFile(name, bytes, settings, hear);
  const arrays = Object.values(answer).filter((x): x is Float64Array => ArrayBuffer.isView(x));
  post({ kind: "answer", answer, total: (performance.now() - start) / 1000 }, arrays.map((a) => a.buffer));
}

self.onmessage = async ({ data: job }: MessageEvent<Job>) => {
  try {
    if (job === "segments") post({ kind: "segments", segments: (await core).segmentLast() });
    else await map(job);
  } catch (error) {
    post({ kind: "failed", why: error instanceof Error ? error.message : String(error) });
  }
};
