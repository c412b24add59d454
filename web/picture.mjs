// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// node picture.mjs MESH OUT.png: the page with a mesh and its harmonic map; a face is marked in both views.

import { chromium } from "playwright-core";

import { serve } from "./serve.mjs";

const [mesh, out] = process.argv.slice(2);
const server = await serve(0);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
const certified = (name) =>
  page.waitForFunction(
    (n) => document.body.dataset.state === "certified" && document.getElementById("file-name").textContent.endsWith(n),
    name,
    { timeout: 120_000 },
  );
await page.goto(`http://127.0.0.1:${server.address().port}/`);
await certified("");
await page.selectOption("#method", "balanced");
await certified("");
await page.setInputFiles("#file", mesh);
await certified(mesh.replace(/.*\//, ""));
await page.evaluate(() => window.page.stage.viewer.turn(Math.PI, 0)); // armadillos look away
await page.mouse.move(225, 330);
await page.waitForFunction(() => document.getElementById("hover").textContent !== "");
await page.waitForTimeout(1000); // drawn once more, sharp
await page.screenshot({ path: out });
await browser.close();
server.close();
