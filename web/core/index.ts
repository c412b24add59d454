// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The npm package `spherical-parameterization`, which the page uses, too.

import createCore from "core";

/** Coordinates of points, three numbers each: x0, y0, z0, x1, ... */
export type Coordinates = Float64Array | Float32Array;

/** Numbers of points, three per triangle, from 0 on, counterclockwise as seen from outside. */
export type Triangles = Int32Array | Uint32Array;

/** How to map. What is not given has the default of the command-line tool and of the Python package. */
export interface Options {
  /** Default: `"automatic"`, which tries the others in turn until a map is good. */
  method?: "automatic" | "balanced" | "isometric" | "saddle-point";
  /** Weights of the edges. Default: `"conformal"`. */
  weights?: "conformal" | "clamped" | "barycentric" | "mean-value";
  /** Of balanced maps: 2, the default, keeps angles, and more equalizes areas. */
  spring_exponent?: number;
  /** Of isometric maps: 0 keeps angles, 1, the default, both angles and areas, and 30 areas. */
  area_exponent?: number;
  /** What the residual has to come down to. Default: that of the method. */
  accuracy?: number;
  /** The most iterations. Default: those of the method. */
  iterations?: number;
  /** Seconds after which the best map so far is returned. Default: no limit. */
  maximum_running_time?: number;
  /** Is called with the share of the work that is done, from 0 to 1. `false` ends the work: the best map so far is returned. */
  progress?: (share: number) => boolean | void;
}

/** What `parameterize()` returns. The names are those of the tool's report. */
export interface Result {
  /** Whether the map is a bijection: certified by exact predicates on `sphere`, as it is here. */
  valid: boolean;
  /** `"OK"` if and only if the map is valid; else, for instance, `"BOUNDARY"`, `"WRONG_GENUS"` or `"INTERRUPTED"`. */
  error_code: string;
  /** What is wrong, in words; empty if `"OK"`. */
  error: string;
  /** Where it is, and what to do about it. */
  detail: string;
  /** Why the method ended; absent if nothing was computed. */
  termination?: "converged" | "iterations" | "time" | "callback" | "stalled";
  /** Unit vectors, three numbers per point, in the order of the points. Like all below, absent if there is no map. */
  sphere?: Float64Array;
  /** Faces that are turned over, or have no area, as seen from the middle of the sphere. */
  flipped_faces?: number;
  /** How often the map covers the sphere; 1 of a valid one. */
  degree?: number;
  /** The method of the map. */
  method_used?: string;
  /** Of `"automatic"`: why it is not the map of a method before; else empty. */
  fallback_reason?: string;
  /** Iterations for the start map, those of the method, and its sweeps. */
  start_iterations?: number;
  iterations?: number;
  sweeps?: number;
  /** Of the equation that the method solves. */
  residual?: number;
  /** Spring energy; of isometric maps the mean distortion. */
  energy?: number;
  /** Vertices that were moved from where the springs pull them, for the sake of their faces. */
  moved_vertices?: number;
  /** Of all spherical triangles, in steradians. */
  smallest_area?: number;
  /** Length of the shortest edge on the sphere, in units of 2^-52. */
  smallest_edge?: number;
  /** Of every phase. */
  seconds?: { read: number; weights: number; start_map: number; solve: number; certify: number; total: number };
}

/** A distribution, of which every face has a share by its area. */
export interface Distribution {
  mean: number;
  standard_deviation: number;
  min: number;
  percentile_1: number;
  percentile_5: number;
  median: number;
  percentile_95: number;
  percentile_99: number;
  max: number;
}

/** What a map does to angles and areas. */
export interface Measures {
  distortion: {
    /** Logarithm of (area on the mesh / area on the sphere), both of total 1. */
    log_area_stretch: Distribution;
    /** In radians. */
    angle_distortion: Distribution;
    /** Quasi-conformal dilatation, from 1 on. */
    dilatation: Distribution;
    /** Symmetric Dirichlet energy, with chords and with the sphere; from 4 on. */
    symmetric_dirichlet: Distribution;
    spherical_symmetric_dirichlet: Distribution;
    degenerate_faces: number;
  };
  /** Of every face: logarithm of the area stretch. */
  face_stretch: Float64Array;
  /** Of every face, in radians. */
  face_angle_distortion: Float64Array;
}

export interface Mesh {
  points: Float64Array;
  triangles: Int32Array;
}

/** Data that are no mesh, or no sphere: what is wrong is the message. */
export class MeshError extends Error {
  override readonly name = "MeshError";
  constructor(
    /** As in `Result.error_code`, or `"UNREADABLE_FILE"`. */
    readonly code: string,
    message: string,
  ) {
    super(message);
  }
}

export interface SphericalParameterization {
  /** Of the package. */
  readonly version: string;

  /**
   * Maps a closed triangle mesh of genus 0 to the unit sphere, with the same bits as the command-line tool. Data that
   * cannot be mapped are said in the result; wrong arguments are a TypeError or a RangeError.
   */
  parameterize(points: Coordinates, triangles: Triangles, options?: Options): Result;

  /** Measures a map. Throws a `MeshError`. */
  measure(points: Coordinates, triangles: Triangles, sphere: Coordinates): Measures;

  /** Cuts a mesh into a body and its limbs, where the area stretch of its map rises: the segment of every face. Throws a `MeshError`. */
  segment(points: Coordinates, triangles: Triangles, sphere: Coordinates): Int32Array;

