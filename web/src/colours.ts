// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

import { meanOverFaces, quantiles, type Model } from "./model";

export type Colour = [number, number, number]; // 0 to 255

/// What the colours mean.
export const colourings = ["stretch", "angle", "segments", "checker", "plain"] as const;
export type Colouring = (typeof colourings)[number];

export const nameOf: Record<Colouring, string> = {
  stretch: "Area stretch",
  angle: "Angle distortion",
  segments: "Segments",
  checker: "Checker",
  plain: "Plain",
};

type Scale = readonly Colour[];

/// K. Moreland, "Diverging color maps for scientific visualization", 2009: that of the tool.
const diverging: Scale = [
  [59, 76, 192],
  [141, 176, 254],
  [221, 221, 221],
  [244, 154, 123],
  [180, 4, 38],
];
/// From light to dark, for values from 0 on.
const sequential: Scale = [
  [240, 240, 226],
  [190, 216, 180],
  [94, 174, 160],
  [36, 118, 140],
  [22, 56, 94],
];

/// `t` in [0, 1]
export function colourAt(scale: Scale, t: number): Colour {
  const place = Math.min(1, Math.max(0, t)) * (scale.length - 1);
  const below = Math.min(Math.floor(place), scale.length - 2);
  const share = place - below;
  const [a, b] = [scale[below]!, scale[below + 1]!];
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])];
}

/// Hues by the golden ratio, as the tool has them.
export function colourOfSegment(segment: number): Colour {
  const hue = (0.58 + 0.61803398874989485 * segment) % 1;
  const light = [0.95, 0.75, 0.55][segment % 3]!;
  const saturation = segment % 2 === 0 ? 0.55 : 0.8;
  return [0, 1, 2].map((k) => {
    const distance = (((hue - k / 3) % 1) + 1) % 1;
    const pure = Math.min(1, Math.max(0, 2 - 6 * Math.min(distance, 1 - distance)));
    return Math.round(255 * light * (1 - saturation * (1 - pure)));
  }) as Colour;
}

const plain: Colour = [205, 203, 196];

/// The values that are shown, and what their ends are.
export interface Legend {
  scale: Scale;
  low: number;
  high: number;
  at(value: number): number; // place on the scale, 0 to 1
}

/// The scale ends at quantiles, or a few vertices at the tips of limbs would leave everything else white. Either side
/// of the stretch has its own, as in the tool.
function legendOf(colouring: Colouring, values: ArrayLike<number>): Legend | null {
  const [least, most] = quantiles(values, [0.02, 0.98]) as [number, number];
  if (colouring === "stretch") {
    const low = Math.min(least, -1e-3);
    const high = Math.max(most, 1e-3);
    return { scale: diverging, low, high, at: (x) => 0.5 + (x < 0 ? -x / low : x / high) / 2 };
  }
  if (colouring === "angle") {
    const high = Math.max(most, 1e-3);
    return { scale: sequential, low: 0, high, at: (x) => x / high };
  }
  return null;
}

export interface Colours {
  ofVertex(v: number, face: number): Colour;
  legend: Legend | null;
}

/// The colours of a model. Those of vertices are means over their faces; segments have one per face.
export function coloursOf(model: Model, colouring: Colouring): Colours {
  const values = colouring === "stretch" ? model.stretch : colouring === "angle" ? model.angle : undefined;
  if (values) {
    const ofVertices = meanOverFaces(model, values);
    const legend = legendOf(colouring, ofVertices)!;
    return { legend, ofVertex: (v) => colourAt(legend.scale, legend.at(ofVertices[v]!)) };
  }
  if (colouring === "segments" && model.segments) {
    const segments = model.segments;
    const palette = Array.from({ length: segments.reduce((a, b) => Math.max(a, b), 0) + 1 }, (_, i) =>
      colourOfSegment(i),
    );
    return { legend: null, ofVertex: (_, face) => palette[segments[face]!]! };
  }
  const { sphere } = model;
  if (colouring === "checker" && sphere)
    return { legend: null, ofVertex: (v) => (isDark(sphere[3 * v]!, sphere[3 * v + 1]!, sphere[3 * v + 2]!) ? darkField : lightField) };
  return { legend: null, ofVertex: () => plain };
}

/// Of the checker; the shader of the viewer has the same.
const darkField: Colour = [41, 77, 107];
const lightField: Colour = [237, 232, 219];

/// Whether a direction is on a dark field of the checker: eight fields along every edge of the cube on which the
/// sphere is projected. The shader of the viewer has the same formula.
export function isDark(x: number, y: number, z: number): boolean {
  const size = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const axis = size.indexOf(Math.max(...size));
  const [u, v, w] = axis === 0 ? [y, z, x] : axis === 1 ? [z, x, y] : [x, y, z];
  const cell = (a: number) => Math.floor((Math.atan(a / Math.abs(w!)) * 4) / Math.PI * 4);
  return (cell(u!) + cell(v!)) % 2 !== 0;
}
