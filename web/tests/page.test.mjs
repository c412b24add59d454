// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The page in chromium, and the file that the command `view` writes.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

import { chromium } from "playwright-core";

import { serve } from "../serve.mjs";
import { different, native, own, readOff, said, scratch, source, tool, web, write } from "./helpers.mjs";

const folder = scratch("page");
const { examples, small, torus } = await source("examples.ts");
const { off } = await source("downloads.ts");
let browser, server, page;
const complaints = []; // of the console
/// Of the browser, or of a thread whose page or worker ended while it was still loading: where one that is needed cannot
/// load, nothing is computed, and a test waits in vain.
const harmless = /GPU stall|GL Driver|swiftshader|threads\.js' failed to load/i;

/// A page that notes errors.
async function open(url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const result = await context.newPage();
  const note = (complaint) => harmless.test(complaint) || complaints.push(complaint);
  result.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) note(message.text());
  });
  result.on("pageerror", (error) => note(error.message));
  await result.goto(url);
  return result;
}

const url = () => `http://127.0.0.1:${server.address().port}/`;
/// Waits until the file `name` has come to a state.
const state = (name, which) =>
  page.waitForFunction(
    ([n, s]) => document.getElementById("file-name").textContent === n && document.body.dataset.state === s,
    [name, which],
    { timeout: 300_000 },
  );
const shot = (name) => page.screenshot({ path: join(folder, name + ".png") });
const text = (selector) => page.locator(selector).innerText();

before(async () => {
  server = await serve(0);
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  page = await open(url());
});
after(async () => {
  await browser?.close();
  server?.close();
});

test("the download is small", () => {
  assert.ok(gzipSync(readFileSync(join(web, "dist", "index.html"))).length < 2_000_000);
});

test("what is served has the licences of what is in it", () => {
  const names = readFileSync(join(web, "dist", "package", "LICENSES.txt"), "utf8").match(/^==== .* ====$/gm);
  assert.ok(names.length > 5);
  for (const [file, more] of [["index.html", "three.js authors"], ["threads.js", "Apache License"]]) {
    const text = readFileSync(join(web, "dist", file), "utf8");
    for (const name of [...names, more]) assert.ok(text.includes(name), `${file}: ${name}`);
  }
});

for (const example of examples)
  test(`maps the example ${example.name}, as the tool does`, async () => {
    await page.selectOption("#method", "balanced");
    await page.click(`[data-example="${example.file}"]`);
    await state(example.file, "certified");
    // not example.mesh(): the sines of chromium and node differ
    const expected = native(write(folder, example.file, await page.evaluate(() => window.page.text())), folder, ["--method", "balanced"]);
    assert.equal(expected.error, null);
    assert.equal(await page.getAttribute("#certificate", "data-code"), "OK");
    assert.match(await text("#certificate"), /^Certified\s+0 of [\d,]+ faces flipped, degree 1\./);
    assert.ok((await page.locator("#histogram rect").count()) > 40);
    const found = await page.evaluate(() => Array.from(window.page.stage.model.sphere));
    assert.equal(different(found, Array.from(expected.sphere)), 0);
    await shot(example.file);
  });

test("the slider morphs the mesh", async () => {
  const box = await page.locator("#morph").boundingBox();
  await page.mouse.move(box.x + 8, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 6 });
  await page.mouse.up();
  const morph = await page.evaluate(() => window.page.stage.viewer.morph);
  assert.ok(morph > 0.4 && morph < 0.6, String(morph));
  assert.match(await text("#label-mesh"), /% sphere/);
  await shot("morph");
  await page.evaluate(() => (window.page.stage.viewer.morph = 0));
});

