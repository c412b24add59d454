// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// SPHERICAL_PARAMETERIZATION_TOOL=TOOL node measure.mjs MESH...: size and first picture of the page; for each mesh the
// seconds of its map in the browser and by the tool on one core, and frames per second while it turns and while it maps.
// Medians of five. With ONE_CORE=1 the page is served so that it cannot use more.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { gzipSync } from "node:zlib";

import { chromium } from "playwright-core";

import { serve } from "./serve.mjs";
import { web } from "./tests/helpers.mjs";

const meshes = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "measure-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
const median = (numbers) => numbers.sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const five = async (one) => {
  const results = [];
  for (let i = 0; i < 5; ++i) results.push(await one());
  return median(results);
};
/// Of the phases that both have: the map and its certificate, without reading.
const mapping = ({ start_map, solve, certify }) => start_map + solve + certify;

const server = await serve(0, process.env.ONE_CORE ? {} : undefined);
const url = `http://127.0.0.1:${server.address().port}/`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

/// A new page, when the mesh of its example has been drawn; and the milliseconds until then.
async function open() {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.addInitScript(() => {
    const look = () =>
      document.body?.classList.contains("has-mesh")
        ? requestAnimationFrame(() => requestAnimationFrame(() => (window.firstPicture = performance.now())))
        : requestAnimationFrame(look);
    look();
  });
  await page.goto(url);
  await page.waitForFunction(() => window.firstPicture);
  return { page, first: await page.evaluate(() => window.firstPicture) };
}

console.log(`compressed ${Math.round(gzipSync(readFileSync(join(web, "dist", "index.html"))).length / 1000)} kB`);
const first = await five(async () => {
  const { page, first } = await open();
  await page.context().close();
  return first;
});
console.log(`first picture ${Math.round(first)} ms`);

const { page } = await open();
await page.selectOption("#method", "balanced");
const framesPerSecond = () =>
  page.evaluate(
    () => new Promise((done) => {
      const times = [];
      const count = (time) => (times.push(time) < 40 ? requestAnimationFrame(count) : done(39e3 / (times[39] - times[0])));
      requestAnimationFrame(count);
    }),
  );
for (const mesh of meshes) {
  const isDone = () => page.waitForFunction(
    (name) => document.getElementById("file-name").textContent === name && document.body.dataset.state === "certified",
    basename(mesh),
    { timeout: 600_000 },
  );
  let whileMapping = 0;
  const inBrowser = await five(async () => {
    await page.setInputFiles("#file", mesh);
    await page.evaluate(() => window.page.stage.viewer.spin(1));
    whileMapping = await framesPerSecond();
    await page.evaluate(() => window.page.stage.viewer.spin(0));
    await isDone();
    return mapping(await page.evaluate(() => window.page.stage.model.report.seconds));
  });
  await page.evaluate(() => window.page.stage.viewer.spin(1));
  const whileTurning = await framesPerSecond();
  await page.evaluate(() => window.page.stage.viewer.spin(0));
  const byTool = await five(() => {
    const report = join(folder, "report.json");
    const options = ["--method", "balanced", "-o", join(folder, "sphere.off"), "--policy", "sequential", "--report", report];
    const run = spawnSync(process.env.SPHERICAL_PARAMETERIZATION_TOOL, ["map", mesh, ...options], { encoding: "utf8" });
    if (run.status !== 0) throw new Error(run.stderr);
    return mapping(JSON.parse(readFileSync(report, "utf8")).seconds);
  });
  console.log(
    `${basename(mesh)}: ${inBrowser.toFixed(3)} s, tool ${byTool.toFixed(3)} s, ratio ${(inBrowser / byTool).toFixed(2)}; ` +
      `frames per second: ${whileTurning.toFixed(0)} turning, ${whileMapping.toFixed(0)} in the last map's first seconds`,
  );
}
await browser.close();
server.close();
