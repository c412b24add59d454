// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// node build.mjs: the core by emscripten, then the page: dist/index.html, one file with everything in it.
// node build.mjs --viewer: viewer/view.html alone, which the tool's command `view` fills with data; needs no emscripten.

import { build } from "esbuild";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const source = (name) => readFileSync(join(here, "src", name), "utf8");
const core = join(here, "build", "core");

async function script(entry, plugins = []) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    platform: "browser",
    charset: "ascii",
    legalComments: "none",
    write: false,
    logLevel: "warning",
    plugins,
  });
  return result.outputFiles[0].text.trim();
}

/// `import ... from name` gives `contents`.
const provide = (name, contents, loader) => ({
  name,
  setup(esbuild) {
    esbuild.onResolve({ filter: new RegExp(`^${name}$`) }, () => ({ path: name, namespace: name }));
    esbuild.onLoad({ filter: /.*/, namespace: name }, () => ({ contents: contents(), loader, resolveDir: here }));
  },
});

async function minified(css) {
  const result = await build({
    stdin: { contents: css, loader: "css" },
    minify: true,
    write: false,
    charset: "ascii",
  });
  return result.outputFiles[0].text.trim();
}

const licence =
  "<!-- SPDX-License-Identifier: GPL-3.0-or-later\nPart of CGAL Spherical Parameterization. Contains three.js:\n\n" +
  readFileSync(join(here, "node_modules", "three", "LICENSE"), "utf8").replaceAll("\u00a9", "(c)").trim() +
  " -->";

async function html(js, data) {
  return source("page.html")
    .replace("<!doctype html>", () => `<!doctype html>\n${licence}`)
    .replace("<!-- STYLE -->", `<style>${await minified(source("page.css"))}</style>`)
    .replace("<!-- STAGE -->", () => source("stage.html").trim())
    .replace("<!-- SCRIPT -->", () => `${data}<script>${js.replaceAll("</script", "<\\/script")}</script>`);
}

/// The page of `view`. The tool puts the report where {HEADER} stands, and the numbers for {DATA}.
async function viewer() {
  const data =
    '<script type="application/json" id="header">{HEADER}</script>\n<script type="text/plain" id="data">{DATA}</script>\n';
  const page = (await html(await script("view_page.ts"), data))
    .replace("<body ", '<body class="view-page" ')
    .replace(/<section class="page-only"[^]*?<\/section>\s*/g, "");
  mkdirSync(join(here, "viewer"), { recursive: true });
  writeFileSync(join(here, "viewer", "view.html"), page + (page.endsWith("\n") ? "" : "\n"));
}

function compileCore() {
  const env = { ...process.env, NODE_PATH: "/usr/share/nodejs" }; // where Debian has acorn, which emscripten needs
  const run = (program, ...args) => execFileSync(program, args, { cwd: here, env, stdio: ["ignore", "inherit", "inherit"] });
  if (!existsSync(join(core, "Makefile")))
    run("emcmake", "cmake", "-S", join(here, "core"), "-B", core, "-DCMAKE_BUILD_TYPE=Release");
  run("cmake", "--build", core);
}

async function page() {
  compileCore();
  const worker = await script("worker.ts", [
    provide("core", () => readFileSync(join(core, "core.js"), "utf8"), "js"),
    { name: "node", setup: (esbuild) => esbuild.onResolve({ filter: /^(fs|path)$/ }, ({ path }) => ({ path, external: true })) },
  ]);
  const js = await script("page.ts", [provide("worker-text", () => worker, "text")]);
  mkdirSync(join(here, "dist"), { recursive: true });
  writeFileSync(join(here, "dist", "index.html"), await html(js, ""));
}

await viewer();
if (!process.argv.includes("--viewer")) await page();