test("a face is the same in both views", async () => {
  await page.selectOption("#method", "isometric"); // which keeps faces large enough to be hit
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
  const tried = await page.evaluate(() => {
    const { viewer, model } = window.page.stage;
    const result = [];
    for (let f = 0; f < model.triangles.length / 3; f += 97)
      for (const onSphere of [false, true]) {
        const at = viewer.screenOf(f, onSphere);
        const hit = at && viewer.pick(at.x, at.y);
        if (hit) result.push([f, hit.face, hit.onSphere === onSphere, onSphere]);
      }
    return result;
  });
  assert.ok(tried.every(([, , sameView]) => sameView));
  // the sphere hides nothing of what looks at the camera; faces smaller than the numbers of the screen may be missed
  const sphere = tried.filter(([, , , onSphere]) => onSphere);
  const right = sphere.filter(([face, hit]) => face === hit).length;
  assert.ok(sphere.length > 50 && right > 0.95 * sphere.length, `${right} of ${sphere.length}`);
  const canvas = await page.locator("#canvas").boundingBox();
  await page.mouse.move(canvas.x + 0.75 * canvas.width, canvas.y + canvas.height / 2);
  await page.waitForFunction(() => document.getElementById("hover").textContent !== "");
  assert.match(await text("#hover"), /^face [\d,]+ · area [×÷] [\d.,e]+ · angles [\d.]+°/);
  await shot("hover");
});

test("keys turn, zoom and colour", async () => {
  await page.focus("#canvas");
  const rotation = () => page.evaluate(() => window.page.stage.viewer.rotation.toArray());
  const first = await rotation();
  await page.keyboard.press("ArrowLeft");
  assert.notDeepEqual(await rotation(), first);
  await page.keyboard.press("0");
  assert.deepEqual(await rotation(), first);
  await page.keyboard.press("2");
  assert.ok(await page.isChecked("#colour-angle"));
  await page.keyboard.press("4");
  await shot("checker");
  await page.keyboard.press("?");
  assert.ok(await page.isVisible("#help"));
  await shot("help");
  await page.keyboard.press("Escape");
  assert.ok(await page.isHidden("#help"));
});

test("o opens a file, unless a control takes the letter", async () => {
  let opened = 0;
  page.on("filechooser", () => ++opened);
  for (const [where, times] of [["#canvas", 1], ["#colour-checker", 2], ["#theme", 3], ["#method", 3], ["#spring-exponent", 3]]) {
    await page.selectOption("#method", "automatic"); // which has all controls
    await page.focus(where);
    await page.keyboard.press("o");
    await page.evaluate(() => new Promise((done) => setTimeout(done, 100)));
    assert.equal(opened, times, where);
  }
  page.removeAllListeners("filechooser");
  await state("bar.off", "certified");
});

test("segments come when they are asked for", async () => {
  await page.click("label[for=colour-segments]");
  await page.keyboard.press("Escape"); // ends the worker; the next one segments the same map
  await page.click("label[for=colour-plain]");
  await page.click("label[for=colour-segments]");
  await page.waitForFunction(() => window.page.stage.model.segments, null, { timeout: 120_000 });
  assert.match(await text("#legend"), /\d+ segments?\./);
  await shot("segments");
  await page.click("label[for=colour-stretch]");
});

test("why there are no segments is said", async () => {
  await page.evaluate(() => {
    const { stage } = window.page;
    const { segments, sphere, ...rest } = stage.model;
    stage.model = { ...rest, sphere: sphere.map((x, i) => (i < 3 ? 0 : x)), report: { ...rest.report, error: "not a map" } };
  });
  await page.click("label[for=colour-segments]");
  await page.waitForFunction(() => document.body.dataset.state === "refused");
  assert.match(await text("#legend"), /There are none: .*vertex 0 of the sphere has no direction\./);
  await page.click("label[for=colour-stretch]");
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
});

