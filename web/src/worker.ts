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
  area_exponent: number;
  triangulate: boolean;
}

/// A file to map, or the wish for the segments of the last one.
export type Job = MapJob | "segments";
export interface MapJob {
  name: string;
  bytes: Uint8Array;
  settings: Settings;
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

async function map({ name, bytes, settings }: MapJob): Promise<void> {
  const { mapFile } = await core;
  const start = performance.now();
  let told = start;
  const hear = (what: string, payload: unknown) => {
    if (what === "mesh") {
      const mesh = payload as Mesh;
      post({ kind: "mesh", mesh }, [mesh.points.buffer, mesh.triangles.buffer]);
    } else if (performance.now() - told > 30) {
      told = performance.now();
      post({ kind: "progress", fraction: payload as number });
    }
    return true;
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
