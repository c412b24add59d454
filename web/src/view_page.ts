// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The script of the files that the command `view` writes: the data are in the page.

import type { Model, Report } from "./model";
import { Stage } from "./stage";

/// What the tool writes besides the report (src/commands/view_command.cpp): arrays one after the other, little-endian,
/// as base64. Coordinates and measures are whole numbers; here is what they stand for.
interface Header {
  report: Report;
  low: number[]; // corner of the box of the mesh
  step: number[]; // what 1 stands for, along each axis
  stretch: [number, number]; // what 0 stands for, and what 1 stands for
  angle: [number, number];
}

class Reader {
  private readonly bytes: Uint8Array;
  private at = 0;
  constructor(base64: string) {
    this.bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  }
  /// `n` numbers of 2 bytes, or of 4
  take(n: number, size: 2 | 4, signed = false): Uint16Array | Int16Array | Uint32Array {
    const bytes = this.bytes.slice(this.at, (this.at += n * size));
    return size === 4 ? new Uint32Array(bytes.buffer) : signed ? new Int16Array(bytes.buffer) : new Uint16Array(bytes.buffer);
  }
}

function read(): Model {
  const header = JSON.parse(document.getElementById("header")!.textContent!) as Header;
  const data = new Reader(document.getElementById("data")!.textContent!.trim());
  const n = header.report.vertices!;
  const m = header.report.faces!;
  const points = Float32Array.from(data.take(3 * n, 2), (x, i) => header.low[i % 3]! + header.step[i % 3]! * x);
  const sphere = Float32Array.from(data.take(3 * n, 2, true), (x) => x / 32767);
  const triangles = Int32Array.from(data.take(3 * m, n < 65536 ? 2 : 4));
  const measure = ([low, step]: [number, number]) => Float32Array.from(data.take(m, 2), (x) => low + step * x);
  const stretch = measure(header.stretch);
  const angle = measure(header.angle);
  return { points, sphere, triangles, stretch, angle, segments: Int32Array.from(data.take(m, 2)), report: header.report };
}

const model = read();
document.getElementById("file-name")!.textContent = model.report.input;
document.title = `${model.report.input} on the sphere`;
const stage = new Stage();
stage.show(model);
stage.say(model);
document.body.dataset.state = "shown";
Object.assign(window, { page: { stage } });