test("downloads can be read again", async () => {
  const download = async (id) => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.click(id)]);
    const path = join(folder, file.suggestedFilename());
    await file.saveAs(path);
    return path;
  };
  const model = await page.evaluate(() => ({
    sphere: Array.from(window.page.stage.model.sphere),
    triangles: Array.from(window.page.stage.model.triangles),
  }));
  const sphere = readOff(readFileSync(await download("#save-sphere"), "utf8"));
  assert.equal(different(Array.from(sphere.points), model.sphere), 0);
  assert.deepEqual(sphere.triangles, model.triangles);

  const ply = await download("#save-ply");
  assert.equal(native(ply, folder).error, null); // the tool reads it
  const report = JSON.parse(readFileSync(await download("#save-json"), "utf8"));
  assert.equal(report.flipped_faces, 0);
  assert.equal(report.error, null);

  const glb = readFileSync(await download("#save-glb"));
  assert.equal(glb.toString("latin1", 0, 4), "glTF");
  assert.equal(glb.readUInt32LE(8), glb.length);
  const gltf = JSON.parse(glb.toString("utf8", 20, 20 + glb.readUInt32LE(12)));
  assert.equal(gltf.accessors[3].count, model.triangles.length);
  const image = gltf.bufferViews[gltf.images[0].bufferView];
  const start = 28 + glb.readUInt32LE(12) + image.byteOffset;
  assert.equal(glb.toString("latin1", start + 1, start + 4), "PNG");
  const indices = gltf.bufferViews[3];
  for (let i = 0; i < gltf.accessors[3].count; i += 31)
    assert.ok(glb.readUInt32LE(28 + glb.readUInt32LE(12) + indices.byteOffset + 4 * i) < gltf.accessors[0].count);
});

test("coloured files have the colours that are shown", async () => {
  const rowsOf = async (colouring) => {
    await page.evaluate((which) => window.page.stage.choose(which), colouring);
    const [file] = await Promise.all([page.waitForEvent("download"), page.click("#save-ply")]);
    const path = join(folder, file.suggestedFilename());
    await file.saveAs(path);
    const [head, rows] = readFileSync(path, "utf8").split("end_header\n");
    const vertices = Number(/element vertex (\d+)/.exec(head)[1]);
    return new Set(rows.split("\n").slice(0, vertices).map((row) => row.split(" ").slice(3, 6).join(" ")));
  };
  assert.equal((await rowsOf("checker")).size, 2);
  assert.equal((await rowsOf("plain")).size, 1);
  // the scale is that of the colours
  const ends = await page.evaluate(() => {
    window.page.stage.choose("angle");
    return [window.page.stage.recolour().high, document.querySelector("#legend .ends span:last-child").textContent];
  });
  assert.equal(`${((ends[0] * 180) / Math.PI).toFixed(1)}°`, ends[1]);
});

test("exponents that cannot be are put right", async () => {
  await page.selectOption("#method", "balanced");
  await page.fill("#spring-exponent", "1");
  await page.locator("#spring-exponent").blur();
  assert.equal(await page.inputValue("#spring-exponent"), "2");
  await page.selectOption("#method", "automatic");
  await page.waitForFunction(() => document.body.dataset.state === "certified", null, { timeout: 60_000 });
});

test("maps of any size, and flat ones, are drawn", async () => {
  const tetrahedron = (size, z = size) => `OFF\n4 4 0\n0 0 0\n${size} 0 0\n0 ${size} 0\n0 0 ${z}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n`;
  for (const [name, content] of Object.entries({
    "large.off": tetrahedron("1e200"),
    "flat.off": "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
  })) {
    await page.setInputFiles("#file", { name, mimeType: "text/plain", buffer: Buffer.from(content) });
    await state(name, "certified");
    assert.ok(await page.isVisible("#save-sphere"));
  }
});

test("surfaces that meet in a vertex have no half handles", async () => {
  const half = (z) => [`1 0 ${z}`, `0 1 ${z}`, `-1 -1 ${z}`].join("\n");
  const content = `OFF\n7 8 0\n0 0 0\n${half(1)}\n${half(-1)}\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n3 0 5 4\n3 0 6 5\n3 0 4 6\n3 4 5 6\n`;
  await page.setInputFiles("#file", { name: "pinched.off", mimeType: "text/plain", buffer: Buffer.from(content) });
  await state("pinched.off", "refused");
  assert.equal(await page.locator("#marked").count(), 0);
  await page.click(`[data-example="${examples[2].file}"]`); // for the tests that follow
  await state(examples[2].file, "certified");
});

