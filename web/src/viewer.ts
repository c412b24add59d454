// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Two linked views on one canvas: the mesh, which a slider morphs into the sphere, and the sphere. Or one view, of a mesh that
// the slider leads through several shapes.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  GLSL3,
  LineSegments,
  Mesh as Shape,
  PerspectiveCamera,
  Points,
  Quaternion,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  WebGLRenderTarget,
  WebGLRenderer,
} from "three";

import { coloursOf, type Colouring, type Legend } from "./colours";
import { forEachFace, normalsOf, type Coordinates, type Mesh, type Model } from "./model";
import { coarsened, localOrder } from "./order";
import { refined } from "./refine";
import { bestRotation } from "./rotation";
import type { Trouble } from "./topology";

const morphing = /* glsl */ `
  in vec3 next;
  uniform float morph;
  vec3 place() { return mix(position, next, morph); }`;

// Lean: software renderers draw it, too.
const surfaceVertex = /* glsl */ `${morphing}
  in vec3 nextNormal;
  in vec3 paint;
  out vec3 vNormal;
  #ifdef CHECKER
  out vec3 vSphere;
  #else
  out vec3 vPaint;
  #endif
  void main() {
  #ifdef CHECKER
    vSphere = next;
  #else
    vPaint = paint;
  #endif
    vNormal = normalMatrix * mix(normal, nextNormal, morph);
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place(), 1.0);
  }`;

// The checker is that of isDark() in colours.ts.
const surfaceFragment = /* glsl */ `
  in vec3 vNormal;
  out vec4 colour;
  #ifdef CHECKER
  in vec3 vSphere;
  float wave(float a, float width) { // a field is dark where it is negative; as sharp as the screen
    float t = abs(fract(a / 2.0) - 0.5) * 2.0 - 0.5;
    return clamp(t / width, -1.0, 1.0);
  }
  vec3 paint() {
    vec3 s = abs(vSphere);
    vec3 d = s.x >= s.y && s.x >= s.z ? vec3(vSphere.yz, s.x) : s.y >= s.z ? vec3(vSphere.zx, s.y) : vec3(vSphere.xy, s.z);
    vec2 cell = atan(d.xy / d.z) * (16.0 / 3.14159265);
    float width = max(5.0 * length(fwidth(vSphere)), 1e-5);
    float light = 0.5 + 0.5 * wave(cell.x + 0.5, width) * wave(cell.y + 0.5, width);
    return mix(vec3(0.16, 0.30, 0.42), vec3(0.93, 0.91, 0.86), light);
  }
  #else
  in vec3 vPaint;
  vec3 paint() { return vPaint; }
  #endif
  void main() {
    vec3 n = normalize(vNormal);
    n = n.z < 0.0 ? -n : n;
    float key = max(0.0, dot(n, vec3(-0.413, 0.597, 0.688)));
    float fill = max(0.0, dot(n, vec3(0.889, -0.111, 0.444)));
    float gloss = max(0.0, dot(n, vec3(-0.225, 0.325, 0.919))); // half way between key light and eye
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    float rim = 1.0 - n.z;
    colour = vec4(paint() * (0.42 + 0.56 * key + 0.20 * fill - 0.10 * rim * rim) + 0.08 * gloss * gloss, 1.0);
  }`;

// The last corner of a triangle decides about flat values: so the pixel names that corner.
const pickVertex = /* glsl */ `${morphing}
  flat out int id;
  void main() {
    id = gl_VertexID + 1;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place(), 1.0);
  }`;
const pickFragment = /* glsl */ `
  flat in int id;
  out vec4 colour;
  void main() {
    colour = vec4(ivec4(id, id >> 8, id >> 16, id >> 24) & 255) / 255.0;
  }`;

const markVertex = /* glsl */ `${morphing}
  uniform float size;
  uniform vec2 offset; // in pixels
  uniform vec2 pixel;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place(), 1.0);
    gl_Position.xy += offset * pixel * gl_Position.w;
    gl_Position.z -= 0.0008 * gl_Position.w; // before the surface
    gl_PointSize = size;
  }`;
const markFragment = /* glsl */ `
  uniform vec3 tint;
  uniform float opacity;
  out vec4 colour;
  void main() { colour = vec4(tint, opacity); }`;
