// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The script of the files that the command `view` writes: the data are in the page.

import type { Model, Report } from "./model";
import { Stage } from "./stage";

/// What a measure or a coordinate is: what 0 stands for, and one step.
type Scale = [number, number];

/// What the tool writes (src/runner/page.h) besides whole numbers, the lowest byte first, as base64: x, y and z of the mesh and
/// of the sphere, measures of the faces (src/steps/view.cpp); or x, y and z of several shapes of a mesh (src/steps/morph.cpp).
/// Then the corners of the faces.
interface Header {
  coordinates: Scale[];
  report?: Report;
  stretch: Scale;
  angle: Scale;
  segments: Scale;
  vertices: number;
  faces: number;
  text: string; // on the registration
  registration: { inputs: [string, string]; share_of_large_changes: number; trust: string };
}

const base = (path: string) => path.replace(/.*[\\/]/, "");

function read(): Model {
  const { report, ...header } = JSON.parse(document.getElementById("header")!.textContent!) as Header;
  const base64 = document.getElementById("data")!.textContent!.trim();
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  let at = 0;
  const scaled = (n: number, [low, step]: Scale) =>
    Float64Array.from({ length: n }, () => low + step * (bytes[at++]! | (bytes[at++]! << 8)));
  const [n, m] = [report?.vertices ?? header.vertices, report?.faces ?? header.faces];
  const planes = header.coordinates.map((scale) => scaled(n, scale));
  const shapes = Array.from({ length: planes.length / 3 }, (_, s) =>
    Float64Array.from({ length: 3 * n }, (_, i) => planes[3 * s + (i % 3)]![Math.floor(i / 3)]!),
  );
  const ofFaces = () => ({
    stretch: scaled(m, header.stretch),
    angle: scaled(m, header.angle),
    segments: Int32Array.from(scaled(m, header.segments), Math.round),
  });
  const measures = report && ofFaces();
  const triangles = Int32Array.from({ length: 3 * m }, () => bytes[at++]! | (bytes[at++]! << 8) | (bytes[at++]! << 16));
  const points = shapes[0]!;
  if (report) return { points, triangles, sphere: shapes[1]!, ...measures, report: { ...report, input: base(report.input) } };
  const { inputs, share_of_large_changes, trust } = header.registration;
  const isGood = share_of_large_changes < 0.02 && !["unsure", "unlike"].includes(trust);
  return {
    points,
    triangles,
    way: { shapes, names: [base(inputs[0]), base(inputs[1])], text: header.text, isGood },
    report: { input: `${base(inputs[0])} to ${base(inputs[1])}`, vertices: n, faces: m, error: null, error_code: "OK" },
  };
}

const model = read();
document.getElementById("file-name")!.textContent = model.report.input;
document.title = model.way ? model.report.input : `${model.report.input} on the sphere`;
const stage = new Stage();
stage.show(model);
stage.say(model);
if (model.way && !matchMedia("(prefers-reduced-motion: reduce)").matches) stage.viewer.play();
document.body.dataset.state = "shown";
Object.assign(window, { page: { stage } });
