// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// What `npm run package` leaves: installed into an empty folder, in node and in a page, it maps as the tool does.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";

import { chromium } from "playwright-core";

import { different, native, source, web, write } from "./helpers.mjs";

const { small } = await source("examples.ts");
const { off } = await source("downloads.ts");
const folder = mkdtempSync(join(tmpdir(), "package-"));
after(() => rmSync(folder, { recursive: true }));
const run = (program, args, options = {}) => execFileSync(program, args, { cwd: folder, encoding: "utf8", ...options });

const packed = JSON.parse(run("npm", ["pack", "--json", "--pack-destination", folder, join(web, "dist", "package")]));
const [{ filename, size, version }] = packed;
write(folder, "package.json", "{}");
run("npm", ["install", "--offline", "--no-audit", "--no-fund", `./${filename}`]);
const installed = join(folder, "node_modules", "spherical-parameterization");

const mesh = small();
const expected = native(write(folder, "small.off", off(mesh)), folder, ["--method", "automatic"]).sphere;

test("it is small, and of the version of the tool", () => {
  assert.ok(size < 1_000_000, String(size));
  const tool = run(process.env.SPHERICAL_PARAMETERIZATION_TOOL, ["--version"]);
  assert.ok(tool.includes(version), tool);
});

test("its own tests", () => {
  const { NODE_TEST_CONTEXT, ...env } = process.env; // it would report to this test instead
  assert.match(run("npm", ["test"], { cwd: installed, env }), /pass [1-9]\d+\n[^]*fail 0\n/);
});

test("in node", () => {
  write(
    folder,
    "map.mjs",
    `import { readFileSync } from "node:fs";
     import { load } from "spherical-parameterization";
     const sp = await load();
     const { points, triangles } = sp.readMesh("small.off", readFileSync("small.off"));
     process.stdout.write(JSON.stringify(Array.from(sp.parameterize(points, triangles).sphere)));`,
  );
  assert.equal(different(JSON.parse(run("node", ["map.mjs"], { maxBuffer: 2 ** 26 })), expected), 0);
});

test("in a page", async () => {
  const page = `<!doctype html><link rel="icon" href="data:,"><script type="module">
    import { load } from "/index.js";
    window.map = async (points, triangles) =>
      Array.from((await load()).parameterize(Float64Array.from(points), Uint32Array.from(triangles)).sphere);
    </script>`;
  const server = createServer(({ url }, response) => {
    const isScript = url === "/index.js";
    response.writeHead(200, { "Content-Type": isScript ? "text/javascript" : "text/html" });
    response.end(isScript ? readFileSync(join(installed, "index.js")) : page);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  try {
    const tab = await browser.newPage();
    await tab.goto(`http://127.0.0.1:${server.address().port}/`);
    await tab.waitForFunction(() => window.map);
    const found = await tab.evaluate(([p, t]) => window.map(p, t), [Array.from(mesh.points), Array.from(mesh.triangles)]);
    assert.equal(different(found, expected), 0);
  } finally {
    await browser.close();
    server.close();
  }
});

test("its types are those of what it does", () => {
  const use = (text) => {
    writeFileSync(join(folder, "use.ts"), `import { load, type Result } from "spherical-parameterization";\nconst sp = await load();\n${text}`);
    const options = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--lib", "es2022"];
    return run(join(web, "node_modules", ".bin", "tsc"), [...options, "use.ts"]);
  };
  const points = "new Float64Array(12), new Uint32Array(12)";
  write(folder, "package.json", '{ "type": "module" }');
  use(`const r: Result = sp.parameterize(${points}, { method: "isometric", progress: (s) => s < 1 });
    const n: number = sp.measure(${points}, r.sphere!).distortion.dilatation.mean; void n;`);
  assert.throws(() => use(`sp.parameterize(${points}, { method: "other" });`));
  assert.throws(() => use("sp.parameterize([0, 0, 0], [0, 1, 2]);"));
});