const ringFragment = /* glsl */ `
  uniform vec3 tint;
  uniform float size;
  out vec4 colour;
  void main() {
    float r = length(gl_PointCoord - 0.5) * size;
    float ring = smoothstep(1.6, 0.6, abs(r - size * 0.5 + 2.5));
    float halo = smoothstep(3.0, 1.2, abs(r - size * 0.5 + 2.5));
    colour = vec4(mix(vec3(0.0), tint, ring), max(ring, 0.55 * halo));
    if (colour.a < 0.02) discard;
  }`;

/// Pixels per CSS pixel where software draws what moves.
const coarse = 0.75;

interface View {
  x: number; // of the canvas, in CSS pixels, from above
  y: number;
  width: number;
  height: number;
}

/// A shape of the mesh: places and normals of the vertices that are drawn.
interface Shaped {
  place: BufferAttribute;
  normal: BufferAttribute;
}

/// Both places of a face, and its number.
export interface Hover {
  face: number;
  onSphere: boolean; // where the pointer is
}

export class Viewer {
  onHover: (hover: Hover | null) => void = () => {};
  onMorph: (morph: number) => void = () => {};
  onViews: (views: View[]) => void = () => {};
  /// Seconds that the last frames took, for tests.
  readonly frames: number[] = [];

  private readonly renderer: WebGLRenderer | null; // null: the browser has no WebGL 2
  private readonly isSoftware: boolean;
  private readonly camera = new PerspectiveCamera(28, 1, 0.1, 60);
  private readonly scene = new Scene();
  private readonly pickScene = new Scene();
  private readonly target = new WebGLRenderTarget(1, 1);
  private readonly surface: ShaderMaterial;
  private readonly picking: ShaderMaterial;
  private readonly ring: ShaderMaterial;
  private readonly patch: ShaderMaterial;
  private readonly uniforms = {
    morph: { value: 0 },
    pixel: { value: new Vector2() }, // its size, where the view is 2 wide and high
  };

  private hasSphere = false;
  private isOutside = false; // which side the faces show
  private source = new Uint32Array(); // of the vertices that are drawn: their points of the mesh
  private halves = new Uint32Array(); // of more vertices behind them: the two between which each is
  private corners = new Uint32Array(); // of every part of a face: the three vertices that are drawn
  private faceOf = new Uint32Array(); // of every part: its face, in the order of the faces
  private firstPart = new Uint32Array(); // of every vertex that is drawn: the parts whose last corner it is
  private partOf = new Uint32Array();
  private shapes: Shaped[] = []; // through which the slider leads
  private shape: Shape | null = null;
  private marker: Points | null = null;
  private marked: Shape | null = null;
  private troubles: LineSegments[] = [];
  private faceOfVertex = new Uint32Array();

  private readonly ringSize = { value: 22 };
  private readonly rotation = new Quaternion();
  private across = 0; // radians about the vertical axis, in the first view
  private isZUp = false;
  private zoom = 1;
  private shift = new Vector2();
  private morph_ = 0;
  private needed = true;
  private pointer: { x: number; y: number } | null = null;
  private playing = 0; // direction
  private isToAndFro = false;
  private alone_ = false; // no place for a sphere
  private spinning = 0; // radians per second