test("a download for which there is no memory", async () => {
  await page.evaluate(() => {
    window.createObjectURL = URL.createObjectURL;
    URL.createObjectURL = () => {
      throw new RangeError("Invalid string length");
    };
  });
  await page.click("#save-glb");
  await page.waitForFunction(() => document.getElementById("unsaved").textContent !== "");
  assert.equal(await text("#unsaved"), "Not saved: Invalid string length; use the command-line tool.");
  await shot("unsaved");
  await page.evaluate(() => (URL.createObjectURL = window.createObjectURL));
});

test("refuses a torus, and marks its handle", async () => {
  const file = write(folder, "torus.off", off(torus(60, 30)));
  await page.setInputFiles("#file", file);
  await state("torus.off", "refused");
  assert.equal(await page.getAttribute("#certificate", "data-code"), "WRONG_GENUS");
  assert.ok((await text("#certificate")).includes(said(native(file, folder).error)));
  assert.match(await text("#marked"), /1 handle\./);
  assert.ok(await page.isHidden("#downloads"));
  await shot("torus");
});

test("refuses a mesh with a hole, and what is no mesh", async () => {
  const [head, ...lines] = off(examples[2].mesh()).trim().split("\n");
  const [n, m] = lines[0].split(" ").map(Number);
  const open = [head, `${n} ${m - 40} 0`, ...lines.slice(1, -40)].join("\n") + "\n";
  await page.setInputFiles("#file", write(folder, "open.off", open));
  await state("open.off", "refused");
  assert.match(await text("#marked"), /\d+ holes?\./);
  await shot("hole");
  await page.setInputFiles("#file", write(folder, "words.off", "these are words\n"));
  await state("words.off", "refused");
  assert.equal(await page.getAttribute("#certificate", "data-code"), "UNREADABLE_FILE");
});

/// Drops files into the page; `meanwhile` is called when they are in the hand.
async function dropAll(files, meanwhile = () => {}) {
  await page.setInputFiles("#carrier", files);
  meanwhile();
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    for (const file of document.getElementById("carrier").files) dataTransfer.items.add(file);
    document.dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true }));
  });
}

/// A file that is dropped into the page: the verdict and the words of the tool, and its coordinates.
async function drop(file) {
  const name = basename(file);
  const isRead = page.waitForFunction((n) => document.getElementById("file-name").textContent === n, name, { timeout: 300_000 });
  await page.evaluate(() => (document.getElementById("file-name").textContent = ""));
  await dropAll(file);
  await isRead;
  await page.waitForFunction(() => ["certified", "refused"].includes(document.body.dataset.state), null, { timeout: 600_000 });
  const expected = native(file, folder);
  const shown = await text("#certificate");
  if (expected.error !== null) {
    assert.equal(await page.evaluate(() => document.body.dataset.state), "refused", name);
    assert.ok(shown.includes(said(expected.error).split(/[:;]/)[0]), `${shown}\n${expected.error}`);
    return;
  }
  assert.match(shown, /^Certified\s+0 of [\d,]+ faces flipped, degree 1\./, name);
  const found = await page.evaluate(() => Array.from(window.page.stage.model.sphere));
  assert.equal(different(found, Array.from(expected.sphere)), 0, name);
}

test("dropped files have the verdict of the tool", async () => {
  await page.selectOption("#method", "automatic");
  await page.evaluate(() => document.body.insertAdjacentHTML("beforeend", '<input id="carrier" type="file" multiple hidden>'));
  await drop(write(folder, "dropped.off", off(examples[2].mesh())));
  await drop(write(folder, "holed.off", off(torus(40, 20))));
});
for (const file of own) test(`unseen: ${basename(file)}`, () => drop(file));

