// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The page: a file or an example goes to the worker, its map comes back.

import workerText from "worker-text";

import { colouredPly, json, off, offInPieces, save, texturedGlb } from "./downloads";
import { examples, type Example } from "./examples";
import type { Mesh, Model, Report } from "./model";
import { element } from "./panel";
import { isForPage, isHelpOpen, Stage } from "./stage";
import { nameOfTrouble, troublesOf } from "./topology";
import type { Answer, Job, Message, Settings } from "./worker";

const byId = <T extends HTMLElement = HTMLElement>(id: string) => document.getElementById(id) as T;

const script = URL.createObjectURL(new Blob([workerText], { type: "text/javascript" })); // one, large, for all workers
let worker = start(); // first: it reads WebAssembly while the views are made
const stage = new Stage();

/// The file that is shown, and that other settings map again.
let file: { name: string; bytes: Uint8Array } | null = null;
let choices = 0; // of files and examples: the last one counts
let core = { version: "", policy: "" };
let running: { name: string; settings: Settings; mesh?: Mesh } | null = null; // the mesh, once it is read
let segmenting = false;
/// While it maps, the worker hears nothing. It asks for this address now and then, and goes on as long as it is there.
let permit = "";
let patience: ReturnType<typeof setTimeout> | undefined;

function start(): Worker {
  const result = new Worker(script, { name: document.baseURI }); // where it finds the core for all cores
  // what an ended worker has said before may still come
  const hearIt = (message: Message) => result === worker && hear(message);
  result.onmessage = ({ data }: MessageEvent<Message>) => hearIt(data);
  result.onerror = (event) => hearIt({ kind: "failed", why: event.message });
  return result;
}

/// The number of a field, which then shows it; `otherwise` if there is none, or one that is too small.
function numberOf(id: string, least: number, otherwise: number): number {
  const field = byId<HTMLInputElement>(id);
  const value = Number(field.value);
  if (field.value === "" || !(value >= least)) field.value = String(otherwise);
  return Number(field.value);
}

function settings(): Settings {
  return {
    method: byId<HTMLSelectElement>("method").value as Settings["method"],
    weights: byId<HTMLSelectElement>("weights").value as Settings["weights"],
    spring_exponent: numberOf("spring-exponent", 2, 2),
    area_exponent: numberOf("area-exponent", 0, 1),
    triangulate: byId<HTMLInputElement>("triangulate").checked,
  };
}

function map(): void {
  if (!file) return;
  if (running || segmenting) stop();
  running = { name: file.name, settings: settings() };
  document.body.classList.add("running");
  document.body.dataset.state = "running";
  byId("file-name").textContent = file.name;
  byId("unsaved").textContent = "";
  progress(0, "Reading");
  permit = URL.createObjectURL(new Blob([""], { type: "text/javascript" }));
  ask({ name: file.name, bytes: file.bytes, settings: running.settings, permit });
}

/// The worker gets a copy, for which there may not be enough memory.
function ask(job: Job): void {
  try {
    worker.postMessage(job);
  } catch (error) {
    hear({ kind: "failed", why: (error as Error).message });
  }
}

/// Segments take longer than the map: only when they are to be seen.
stage.onColouring = (colouring) => {
  const { model } = stage;
  if (colouring !== "segments" || !model?.sphere || model.segments || model.unsegmented || running || segmenting) return;
  segmenting = true;
  document.body.classList.add("running");
  document.body.dataset.state = "running";
  progress(0, "Segmenting");
  ask({ mesh: { points: model.points, triangles: model.triangles }, sphere: model.sphere as Float64Array });
};

/// Asks for the best map so far. Who does not answer is stopped, and who cannot be asked: in a page from a disk, browsers
/// give the worker another origin, from which the address is never there.
function cancel(): void {
  if (segmenting || (running && origin === "null")) stopAndSay();
  if (!running || patience !== undefined) return;
  URL.revokeObjectURL(permit);
  patience = setTimeout(stopAndSay, 2000);
}

/// WebAssembly cannot be interrupted from outside: the worker ends, and another one begins.
function stop(): void {
  worker.terminate();
  worker = start();
  finish("cancelled");
}

function stopAndSay(): void {
  const wasMapping = running !== null;
  stop();
  const { model } = stage;
  if (!model?.sphere) byId("result").replaceChildren(element("p", { class: "hint" }, "Cancelled: there is no map."));
  else if (wasMapping) {
    stage.say(model);
    byId("result").prepend(element("p", { class: "hint" }, "Cancelled: this is the map of before, by its own settings."));
  }
}

function finish(state: string): void {
  clearTimeout(patience);
  patience = undefined;
  URL.revokeObjectURL(permit);
  running = null;
  segmenting = false;
  document.body.classList.remove("running");
  document.body.dataset.state = state;
}

function progress(fraction: number, what: string): void {
  byId<HTMLProgressElement>("bar").value = fraction;
  byId("doing").textContent = `${what} ${file?.name ?? ""}${fraction > 0 ? `, ${Math.round(100 * fraction)} %` : ""}`;
}

function open(name: string, bytes: Uint8Array): void {
  file = { name, bytes };
  stage.clear();
  byId("downloads").hidden = true;
  map();
}

/// What was there before is gone, so that nobody takes it for this.
function refuseFile(name: string, why: string): void {
  if (running || segmenting) stop();
  file = null;
  stage.clear();
  byId("file-name").textContent = name;
  document.body.dataset.state = "refused";
  refuse({ input: name, error: `${name}: ${why}`, error_code: "UNREADABLE_FILE" });
}

function openExample(example: Example): void {
  ++choices;
  const mesh = example.mesh();
  open(example.file, new TextEncoder().encode(off(mesh)));
  showMesh(mesh); // the first picture does not wait for the worker
}

