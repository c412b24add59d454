// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// What stands beside the views: the certificate in words, the legend, the histogram, the times.

import { colourAt, type Colouring, type Legend } from "./colours";
import { faceAreas, type Coordinates, type Model, type Report, type Way } from "./model";

/// An element with attributes and children.
export function element(
  tag: string,
  attributes: Record<string, string> = {},
  ...children: (Node | string)[]
): HTMLElement {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

export const whole = (n: number) => n.toLocaleString("en");
const figures = (x: number) => (x === 0 ? "0" : Math.abs(x) >= 0.01 ? x.toPrecision(3) : x.toExponential(1));
export const duration = (s: number) =>
  s < 0.0095 ? `${(1000 * s).toFixed(1)} ms` : s < 1 ? `${Math.round(1000 * s)} ms` : `${s.toFixed(2)} s`;

/// The verdict, a heading and a sentence or two.
export function certificate(report: Report): HTMLElement {
  if (report.error !== null && report.flipped_faces == null)
    return element(
      "div",
      { class: "certificate refused", id: "certificate", "data-code": report.error_code },
      element("h2", {}, report.error_code === "INTERRUPTED" ? "Cancelled" : "Refused"),
      element("p", {}, report.error),
    );
  const counts = `${whole(report.flipped_faces ?? 0)} of ${whole(report.faces ?? 0)} faces flipped, degree ${report.degree}`;
  if (report.error === null)
    return element(
      "div",
      { class: "certificate good", id: "certificate", "data-code": "OK" },
      element("h2", {}, "Certified"),
      element("p", { class: "counts" }, `${counts}.`),
      element("p", {}, "Every point of the surface has exactly one position on the sphere, and no two points have the same. Exact predicates have checked this on the stored coordinates."),
    );
  const isCancelled = report.error_code === "INTERRUPTED";
  return element(
    "div",
    { class: "certificate bad", id: "certificate", "data-code": report.error_code },
    element("h2", {}, isCancelled ? "Cancelled: the best map so far" : "Not certified"),
    element("p", { class: "counts" }, `${counts}.`),
    element("p", {}, isCancelled ? `After ${whole(report.iterations ?? 0)} iterations, at a residual of ${figures(report.residual ?? 0)}.` : report.error),
    ...(isCancelled || report.method === "automatic" || report.method === "isometric"
      ? []
      : [element("p", {}, "The method Automatic tries another method if one fails.")]),
  );
}

/// How good the way from one mesh to another one is.
export function ofWay({ names, text, isGood }: Way): HTMLElement {
  const [work, ...lines] = text.split("\n");
  return element(
    "div",
    { class: `certificate ${isGood ? "good" : "bad"}`, id: "certificate" },
    element("h2", {}, isGood ? "All of it arrives" : "Look closely"),
    element("p", {}, `${names[0]}, A, takes the shape of ${names[1]}, B, with its own vertices and faces.`),
    ...lines.map((line) => element("p", {}, line[0]!.toUpperCase() + line.slice(1) + ".")),
    details("How it was found", element("p", {}, work!)),
  );
}

/// What only those open who want to know.
const details = (summary: string, ...children: Node[]) =>
  element("details", {}, element("summary", {}, summary), ...children);

/// Sizes, method and time; how the map was computed.
export function facts(report: Report): HTMLElement {
  const list = element("dl", { class: "facts" });
  const work = element("dl", { class: "facts" });
  const add = (to: HTMLElement, term: string, text: string | null | undefined) => {
    if (text) to.append(element("dt", {}, term), element("dd", {}, text));
  };
  add(list, "Vertices", report.vertices == null ? "" : whole(report.vertices));
  add(list, "Faces", report.faces == null ? "" : whole(report.faces));
  if (report.method_used) {
    const weights = report.method_used === "isometric" ? "" : `, ${report.weights} weights`;
    add(list, "Method", report.method_used + weights);
    add(work, "Iterations", `${report.start_iterations} for the start map, ${report.iterations} from there`);
    add(work, "Residual", report.residual == null ? "" : figures(report.residual));
  }
  add(work, "Tried before", report.fallback_reason);
  const phases = { read: "Reading", weights: "Weights", start_map: "Start map", solve: "Solving", certify: "Certifying" };
  const s = report.seconds;
  if (s) {
    const sum = Object.keys(phases).reduce((total, name) => total + (s[name] ?? 0), 0);
    list.append(element("dt", {}, "Time"), element("dd", { id: "time", "data-seconds": String(sum) }, duration(sum)));
    for (const [name, term] of Object.entries(phases)) add(work, term, s[name] ? duration(s[name]) : ""); // of a given map only some
  }
  return element("div", {}, list, ...(work.childElementCount > 0 ? [details("How it was computed", work)] : []));
}

const css = (c: readonly number[]) => `rgb(${c.map(Math.round).join(" ")})`;

const meaning: Partial<Record<Colouring, string>> = {
  stretch: "The factor by which the map shrinks (red) or enlarges (blue) areas, relative to the mean.",
  angle: "The mean change of the angles of a face, in degrees.",
  segments: "Body and limbs, cut where the stretch rises.",
  checker: "Squares of the same size on the sphere, mapped back to the mesh.",
};

const asFactor = (x: number) => {
  const f = Math.exp(Math.abs(x));
  const text = f < 10 ? f.toFixed(1) : f < 1e5 ? whole(Math.round(f)) : f.toExponential(0).replace("e+", "e");
  return x < 0 ? `× ${text}` : `÷ ${text}`;
};
const asDegrees = (x: number) => `${((x * 180) / Math.PI).toFixed(1)}°`;

/// What the colours mean, with a histogram over the scale: shares of the area of the mesh.
export function legendPanel(model: Model, colouring: Colouring, legend: Legend | null): HTMLElement {
  const values = colouring === "stretch" ? model.stretch : colouring === "angle" ? model.angle : undefined;
  const panel = element("div", { class: "legend", id: "legend" });
  if (meaning[colouring] && model.sphere) panel.append(element("p", {}, meaning[colouring]!));
  if (colouring === "segments" && model.segments) {
    const number = model.segments.reduce((a, b) => Math.max(a, b), 0) + 1;
    panel.append(element("p", {}, `${number} ${number === 1 ? "segment" : "segments"}.`));
  }
  if (colouring === "segments" && model.unsegmented) panel.append(element("p", {}, `There are none: ${model.unsegmented}.`));
  if (!values || !legend) return panel;
  panel.append(histogram(model, values, legend));
  const text = colouring === "stretch" ? asFactor : asDegrees;
  panel.append(
    element(
      "div",
      { class: "ends" },
      element("span", {}, text(legend.low)),
      element("span", {}, colouring === "stretch" ? "× 1" : text(legend.high / 2)),
      element("span", {}, text(legend.high)),
    ),
  );
  return panel;
}

function histogram(model: Model, values: Coordinates, legend: Legend): Element {
  const bins = new Float64Array(40);
  const areas = faceAreas(model);
  let total = 0;
  values.forEach((value: number, f: number) => {
    const bin = Math.min(bins.length - 1, Math.max(0, Math.floor(legend.at(value) * bins.length)));
    bins[bin]! += areas[f]!;
    total += areas[f]!;
  });
  const highest = Math.max(...bins) || 1;
  const svgOf = (tag: string, attributes: Record<string, string | number>) => {
    const e = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) e.setAttribute(name, String(value));
    return e;
  };
  const svg = svgOf("svg", {
    viewBox: "0 0 240 74",
    class: "histogram",
    id: "histogram",
    role: "img",
    "aria-label": "Histogram: share of the area of the mesh over the scale of colours",
  });
  const width = 240 / bins.length;
  bins.forEach((area, i) => {
    const height = (60 * area) / highest;
    const bar = svgOf("rect", {
      x: i * width + 0.4,
      y: 62 - height,
      width: width - 0.8,
      height,
      fill: css(colourAt(legend.scale, (i + 0.5) / bins.length)),
    });
    const title = svgOf("title", {});
    title.textContent = `${((100 * area) / total).toFixed(1)} % of the area`;
    bar.append(title);
    svg.append(bar);
  });
  for (let i = 0; i < 60; ++i)
    svg.append(svgOf("rect", { x: 4 * i, y: 65, width: 4.2, height: 9, fill: css(colourAt(legend.scale, (i + 0.5) / 60)) }));
  return svg;
}

/// What is known of a face, in one line.
export function describe(model: Model, face: number): string {
  const parts = [`face ${whole(face)}`];
  if (model.stretch) parts.push(`area ${asFactor(model.stretch[face]!)}`);
  if (model.angle) parts.push(`angles ${asDegrees(model.angle[face]!)}`);
  if (model.segments) parts.push(`segment ${model.segments[face]}`);
  return parts.join(" · ");
}