test("what cannot be opened is refused in a sentence, and nothing else is shown", async () => {
  const refused = async (name, words) => {
    await state(name, "refused");
    assert.match(await text("#certificate"), words);
    assert.ok(await page.isHidden("#downloads"));
    assert.ok(await page.evaluate(() => window.page.stage.model === null));
  };
  const [one, two] = ["one.off", "two.off"].map((name) => write(folder, name, off(small())));
  await dropAll([one, two]);
  await refused("2 files", /^Refused\s+2 files: drop one at a time/);
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
  await dropAll(two, () => rmSync(two));
  await refused("two.off", /^Refused\s+two\.off: cannot be read/);
});

test("the file that was chosen last is opened, also if another one takes longer to read", async () => {
  await page.evaluate(() => {
    const { arrayBuffer } = Blob.prototype;
    Blob.prototype.arrayBuffer = async function () {
      if (this.name === "one.off") await new Promise((done) => (window.goOn = done));
      return arrayBuffer.call(this);
    };
  });
  await dropAll(write(folder, "one.off", off(small())));
  await page.click('[data-example="bar.off"]');
  await page.evaluate(() => window.goOn());
  await state("bar.off", "certified");
});

test("a file for which there is no memory", async () => {
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = () => {
      Worker.prototype.postMessage = postMessage;
      throw new DOMException("out of memory", "DataCloneError");
    };
  });
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "failed");
  assert.match(await text("#certificate"), /^Refused\s+bar\.off: out of memory; use the command-line tool/);
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
});

/// Begins a run of many seconds on the asteroid (with exponent 60), and waits until it is under way.
async function begin(name, method, spring) {
  await page.selectOption("#method", method);
  if (spring) {
    await page.fill("#spring-exponent", spring);
    await page.locator("#spring-exponent").blur();
  }
  await page.setInputFiles("#file", write(folder, name, off(examples[1].mesh())));
  await page.waitForFunction(
    (n) => document.getElementById("file-name").textContent === n && document.getElementById("bar").value > 0,
    name,
    { timeout: 120_000 },
  );
}

test("a long run shows progress, and can be cancelled", async () => {
  await begin("early.off", "balanced", "60");
  await shot("running");
  const frames = await page.evaluate(
    () => new Promise((done) => {
      let n = 0;
      const count = () => {
        if (document.body.dataset.state === "running" && ++n < 5) return requestAnimationFrame(count);
        document.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape" }));
        done(n);
      };
      requestAnimationFrame(count);
    }),
  );
  assert.equal(frames, 5); // it draws while it maps
  await state("early.off", "cancelled");
  // how far it came depends on the machine
  const hasMap = await page.evaluate(() => window.page.stage.model.sphere !== undefined);
  assert.match(await text("#result"), hasMap ? /^Cancelled: the best map so far/ : /^Cancelled: there is no map/);
});

test("a cancelled run leaves the best map so far, and the page goes on", async () => {
  await begin("late.off", "balanced", "60");
  await page.keyboard.press("?");
  await page.keyboard.press("Escape"); // the help only
  assert.ok(await page.isHidden("#help"));
  await page.waitForFunction(() => document.getElementById("bar").value > 0.1, null, { timeout: 120_000 });
  await page.click("#cancel");
  await state("late.off", "cancelled");
  assert.equal(await page.getAttribute("#certificate", "data-code"), "INTERRUPTED");
  assert.match(await text("#certificate"), /^Cancelled: the best map so far\s+[\d,]+ of 81,920 faces flipped, degree -?\d+\./);
  const lengths = await page.evaluate(() => {
    const { sphere } = window.page.stage.model;
    return Array.from({ length: sphere.length / 3 }, (_, v) => Math.hypot(...sphere.slice(3 * v, 3 * v + 3)));
  });
  assert.ok(lengths.length === 40962 && lengths.every((l) => Math.abs(l - 1) < 1e-12));
  assert.ok(await page.isVisible("#downloads"));
  await shot("cancelled");
  await page.fill("#spring-exponent", "2");
  await page.locator("#spring-exponent").blur();
  await state("late.off", "certified");
});