  /**
   * Reads the bytes of a file, compressed with gzip or not: OFF, OBJ, PLY, STL, VTK, GIFTI, FreeSurfer, MNI and glTF. The
   * content decides about the format, and the name where that leaves it open. Throws a `MeshError`.
   */
  readMesh(name: string, bytes: Uint8Array, options?: { triangulate?: boolean }): Mesh;
}

/** What core.cpp has. */
interface Core {
  version: string;
  parameterize(points: Coordinates, triangles: Triangles, settings: object, goOn: (share: number) => boolean): Omit<Result, "valid">;
  measure(points: Coordinates, triangles: Triangles, sphere: Coordinates): Verdict & Measures;
  segment(points: Coordinates, triangles: Triangles, sphere: Coordinates): Verdict & { segments: Int32Array };
  readMesh(name: string, bytes: Uint8Array, triangulate: boolean): Verdict & Mesh;
}
type Verdict = Pick<Result, "error_code" | "error" | "detail">;

const words: Record<string, readonly string[]> = {
  method: ["automatic", "balanced", "isometric", "saddle-point"],
  weights: ["conformal", "clamped", "barycentric", "mean-value"],
};
const defaults = { method: "automatic", weights: "conformal", spring_exponent: 2, area_exponent: 1 };
const numbers = ["spring_exponent", "area_exponent", "accuracy", "iterations", "maximum_running_time"];

function checkType(array: unknown, name: string, types: string[]): void {
  const type = Object.prototype.toString.call(array).slice(8, -1); // also of another page
  if (!types.includes(type)) throw new TypeError(`${name} has to be a ${types.join(" or ")}, and is ${type}`);
}

function check(array: unknown, name: string, types: string[]): void {
  checkType(array, name, types);
  const { length } = array as ArrayLike<number>;
  if (length % 3 !== 0) throw new RangeError(`${name} has to have three numbers each, and has ${length}`);
}

function checkMesh(points: Coordinates, triangles: Triangles, sphere = points): void {
  check(points, "points", ["Float64Array", "Float32Array"]);
  check(triangles, "triangles", ["Int32Array", "Uint32Array"]);
  check(sphere, "sphere", ["Float64Array", "Float32Array"]);
  if (sphere.length !== points.length) throw new RangeError("sphere has to have as many points as the mesh");
}

function settingsOf(options: object): object {
  const settings: Record<string, unknown> = { ...defaults };
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined || name === "progress") continue;
    if (!Object.hasOwn(words, name) && !numbers.includes(name)) throw new TypeError(`there is no option '${name}'`);
    const choice = Object.hasOwn(words, name) ? words[name]! : null;
    if (choice?.includes(value) === false)
      throw new RangeError(`${name} has to be one of ${choice.join(", ")}, and is '${value}'`);
    if (numbers.includes(name) && typeof value !== "number") throw new TypeError(`${name} has to be a number`);
    if (name === "iterations" && !(Number.isInteger(value) && (value as number) >= 0))
      throw new RangeError(`${name} has to be an integer that is not negative`);
    settings[name] = value;
  }
  return settings;
}

/// The answer, unless an argument was wrong, or, where there is no verdict on a map to return, the data.
function sound<A extends Verdict>(answer: A): A {
  if (answer.error_code === "BAD_ARGUMENT") throw new RangeError(answer.error);
  return answer;
}
function needed<A extends Verdict>(answer: A): Omit<A, keyof Verdict> {
  const { error_code, error, detail, ...rest } = sound(answer);
  if (error_code !== "OK") throw new MeshError(error_code, [error, detail].filter(Boolean).join(": "));
  return rest;
}

/** Starts WebAssembly; every call gives a core with a memory of its own. */
export function load(): Promise<SphericalParameterization> {
  return start(createCore);
}

/** @internal The same with another core: that of the page for all cores. */
export async function start(create: () => Promise<unknown>): Promise<SphericalParameterization> {
  const core = (await create()) as Core;
  return {
    version: core.version,
    parameterize(points, triangles, options = {}) {
      checkMesh(points, triangles);
      const goOn = (share: number) => options.progress?.(share) !== false;
      const answer = sound(core.parameterize(points, triangles, settingsOf(options), goOn));
      return { valid: answer.error_code === "OK", ...answer };
    },
    measure(points, triangles, sphere) {
      checkMesh(points, triangles, sphere);
      return needed(core.measure(points, triangles, sphere));
    },
    segment(points, triangles, sphere) {
      checkMesh(points, triangles, sphere);
      return needed(core.segment(points, triangles, sphere)).segments;
    },
    readMesh(name, bytes, options = {}) {
      if (typeof name !== "string") throw new TypeError("name has to be a string");
      checkType(bytes, "bytes", ["Uint8Array"]);
      if (bytes.length >= 2 ** 31) // beyond which the heap breaks
        throw new MeshError("OUT_OF_MEMORY", `${name}: there is not enough memory: WebAssembly takes files below 2 GB; use the command-line tool`);
      for (const [option, value] of Object.entries(options))
        if (option !== "triangulate" || !["boolean", "undefined"].includes(typeof value))
          throw new TypeError("options has to be { triangulate: true or false }");
      const ours = bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes); // of another page, it is unknown here
      return needed(core.readMesh(name, ours, options.triangulate ?? false));
    },
  };
}