/// The mesh of the file; it stays while other settings are tried.
function showMesh(mesh: Mesh): void {
  const isShown = stage.model?.points.length === mesh.points.length;
  if (!isShown) stage.show({ ...mesh, report: { input: file!.name, error: null, error_code: "OK" } });
}

function showSegments(segments?: Int32Array, unsegmented?: string): void {
  finish(stage.model?.report.error === null ? "certified" : "refused");
  if (stage.model) stage.show({ ...stage.model, segments, unsegmented });
}

function hear(message: Message): void {
  if (message.kind === "ready") {
    core = message;
    document.body.dataset.core = "ready";
    return;
  }
  if (message.kind === "segments") return showSegments(message.segments, message.why);
  if (segmenting && message.kind === "failed") {
    stop();
    return showSegments(undefined, `${message.why}; use the command-line tool`);
  }
  if (!running) return;
  const { name, settings, mesh } = running;
  switch (message.kind) {
    case "mesh":
      showMesh(message.mesh);
      running.mesh = message.mesh;
      progress(0, "Mapping");
      break;
    case "progress":
      progress(message.fraction, "Mapping");
      break;
    case "failed":
      finish("failed");
      worker.terminate();
      worker = start();
      refuse({ input: name, error: `${name}: ${message.why}; use the command-line tool`, error_code: "FAILED" });
      break;
    case "answer":
      finish(stateOf[message.answer.error_code] ?? "refused");
      answer(settings, mesh, message.answer);
  }
}

const stateOf: Record<string, string> = { OK: "certified", INTERRUPTED: "cancelled" };

function refuse(report: Report): void {
  stage.say({ points: new Float64Array(), triangles: new Int32Array(), report });
  byId("downloads").hidden = true;
}

function answer(settings: Settings, mesh: Mesh | undefined, given: Answer): void {
  const { sphere, face_stretch, face_angle_distortion, ...rest } = given;
  const report: Report = {
    version: core.version,
    ...rest,
    weights: settings.weights,
    method: settings.method,
    policy: core.policy,
    device: "WebAssembly",
    settings: { ...settings, policy: core.policy },
  };
  if (!mesh) {
    // not even a mesh
    stage.clear();
    refuse(report);
    return;
  }
  const model: Model = {
    ...mesh,
    sphere,
    stretch: face_stretch,
    angle: face_angle_distortion,
    report,
  };
  stage.show(model);
  const troubles = sphere ? [] : troublesOf(model).map((trouble) => ({ trouble, name: nameOfTrouble(trouble) }));
  stage.say(model, troubles);
  byId("downloads").hidden = !sphere;
  stage.onColouring(stage.colouring);
}

// --- controls

for (const example of examples) {
  const button = element("button", { type: "button", class: "example", "data-example": example.file }, example.name);
  button.addEventListener("click", () => openExample(example));
  byId("examples").append(button);
}

async function openFile(files?: FileList | null): Promise<void> {
  const chosen = files?.[0];
  if (!chosen) return;
  const choice = ++choices;
  if (files.length > 1) return refuseFile(`${files.length} files`, "drop one at a time");
  const bytes = await chosen.arrayBuffer().catch(() => null);
  if (choice !== choices) return; // something else was chosen meanwhile
  if (bytes) open(chosen.name, new Uint8Array(bytes));
  else refuseFile(chosen.name, "cannot be read: it is a folder, or too large for the browser, or no longer there; choose another file");
}

const input = byId<HTMLInputElement>("file");
input.addEventListener("change", () => {
  void openFile(input.files);
  input.value = "";
});
byId("choose").addEventListener("click", () => input.click());
for (const kind of ["dragenter", "dragover"] as const)
  document.addEventListener(kind, (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
document.addEventListener("dragleave", (event) => {
  if (!event.relatedTarget) document.body.classList.remove("dropping");
});
document.addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  void openFile(event.dataTransfer?.files);
});

function dependentControls(): void {
  const { method } = settings();
  byId("spring-row").hidden = method !== "balanced" && method !== "automatic";
  byId("area-row").hidden = method !== "isometric" && method !== "automatic";
  byId("weights-row").hidden = method === "isometric";
}
for (const id of ["method", "weights", "spring-exponent", "area-exponent", "triangulate"])
  byId(id).addEventListener("change", () => {
    dependentControls();
    map();
  });
dependentControls();

byId("cancel").addEventListener("click", cancel);
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape" && !isHelpOpen()) cancel();
  if (event.key === "o" && isForPage(event)) input.click();
});

const base = () => (file?.name ?? "mesh").replace(/\.[^.]*$/, "");
const actions: Record<string, (model: Model) => Promise<void> | void> = {
  "save-sphere": (m) => save(`${base()}_sphere.off`, offInPieces({ points: m.sphere!, triangles: m.triangles }), "text/plain"),
  "save-ply": (m) => {
    const shown = stage.colouring === "segments" && !m.segments ? "plain" : stage.colouring; // they may not be there yet
    save(`${base()}_${shown}.ply`, colouredPly(m, shown), "text/plain");
  },
  "save-glb": async (m) => save(`${base()}.glb`, [await texturedGlb(m)], "model/gltf-binary"),
  "save-json": (m) => save(`${base()}.json`, [json(m.report)], "application/json"),
};
for (const [id, action] of Object.entries(actions))
  byId(id).addEventListener("click", async () => {
    byId("unsaved").textContent = "";
    try {
      if (stage.model) await action(stage.model);
    } catch (error) {
      byId("unsaved").textContent = `Not saved: ${(error as Error).message}; use the command-line tool.`;
    }
  });

openExample(examples[0]!); // something to look at

// for tests
Object.assign(window, { page: { stage, text: () => new TextDecoder().decode(file?.bytes) } });