test("a file that is opened while another one is mapped is refused without the mesh of that", async () => {
  await begin("before.off", "balanced", "60");
  await page.setInputFiles("#file", write(folder, "words.off", "these are words\n"));
  await state("words.off", "refused");
  assert.ok(await page.evaluate(() => window.page.stage.model === null));
  assert.equal(await page.locator("#marked").count(), 0);
});

test("narrow and dark, by touch", async () => {
  const wide = page;
  page = await open(url(), { viewport: { width: 390, height: 844 }, colorScheme: "dark", hasTouch: true, isMobile: true });
  await page.tap('[data-example="bar.off"]');
  await state("bar.off", "certified");
  const box = await page.locator("#canvas").boundingBox();
  const cdp = await page.context().newCDPSession(page);
  const touch = (...touchPoints) => // all fingers that are on the screen now
    cdp.send("Input.dispatchTouchEvent", { type: touchPoints.length > 0 ? "touchStart" : "touchEnd", touchPoints });
  const told = (is) =>
    page.waitForFunction((t) => (document.getElementById("hover").textContent !== "") === t, is, { timeout: 120_000 });
  await touch({ x: box.x + box.width / 2, y: box.y + 0.75 * box.height });
  await told(true);
  await touch();
  await page.evaluate(() => new Promise(requestAnimationFrame));
  await told(true); // it stays when the finger is lifted
  await touch({ x: box.x + 5, y: box.y + 0.75 * box.height }); // beside the sphere
  await told(false);
  await touch();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth)); // nothing sticks out

  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await ground(), "rgb(21, 24, 27)"); // dark, as the system
  await page.tap("#theme");
  assert.equal(await ground(), "rgb(244, 244, 241)");
  await page.tap("#theme");
  assert.equal(await ground(), "rgb(21, 24, 27)");

  // two fingers that part and move to the right: larger, and to the right
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 4];
  const fingers = (type, apart, along) =>
    cdp.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x: x - apart + along, y, id: 1 }, { x: x + apart + along, y, id: 2 }],
    });
  const camera = () => page.evaluate(() => (({ zoom, shift }) => ({ zoom, x: shift.x, y: shift.y }))(window.page.stage.viewer));
  const before = await camera();
  await fingers("touchStart", 20, 0);
  for (let i = 1; i <= 8; ++i) await fingers("touchMove", 20 + 5 * i, 3 * i);
  await fingers("touchEnd");
  const after = await camera();
  assert.ok(Math.abs(after.zoom / before.zoom - 3) < 0.3, `${after.zoom}`);
  assert.ok(after.x > before.x && Math.abs(after.y - before.y) < 1e-6);
  await shot("narrow");
  await page.context().close();
  page = wide;
});

test("uses all cores where the server permits it, and has the same bits where it does not", async () => {
  const example = examples.find(({ file }) => file === "bar.off");
  const ask = async (...options) => {
    const asked = new Set();
    const other = await serve(0, ...options);
    other.on("request", ({ url }) => asked.add(url));
    const wide = page;
    page = await open(`http://127.0.0.1:${other.address().port}/`);
    await page.click(`[data-example="${example.file}"]`);
    await state(example.file, "certified");
    const { sphere, policy } = await page.evaluate(() => {
      const { sphere, report } = window.page.stage.model;
      return { sphere: Array.from(sphere), policy: report.settings.policy };
    });
    await page.context().close();
    other.close();
    page = wide;
    return { sphere, policy, allCores: asked.has("/threads.js") };
  };
  const [all, one] = [await ask(), await ask({})];
  assert.deepEqual([all.allCores, one.allCores], [true, false]);
  assert.deepEqual([all.policy, one.policy], ["tbb", "sequential"]);
  assert.equal(different(all.sphere, one.sphere), 0);
});

