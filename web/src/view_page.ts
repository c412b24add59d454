// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The script of the files that the command `view` writes: the data are in the page.

import type { Model, Report } from "./model";
import { Stage } from "./stage";

/// What a measure or a coordinate is: what 0 stands for, and what 1 stands for.
type Scale = [number, number];

/// What the tool writes (src/steps/view.cpp) besides whole numbers, the lowest byte first, as base64: x, y and
/// z of the mesh and of the sphere, measures of the faces, and their corners.
interface Header {
  report: Report;
  coordinates: Scale[]; // six
  stretch: Scale;
  angle: Scale;
  segments: Scale;
}

function read(): Model {
  const { report, ...header } = JSON.parse(document.getElementById("header")!.textContent!) as Header;
  const base64 = document.getElementById("data")!.textContent!.trim();
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  let at = 0;
  const scaled = (n: number, [low, step]: Scale) =>
    Float32Array.from({ length: n }, () => low + step * (bytes[at++]! | (bytes[at++]! << 8)));
  const [n, m] = [report.vertices!, report.faces!];
  const planes = header.coordinates.map((scale) => scaled(n, scale));
  const points = Float32Array.from({ length: 3 * n }, (_, i) => planes[i % 3]![Math.floor(i / 3)]!);
  const sphere = Float32Array.from({ length: 3 * n }, (_, i) => planes[3 + (i % 3)]![Math.floor(i / 3)]!);
  const stretch = scaled(m, header.stretch);
  const angle = scaled(m, header.angle);
  const segments = Int32Array.from(scaled(m, header.segments), Math.round);
  const triangles = Int32Array.from({ length: 3 * m }, () => bytes[at++]! | (bytes[at++]! << 8) | (bytes[at++]! << 16));
  report.input = report.input.replace(/.*[\\/]/, "");
  return { points, sphere, triangles, stretch, angle, segments, report };
}

const model = read();
document.getElementById("file-name")!.textContent = model.report.input;
document.title = `${model.report.input} on the sphere`;
const stage = new Stage();
stage.show(model);
stage.say(model);
document.body.dataset.state = "shown";
Object.assign(window, { page: { stage } });