  constructor(readonly canvas: HTMLCanvasElement) {
    this.isSoftware = /swiftshader|llvmpipe|software/i.test(nameOfRenderer());
    this.renderer = rendererOf(canvas, !this.isSoftware);
    const material = (vertexShader: string, fragmentShader: string, more = {}) =>
      new ShaderMaterial({ vertexShader, fragmentShader, glslVersion: GLSL3, side: DoubleSide, ...more });
    this.surface = material(surfaceVertex, surfaceFragment, { uniforms: this.uniforms });
    this.picking = material(pickVertex, pickFragment, { uniforms: this.uniforms });
    const tint = { value: new Color(1, 0.72, 0) };
    const offset = { value: new Vector2() };
    const size = this.ringSize;
    this.ring = material(markVertex, ringFragment, {
      uniforms: { ...this.uniforms, tint, size, offset },
      transparent: true,
      depthTest: false,
    });
    this.patch = material(markVertex, markFragment, {
      uniforms: { ...this.uniforms, tint: { value: new Color(1, 0.85, 0.1) }, size, offset, opacity: { value: 1 } },
    });
    this.resetView();
    this.listen();
    new ResizeObserver(() => this.redraw()).observe(canvas);
    canvas.addEventListener("webglcontextrestored", () => this.redraw());
    const loop = (time: number) => {
      this.step(time);
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
  }

  // --- what is shown

  get canDraw(): boolean {
    return this.renderer !== null;
  }

  /// The mesh alone, or with its sphere, or with other shapes of it.
  show(model: Model): void {
    this.clear();
    this.hasSphere = model.sphere !== undefined;
    this.isToAndFro = model.way !== undefined;
    this.split(model);
    const ofVertices = (rows: Coordinates, place = (x: number, _k: number) => x) => {
      const result = new Float32Array(3 * this.source.length);
      for (let v = 0; v < this.source.length; ++v)
        for (let k = 0; k < 3; ++k) result[3 * v + k] = place(rows[3 * this.source[v]! + k]!, k);
      return result;
    };
    const shapes = model.way?.shapes ?? [model.points];
    const { center, radius } = frameOf(shapes);
    const sphere = model.sphere && ofVertices(model.sphere);
    if (sphere) {
      const turn = bestRotation(model.points, center, model.sphere!);
      const q = new Vector3();
      for (let i = 0; i < sphere.length; i += 3) q.fromArray(sphere, i).applyMatrix3(turn).toArray(sphere, i);
      // what is not valid has long edges everywhere
      if (model.report.error === null) ({ corners: this.corners, faceOf: this.faceOf, halves: this.halves } = refined(this.corners, sphere));
    }
    const n = this.source.length + this.halves.length / 2;
    const attribute = (of: Float32Array, isSphere = false) => {
      const array = new Float32Array(3 * n);
      array.set(of);
      this.fillHalves(array, isSphere);
      return new BufferAttribute(array, 3);
    };
    this.shapes = shapes.map((points) => ({
      place: attribute(ofVertices(points, (x, k) => (x - center[k]!) / radius)),
      normal: attribute(ofVertices(normalsOf({ ...model, points }))),
    }));
    if (sphere) {
      const place = attribute(sphere, true);
      this.shapes.push({ place, normal: place });
    }
    this.indexParts();
    const geometry = new BufferGeometry();
    geometry.setAttribute("paint", new BufferAttribute(new Uint8Array(3 * n), 3, true));
    this.order(model, this.shapes[0]!.place.array as Float32Array);
    geometry.setIndex(this.ordered!.atRest);
    this.isOutside = this.shapes.length > 1 && !isInsideOut(model);
    this.shape = new Shape(geometry, this.surface);
    this.pose(this.morph_);
    const pick = new Shape(geometry, this.picking);
    for (const s of [this.shape, pick]) s.frustumCulled = false;
    this.scene.add(this.shape);
    this.pickScene.add(pick);
    this.mark(null);
    this.onHover(null);
    this.redraw();
  }

  /// Colours by `colouring`; returns what they mean.
  colour(model: Model, colouring: Colouring): Legend | null {
    if (!this.shape) return null;
    const colours = coloursOf(model, colouring);
    const paint = this.shape.geometry.getAttribute("paint") as BufferAttribute;
    for (let v = 0; v < this.source.length; ++v) {
      const colour = colours.ofVertex(this.source[v]!, this.faceOfVertex[v]!);
      for (let k = 0; k < 3; ++k) paint.array[3 * v + k] = colour[k]! + 0.5;
    }
    this.fillHalves(paint.array);
    paint.needsUpdate = true;
    const isChecker = colouring === "checker" && this.hasSphere;
    if (isChecker !== "CHECKER" in this.surface.defines) {
      this.surface.defines = isChecker ? { CHECKER: "" } : {};
      this.surface.needsUpdate = true;
    }
    this.redraw();
    return colours.legend;
  }

  /// Lines on the mesh where it is no sphere.
  markTroubles(troubles: Trouble[]): void {
    if (!this.shape) return;
    // Lines of WebGL are one pixel wide: more of them, beside each other. Faint where the surface hides them.
    for (const trouble of troubles)
      for (const depthTest of [false, true])
        for (const [x, y] of [[0, 0], [1, 0], [0, 1], [1, 1], [-1, 0], [0, -1]] as const) {
          const geometry = new BufferGeometry();
          for (const name of ["position", "next"]) geometry.setAttribute(name, this.shape.geometry.getAttribute(name));
          geometry.setIndex(new BufferAttribute(trouble.lines, 1));
          const material = this.patch.clone();
          material.uniforms = {
            ...this.uniforms,
            size: { value: 1 },
            offset: { value: new Vector2(x, y) },
            tint: { value: new Color(0.9, 0.05, 0.1) },
            opacity: { value: depthTest ? 1 : 0.12 },
          };
          material.transparent = !depthTest;
          material.depthTest = depthTest;
          const lines = new LineSegments(geometry, material);
          lines.frustumCulled = false;
          lines.renderOrder = depthTest ? 2 : 1;
          this.scene.add(lines);
          this.troubles.push(lines);
        }
    this.redraw();
  }

  clear(): void {
    for (const object of [this.shape, this.marker, this.marked, ...this.troubles]) {
      object?.removeFromParent();
      object?.geometry.dispose();
    }
    this.pickScene.clear();
    this.shape = this.marker = this.marked = null;
    this.troubles = [];
    this.hasSphere = false;
    this.redraw();
  }

  /// 0: the mesh, 1: the sphere.
  get morph(): number {
    return this.morph_;
  }
  set morph(value: number) {
    this.morph_ = Math.min(1, Math.max(0, value));
    this.onMorph(this.morph_);
    this.redraw();
  }

  /// Stops what plays, there.
  go(morph: number): void {
    this.playing = 0;
    this.morph = morph;
  }

  /// Whether the mesh has all of the canvas.
  set alone(value: boolean) {
    this.alone_ = value;
    this.redraw();
  }

  /// Morphs to the other end; a mesh on its way to another one goes to and fro until this is called again.
  play(): void {
    this.playing = this.isToAndFro && this.playing !== 0 ? 0 : this.morph_ < 0.5 ? 1 : -1;
    this.redraw();
  }

  /// Turns all the time, radians per second.
  spin(speed: number): void {
    this.spinning = speed;
    this.redraw();
  }

  /// The first view of a mesh: y is up, or z, and the longest extent is across the screen.
  face({ points }: Mesh, isZUp: boolean): void {
    const [x, z, sign] = isZUp ? [0, 1, -1] : [0, 2, 1];
    const { center } = frameOf([points]);
    let [xx, xz, zz] = [0, 0, 0];
    for (let i = 0; i < points.length; i += 3) {
      const [a, b] = [points[i + x]! - center[x]!, sign * (points[i + z]! - center[z]!)];
      xx += a * a;
      xz += a * b;
      zz += b * b;
    }
    const isLong = Math.hypot(xx - zz, 2 * xz) > 0.2 * (xx + zz);
    this.across = isLong ? Math.atan2(2 * xz, xx - zz) / 2 : 0;
    this.isZUp = isZUp;
    this.resetView();
  }

  /// The first view again, a little from above and from the side.
  resetView(): void {
    const about = (axis: Vector3, angle: number) => new Quaternion().setFromAxisAngle(axis, angle);
    const [x, y] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0)];
    this.rotation.copy(about(x, 0.15)).multiply(about(y, this.across - 0.35));
    if (this.isZUp) this.rotation.multiply(about(x, -Math.PI / 2));
    this.zoom = 1;
    this.shift.set(0, 0);
    this.redraw();
  }

  /// About the vertical and the horizontal axis of the screen.
  turn(x: number, y: number): void {
    this.rotation
      .premultiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), x))
      .premultiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), y))
      .normalize();
    this.redraw();
  }

  zoomBy(factor: number): void {
    this.zoom = Math.min(40, Math.max(0.3, this.zoom * factor));
    this.redraw();
  }

  redraw(): void {
    this.needed = true;
  }

  /// Marks a face in both views.
  mark(face: number | null): void {
    this.marker?.removeFromParent();
    this.marked?.removeFromParent();
    this.marker?.geometry.dispose();
    this.marked?.geometry.dispose();
    this.marker = this.marked = null;
    if (face !== null && this.shape) {
      const first = this.faceOf.indexOf(face);
      let end = first;
      while (this.faceOf[end] === face) ++end;
      const of = ({ place }: Shaped) =>
        Array.from(this.corners.subarray(3 * first, 3 * end), (v) => new Vector3().fromBufferAttribute(place, v));
      const [p, s] = [of(this.shapes[0]!), of(this.shapes.at(-1)!)];
      const centre = (t: Vector3[]) => t.reduce((sum, v) => sum.add(v), new Vector3()).divideScalar(t.length);
      const geometry = (ps: Vector3[], ss: Vector3[]) =>
        new BufferGeometry()
          .setAttribute("position", new BufferAttribute(Float32Array.from(ps.flatMap((v) => v.toArray())), 3))
          .setAttribute("next", new BufferAttribute(Float32Array.from(ss.flatMap((v) => v.toArray())), 3));
      this.marker = new Points(geometry([centre(p)], [centre(s)]), this.ring);
      this.marked = new Shape(geometry(p, s), this.patch);
      for (const object of [this.marker, this.marked]) {
        object.frustumCulled = false;
        object.renderOrder = 3;
        this.scene.add(object);
      }
    }
    this.redraw();
  }

  /// The rectangles of the two views.
  views(): View[] {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    if (this.alone_) return [{ x: 0, y: 0, width: w, height: h }];
    if (w >= h)
      return [
        { x: 0, y: 0, width: w / 2, height: h },
        { x: w / 2, y: 0, width: w / 2, height: h },
      ];
    return [
      { x: 0, y: 0, width: w, height: h / 2 },
      { x: 0, y: h / 2, width: w, height: h / 2 },
    ];
  }

  // --- frames

  private lastTime = 0;
  private lastMove = 0;
  private isSharp = false;
  private step(time: number): void {
    const elapsed = Math.min(0.1, (time - this.lastTime) / 1000);
    if (this.frames.push((time - this.lastTime) / 1000) > 200) this.frames.shift();
    this.lastTime = time;
    if (this.playing !== 0) {
      this.morph = this.morph_ + (this.playing * elapsed) / (this.isToAndFro ? 4 : 1.6);
      if (this.morph_ === 0 || this.morph_ === 1) this.playing = this.isToAndFro ? -this.playing : 0;
    }
    if (this.spinning !== 0) this.turn(this.spinning * elapsed, 0);
    const moving = this.needed;
    this.needed = false;
    // What moves may be coarse, where there is no graphics card; what rests is drawn once more, sharp.
    if (moving) {
      this.lastMove = time;
      if (this.isSoftware) this.draw(coarse, this.ordered?.moving);
      else this.draw(this.sharp());
    } else if (this.isSoftware && !this.isSharp && time - this.lastMove > 200) this.draw(this.sharp());
  }

  /// Pixels of the canvas per CSS pixel at rest.
  private sharp(): number {
    return this.isSoftware ? 1.5 : Math.min(2, window.devicePixelRatio);
  }

  private aim(view: View, isSphere: boolean): void {
    const aspect = view.width / Math.max(1, view.height);
    this.camera.aspect = aspect;
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const distance = 1.08 / Math.sin(Math.atan(half * Math.min(1, aspect)));
    this.camera.zoom = this.zoom;
    this.camera.position.set(-this.shift.x, -this.shift.y, distance);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    for (const scene of [this.scene, this.pickScene]) scene.quaternion.copy(this.rotation);
    this.pose(isSphere ? 1 : this.morph_);
    const isWhole = this.isOutside && (isSphere || this.morph_ === 0 || this.morph_ === 1);
    this.surface.side = this.picking.side = isWhole ? FrontSide : DoubleSide; // in between a surface may turn over
    this.uniforms.pixel.value.set(2 / Math.max(1, view.width), 2 / Math.max(1, view.height));
  }

  /// Between which shapes the slider is.
  private pose(morph: number): void {
    if (!this.shape) return;
    const at = morph * (this.shapes.length - 1);
    const k = Math.max(0, Math.min(Math.floor(at), this.shapes.length - 2));
    const from = this.shapes[k]!;
    const to = this.shapes[k + 1] ?? from;
    this.shape.geometry.setAttribute("position", from.place);
    this.shape.geometry.setAttribute("normal", from.normal);
    this.shape.geometry.setAttribute("next", to.place);
    this.shape.geometry.setAttribute("nextNormal", to.normal);
    this.uniforms.morph.value = at - k;
  }

  private draw(ratio: number, corners = this.ordered?.atRest): void {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    if (w === 0 || h === 0) return;
    const views = this.views();
    this.onViews(views);
    if (!this.renderer) return;
    if (corners) this.shape?.geometry.setIndex(corners);
    this.isSharp = ratio === this.sharp();
    this.ringSize.value = 22 * ratio;
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const size = this.renderer.getSize(new Vector2());
    if (size.x !== w || size.y !== h) this.renderer.setSize(w, h, false);
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    for (const [i, view] of views.entries()) {
      if (i === 1 && !this.hasSphere) break;
      this.aim(view, i === 1);
      const y = h - view.y - view.height;
      this.renderer.setViewport(view.x, y, view.width, view.height);
      this.renderer.setScissor(view.x, y, view.width, view.height);
      this.renderer.render(this.scene, this.camera);
    }
  }

  // --- which face is under the pointer

  /// The face at a point of the canvas, in CSS pixels.
  pick(x: number, y: number): Hover | null {
    if (!this.shape || !this.renderer) return null;
    const i = this.views().findIndex((v) => x >= v.x && x < v.x + v.width && y >= v.y && y < v.y + v.height);
    const view = this.views()[i];
    if (!view || (i === 1 && !this.hasSphere)) return null;
    this.aim(view, i === 1);
    this.camera.setViewOffset(view.width, view.height, x - view.x - 0.5, y - view.y - 0.5, 1, 1); // a pixel round it
    this.renderer.setRenderTarget(this.target);
    this.shape.geometry.setIndex(this.ordered!.atRest);
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.render(this.pickScene, this.camera);
    const pixel = new Uint8Array(4);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, pixel);
    this.renderer.setRenderTarget(null);
    this.camera.clearViewOffset();
    const vertex = (pixel[0]! | (pixel[1]! << 8) | (pixel[2]! << 16) | (pixel[3]! << 24)) - 1;
    if (vertex < 0 || vertex >= this.firstPart.length - 1) return null;
    const ndc = new Vector2((2 * (x - view.x)) / view.width - 1, 1 - (2 * (y - view.y)) / view.height);
    const part = this.nearestOf(vertex, ndc);
    this.redraw();
    return part === null ? null : { face: this.faceOf[part]!, onSphere: i === 1 };
  }

  /// Where the middle of a face, or of its first part, is on the canvas; null if it looks away.
  screenOf(face: number, onSphere: boolean): { x: number; y: number } | null {
    const view = this.views()[onSphere ? 1 : 0];
    if (!this.shape || !view) return null;
    this.aim(view, onSphere);
    const [a, b, c] = this.onScreen(this.faceOf.indexOf(face));
    if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0) return null;
    const middle = (k: "x" | "y") => (a[k] + b[k] + c[k]) / 3;
    return { x: view.x + ((1 + middle("x")) / 2) * view.width, y: view.y + ((1 - middle("y")) / 2) * view.height };
  }

  /// The corners of a part in the view at which the camera is aimed, from -1 to 1.
  private onScreen(part: number): [Vector3, Vector3, Vector3] {
    const [p, s] = ["position", "next"].map((a) => this.shape!.geometry.getAttribute(a) as BufferAttribute);
    return [0, 1, 2].map((k) => {
      const v = this.corners[3 * part + k]!;
      return new Vector3()
        .fromBufferAttribute(p!, v)
        .lerp(new Vector3().fromBufferAttribute(s!, v), this.uniforms.morph.value)
        .applyQuaternion(this.rotation)
        .project(this.camera);
    }) as [Vector3, Vector3, Vector3];
  }

  /// Of the parts whose last corner is `vertex` the one that is at `ndc`.
  private nearestOf(vertex: number, ndc: Vector2): number | null {
    let best: number | null = null;
    let bestDistance = Infinity;
    for (let i = this.firstPart[vertex]!; i < this.firstPart[vertex + 1]!; ++i) {
      const part = this.partOf[i]!;
      const [a, b, c] = this.onScreen(part);
      const cross = (u: { x: number; y: number }, v: { x: number; y: number }, w: { x: number; y: number }) =>
        (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
      const area = cross(a, b, c);
      if (area === 0) continue;
      const outside = Math.max(0, ...[cross(b, c, ndc), cross(c, a, ndc), cross(a, b, ndc)].map((d) => -d / area));
      const distance = outside + 1e-3 * ((a.z + b.z + c.z) / 3);
      if (distance < bestDistance) [best, bestDistance] = [part, distance];
    }
    return best;
  }

  /// The corners in the order in which they are drawn, and fewer where software draws what moves. They stay when the
  /// sphere of a mesh comes, unless faces are cut for it.
  private order(model: Model, position: Float32Array): void {
    const n = position.length / 3;
    if (this.ordered?.triangles === model.triangles && this.ordered.n === n && this.halves.length === 0) return;
    const fewer = (cells: number) => coarsened(this.corners, position, cells);
    const isLarge = this.corners.length > 900_000;
    const atRest = this.isSoftware && isLarge ? fewer(112) : this.corners;
    const moving = this.isSoftware && atRest.length > 60_000 ? fewer(72) : atRest;
    const attribute = (corners: Uint32Array) => new BufferAttribute(localOrder(corners, n), 1);
    const first = attribute(atRest);
    this.ordered = { triangles: model.triangles, n, atRest: first, moving: moving === atRest ? first : attribute(moving) };
  }
  private ordered: { triangles: Int32Array; n: number; atRest: BufferAttribute; moving: BufferAttribute } | null = null;

  /// One vertex per point, and one more per segment that meets there.
  private split(model: Model): void {
    const { triangles, segments } = model;
    const n = model.points.length / 3;
    const corners = new Uint32Array(triangles);
    const face = new Uint32Array(n);
    const copies: { source: number; face: number }[] = [];
    if (segments) {
      const first = new Int32Array(n).fill(-1); // segment of the point
      const others = new Map<string, number>();
      for (let c = 0; c < triangles.length; ++c) {
        const v = triangles[c]!;
        const f = (c / 3) | 0;
        const segment = segments[f]!;
        if (first[v] === -1) {
          first[v] = segment;
          face[v] = f;
        } else if (first[v] !== segment) {
          const key = `${v} ${segment}`;
          let copy = others.get(key);
          if (copy === undefined) others.set(key, (copy = n + copies.push({ source: v, face: f }) - 1));
          corners[c] = copy;
        }
      }
    }
    this.source = new Uint32Array(n + copies.length);
    this.faceOfVertex = new Uint32Array(n + copies.length);
    for (let v = 0; v < n; ++v) this.source[v] = v;
    this.faceOfVertex.set(face);
    copies.forEach((copy, i) => {
      this.source[n + i] = copy.source;
      this.faceOfVertex[n + i] = copy.face;
    });
    this.corners = corners;
    this.faceOf = Uint32Array.from({ length: corners.length / 3 }, (_, f) => f);
    this.halves = new Uint32Array();
  }

  /// The parts round the vertices, for `pick()`.
  private indexParts(): void {
    const { corners } = this;
    const n = this.source.length + this.halves.length / 2;
    this.firstPart = new Uint32Array(n + 1);
    for (let c = 2; c < corners.length; c += 3) this.firstPart[corners[c]! + 1]!++;
    for (let v = 0; v < n; ++v) this.firstPart[v + 1]! += this.firstPart[v]!;
    this.partOf = new Uint32Array(corners.length / 3);
    const end = this.firstPart.slice();
    for (let p = 0; p < this.partOf.length; ++p) this.partOf[end[corners[3 * p + 2]!]!++] = p;
  }

  /// Rows of three numbers: those of the vertices between others are the means of those, on the sphere if they are.
  private fillHalves(rows: { [i: number]: number }, isSphere = false): void {
    for (let h = 0; h < this.halves.length; ++h) {
      const [a, b] = [3 * this.halves[h]!, 3 * this.halves[++h]!];
      const v = 3 * (this.source.length + (h >> 1));
      const [x, y, z] = [0, 1, 2].map((k) => rows[a + k]! + rows[b + k]!) as [number, number, number];
      const size = isSphere ? Math.sqrt(x * x + y * y + z * z) || 1 : 2;
      [rows[v], rows[v + 1], rows[v + 2]] = [x / size, y / size, z / size];
    }
  }

  // --- pointer and keys

  private listen(): void {
    const canvas = this.canvas;
    const down = new Map<number, { x: number; y: number }>();
    canvas.style.touchAction = "none";
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      down.set(event.pointerId, { x: event.clientX, y: event.clientY });
      this.spinning = 0;
      this.hover(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = down.get(event.pointerId);
      if (!before) return this.hover(event);
      const now = { x: event.clientX, y: event.clientY };
      const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
      const scale = 1 / Math.max(100, Math.min(canvas.clientWidth, canvas.clientHeight));
      if (other) {
        const apart = (p: { x: number; y: number }) => Math.hypot(p.x - other.x, p.y - other.y);
        this.zoomBy(apart(now) / Math.max(1, apart(before)));
      }
      if (other || event.shiftKey || event.buttons === 2)
        this.shift.add(new Vector2(now.x - before.x, before.y - now.y).multiplyScalar((2 * scale) / this.zoom));
      else this.turn(4 * scale * (now.x - before.x), 4 * scale * (now.y - before.y));
      this.redraw();
      down.set(event.pointerId, now);
    });
    for (const end of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(end, (event) => down.delete(event.pointerId));
    canvas.addEventListener("pointerleave", (event) => {
      if (event.pointerType !== "touch") this.hover(null); // what a tap has marked stays when the finger is lifted
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoomBy(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
      },
      { passive: false },
    );
    canvas.addEventListener("dblclick", () => this.resetView());
    canvas.addEventListener("keydown", (event) => {
      const step = 0.1;
      const actions: Record<string, () => void> = {
        ArrowLeft: () => this.turn(-step, 0),
        ArrowRight: () => this.turn(step, 0),
        ArrowUp: () => this.turn(0, -step),
        ArrowDown: () => this.turn(0, step),
        "+": () => this.zoomBy(1.15),
        "=": () => this.zoomBy(1.15),
        "-": () => this.zoomBy(1 / 1.15),
      };
      const action = event.ctrlKey || event.metaKey || event.altKey ? undefined : actions[event.key];
      if (!action) return;
      event.preventDefault();
      action();
    });
  }

  /// At most one pick per frame.
  private hover(event: PointerEvent | null): void {
    const waiting = this.pointer !== null;
    if (this.shapes.length > 2) return; // nothing is known of faces
    if (!event) {
      this.pointer = null;
      this.mark(null);
      this.onHover(null);
      return;
    }
    const box = this.canvas.getBoundingClientRect();
    this.pointer = { x: event.clientX - box.left, y: event.clientY - box.top };
    if (waiting) return;
    requestAnimationFrame(() => {
      const at = this.pointer;
      if (!at) return; // it has left
      this.pointer = null;
      const hover = this.pick(at.x, at.y);
      this.mark(hover?.face ?? null);
      this.onHover(hover);
    });
  }
}

function rendererOf(canvas: HTMLCanvasElement, antialias: boolean): WebGLRenderer | null {
  try {
    const renderer = new WebGLRenderer({ canvas, antialias });
    renderer.autoClear = false;
    return renderer;
  } catch {
    return null;
  }
}

/// What draws.
function nameOfRenderer(): string {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(gl!.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return name;
}

/// The ball that the shapes of a mesh are scaled to: about the middle of their box.
function frameOf(shapes: Coordinates[]): { center: [number, number, number]; radius: number } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const points of shapes)
    for (let i = 0; i < points.length; ++i) {
      low[i % 3] = Math.min(low[i % 3]!, points[i]!);
      high[i % 3] = Math.max(high[i % 3]!, points[i]!);
    }
  const center = [0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as [number, number, number];
  let square = 0;
  for (const points of shapes)
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i]! - center[0];
      const y = points[i + 1]! - center[1];
      const z = points[i + 2]! - center[2];
      square = Math.max(square, x * x + y * y + z * z);
    }
  return { center, radius: Math.sqrt(square) || 1 };
}

/// Whether the faces of a closed mesh look to its inside.
function isInsideOut(mesh: Mesh): boolean {
  const p = mesh.points;
  let volume = 0;
  forEachFace(mesh, (x, y, z, a) => {
    volume += (p[a]! - p[0]!) * x + (p[a + 1]! - p[1]!) * y + (p[a + 2]! - p[2]!) * z;
  });
  return volume < 0;
}