test("uses one core where the server permits threads, but the file for them is missing", async () => {
  const other = createServer((request, response) =>
    request.url === "/" ? server.emit("request", request, response) : response.writeHead(404).end(),
  );
  await new Promise((done) => other.listen(0, "127.0.0.1", done));
  const wide = page;
  page = await (await browser.newContext()).newPage(); // that a file is missing is a complaint
  await page.goto(`http://127.0.0.1:${other.address().port}/`);
  assert.ok(await page.evaluate(() => crossOriginIsolated));
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
  await page.context().close();
  other.close();
  page = wide;
});

test("works from a file, too, and the file of `view`", async () => {
  const wide = page;
  page = await open(pathToFileURL(join(web, "dist", "index.html")).href);
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
  await page.context().close();

  const html = join(folder, "bar.html");
  execFileSync(tool, ["view", join(folder, "bar.off"), "-o", html]);
  assert.ok(statSync(html).size < 3_000_000);
  page = await open(pathToFileURL(html).href, { offline: true });
  await state("bar.off", "shown");
  assert.match(await text("#certificate"), /^Certified\s+0 of [\d,]+ faces flipped, degree 1\./);
  const expected = native(join(folder, "bar.off"), folder).sphere;
  const found = await page.evaluate(() => Array.from(window.page.stage.model.sphere));
  assert.ok(Math.max(...found.map((x, i) => Math.abs(x - expected[i]))) < 2e-5);
  await page.keyboard.press("3");
  await shot("view");
  await page.context().close();
  page = wide;
});

test("maps without WebGL, and says that it cannot draw; the file of `view`, too", async () => {
  const blind = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-3d-apis"] });
  const wide = page;
  page = await blind.newPage();
  await page.goto(url());
  await page.click('[data-example="bar.off"]');
  await state("bar.off", "certified");
  assert.match(await text("#no-webgl"), /no WebGL 2/);
  await page.hover("#canvas");
  await page.click("#play");
  assert.ok(await page.isVisible("#downloads"));
  await shot("no_webgl");
  await page.goto(pathToFileURL(join(folder, "bar.html")).href);
  await state("bar.off", "shown");
  assert.match(await text("#no-webgl"), /no WebGL 2/);
  assert.match(await text("#certificate"), /^Certified/);
  await blind.close();
  page = wide;
});

test("the file of `morph`", async () => {
  const [a, b] = ["a.off", "b.off"].map((name) => join(folder, name));
  const mesh = small();
  write(folder, "a.off", off(mesh));
  write(folder, "b.off", off({ ...mesh, points: mesh.points.map((x, i) => (i % 3 === 0 ? 1.5 * x : x)) }));
  execFileSync(tool, ["morph", a, b, "-o", join(folder, "way"), "--steps", "1"]);
  const wide = page;
  page = await open(pathToFileURL(join(folder, "way", "morph.html")).href, { offline: true });
  await state("a.off to b.off", "shown");
  await page.waitForFunction(() => window.page.stage.viewer.morph > 0.1, null, { timeout: 120_000 }); // it plays
  const seen = {};
  for (const key of ["Home", "End"]) {
    await page.focus("#morph");
    await page.keyboard.press(key);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    seen[key] = { label: await text("#label-mesh"), morph: await page.evaluate(() => window.page.stage.viewer.morph) };
    await shot(`morph_${key}`);
  }
  assert.deepEqual(seen, { Home: { label: "a.off", morph: 0 }, End: { label: "b.off", morph: 1 } });
  assert.match(await text("#certificate"), /Lengths of A change/);
  // the ends have the extents of the meshes, up to the motion between them
  const width = (k) => page.evaluate((k) => {
    const xs = window.page.stage.viewer.shapes.at(k).place.array.filter((_, i) => i % 3 === 0);
    return xs.reduce((m, x) => Math.max(m, x), -Infinity) - xs.reduce((m, x) => Math.min(m, x), Infinity);
  }, k);
  assert.ok(Math.abs((await width(-1)) / (await width(0)) - 1.5) < 0.05);
  await page.context().close();
  page = wide;
});

test("nothing was complained about", () => assert.deepEqual(complaints, []));
