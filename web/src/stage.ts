// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// What the page and the files of `view` have in common: views, slider, colours, certificate.

import { colourings, nameOf, type Colouring, type Legend } from "./colours";
import { drawable, type Model } from "./model";
import { certificate, describe, element, facts, legendPanel, ofWay } from "./panel";
import type { Trouble } from "./topology";
import { Viewer } from "./viewer";

const byId = <T extends HTMLElement = HTMLElement>(id: string) => document.getElementById(id) as T;

export const isHelpOpen = () => byId<HTMLDialogElement>("help").open;

/// Whether a letter or digit is a key of the page: not for a control that takes it, nor for the browser.
export const isForPage = (event: KeyboardEvent) =>
  !(event.ctrlKey || event.metaKey || event.altKey || isHelpOpen() || document.activeElement?.matches("select, input[type=number]"));

export class Stage {
  readonly viewer: Viewer;
  onColouring: (colouring: Colouring) => void = () => {};
  model: Model | null = null;
  private drawn: Model | null = null; // the same at a size that can be drawn
  colouring: Colouring = "stretch";
  private readonly slider = byId<HTMLInputElement>("morph");
  private ends: [string, string] = ["Mesh", "Sphere"]; // of the slider
  private readonly labels = [byId("label-mesh"), byId("label-sphere")];

  constructor() {
    this.viewer = new Viewer(byId<HTMLCanvasElement>("canvas"));
    if (!this.viewer.canDraw) {
      const why = ["Nothing can be drawn: this browser has no WebGL 2.", element("br"), "Switch on its graphics acceleration, or use another one."];
      byId("empty").replaceWith(element("div", { class: "notice", id: "no-webgl" }, element("p", {}, ...why)));
    }
    this.viewer.onMorph = (morph) => {
      this.slider.value = String(Math.round(1000 * morph));
      this.slider.setAttribute("aria-valuetext", `${Math.round(100 * morph)} % ${this.ends[1]}`);
      this.name();
    };
    this.viewer.onViews = (views) =>
      views.forEach((view, i) => {
        this.labels[i]!.style.left = `${view.x}px`;
        this.labels[i]!.style.top = `${view.y}px`;
      });
    this.viewer.onHover = (hover) => {
      byId("hover").textContent = hover && this.model ? describe(this.model, hover.face) : "";
      byId("hover").dataset.face = hover ? String(hover.face) : "";
    };
    this.slider.addEventListener("input", () => this.viewer.go(Number(this.slider.value) / 1000));
    byId("play").addEventListener("click", () => this.viewer.play());
    byId("reset").addEventListener("click", () => this.viewer.resetView());
    byId("theme").addEventListener("click", () => this.switchTheme());
    this.offerColours();
    document.addEventListener("keydown", (event) => this.key(event));
    const help = byId<HTMLDialogElement>("help");
    byId("keys").addEventListener("click", () => help.showModal());
    help.addEventListener("click", () => help.close());
  }

  /// Shows a mesh, with or without its sphere; the panel says what is known of it.
  show(model: Model): void {
    const before = this.model?.sphere;
    this.drawn = drawable(model);
    if (this.model?.points.length !== model.points.length)
      this.viewer.face(this.drawn, /\.gii(\.gz)?$|^[lr]h\./.test(model.report.input)); // as neuroimaging has it
    this.model = model;
    if (model.way) this.tell(model.way.names);
    if (!before || !model.sphere) this.viewer.morph = 0;
    this.viewer.alone = model.way !== undefined;
    this.viewer.show(this.drawn);
    ["from", "to"].forEach((id, i) => (byId(id).textContent = this.ends[i]!));
    this.name();
    document.body.classList.toggle("has-mesh", true);
    document.body.classList.toggle("has-sphere", model.sphere !== undefined);
    document.body.classList.toggle("has-way", model.way !== undefined);
    byId<HTMLButtonElement>("play").disabled = this.slider.disabled = !model.sphere && !model.way;
    this.recolour();
  }

  /// Nothing is shown, and nothing is said.
  clear(): void {
    this.model = this.drawn = null;
    this.viewer.clear();
    document.body.classList.remove("has-sphere", "has-mesh");
    for (const id of ["result", "colours-of", "facts"]) byId(id).replaceChildren();
  }

  say(model: Model, troubles: { trouble: Trouble; name: string }[] = []): void {
    const verdict = model.way ? ofWay(model.way) : certificate(model.report);
    if (troubles.length > 0)
      verdict.append(
        element("p", { class: "marked", id: "marked" }, "Marked on the mesh: " + troubles.map((t) => t.name).join(", ") + "."),
      );
    this.viewer.alone = !model.sphere;
    this.viewer.markTroubles(troubles.map((t) => t.trouble));
    byId("result").replaceChildren(verdict);
    byId("facts").replaceChildren(...(model.report.vertices == null ? [] : [facts(model.report)]));
  }

  recolour(): Legend | null {
    if (!this.model || !this.drawn) return null;
    const legend = this.viewer.colour(this.drawn, this.model.sphere ? this.colouring : "plain");
    byId("colours-of").replaceChildren(...(this.model.sphere ? [legendPanel(this.drawn, this.colouring, legend)] : []));
    return legend;
  }

  choose(colouring: Colouring): void {
    this.colouring = colouring;
    byId<HTMLInputElement>(`colour-${colouring}`).checked = true;
    this.recolour();
    this.onColouring(colouring);
  }

  /// The words for a mesh on its way to another one.
  private tell(ends: [string, string]): void {
    this.ends = ends;
    this.slider.setAttribute("aria-label", "From one mesh to the other");
    byId("canvas").setAttribute("aria-label", "The mesh on its way. Arrow keys turn it, plus and minus zoom.");
  }

  private name(): void {
    const share = Math.round(100 * this.viewer.morph);
    const [from, to] = this.ends;
    const isWay = this.model?.way !== undefined;
    const [between, last] = isWay ? [`${share} % of the way`, to] : [`Mesh, ${share} % sphere`, "Mesh on the sphere"];
    this.labels[0]!.textContent = share === 0 ? from : share === 100 ? last : between;
  }

  private offerColours(): void {
    colourings.forEach((colouring, i) => {
      const input = element("input", { type: "radio", name: "colouring", id: `colour-${colouring}`, value: colouring });
      input.addEventListener("change", () => this.choose(colouring));
      byId("colourings").append(input, element("label", { for: `colour-${colouring}`, title: `Key ${i + 1}` }, nameOf[colouring]));
    });
    byId<HTMLInputElement>(`colour-${this.colouring}`).checked = true;
  }

  private switchTheme(): void {
    const root = document.documentElement;
    const ofSystem = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    root.dataset.theme = (root.dataset.theme ?? ofSystem) === "dark" ? "light" : "dark";
  }

  private key(event: KeyboardEvent): void {
    if (!isForPage(event)) return;
    const number = Number(event.key);
    if (number >= 1 && number <= colourings.length) this.choose(colourings[number - 1]!);
    else if (event.key === "m") byId("play").click(); // unless it is disabled
    else if (event.key === "t") this.switchTheme();
    else if (event.key === "?") byId<HTMLDialogElement>("help").showModal();
    else if (event.key === "0") this.viewer.resetView();
  }
}
