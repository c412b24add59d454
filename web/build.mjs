// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// node build.mjs: the core by emscripten; then the package of npm, dist/package/; and the page, dist/index.html, one file
// with everything in it. Beside it, for servers, the core for all cores of the machine: dist/threads.js, dist/threads.worker.js.
// node build.mjs --viewer: viewer/view.html alone, which the tool's command `view` fills with data; needs no emscripten.

import { build } from "esbuild";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const source = (name) => readFileSync(join(here, "src", name), "utf8");
const [core, threads] = ["core", "threads"].map((name) => join(here, "build", name)); // for one core, and for all

async function script(entry, plugins = [], format = "iife") {
  const result = await build({
    entryPoints: [join(here, entry)],
    bundle: true,
    minify: true,
    format,
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
  const page = (await html(await script("src/view_page.ts"), data))
    .replace("<body ", '<body class="view-page" ')
    .replace(/<section class="page-only"[^]*?<\/section>\s*/g, "");
  mkdirSync(join(here, "viewer"), { recursive: true });
  writeFileSync(join(here, "viewer", "view.html"), page + (page.endsWith("\n") ? "" : "\n"));
}

function compile(folder, ...options) {
  const env = {
    ...process.env,
    NODE_PATH: "/usr/share/nodejs", // where Debian has acorn, which emscripten needs
    // Debian's emscripten takes 14, which has one place for the exceptions of all threads
    EM_CLANG_ADD_VERSION: process.env.EM_CLANG_ADD_VERSION ?? "15",
  };
  const run = (program, ...args) => execFileSync(program, args, { cwd: here, env, stdio: ["ignore", "inherit", "inherit"] });
  if (!existsSync(join(folder, "Makefile")))
    run("emcmake", "cmake", "-S", join(here, "core"), "-B", folder, "-DCMAKE_BUILD_TYPE=Release", ...options);
  run("cmake", "--build", folder, "--parallel", "2");
}

const compiled = provide("core", () => readFileSync(join(core, "core.js"), "utf8"), "js");

const of = (...path) => readFileSync(join(here, ...path), "utf8");

/// Of the libraries that are compiled into the core.
function licences() {
  const ofDebian = (name) => [name, readFileSync(`/usr/share/doc/${name}/copyright`, "utf8")];
  return [
    ...["libcgal-dev", "libboost-dev", "nlohmann-json3-dev", "libfast-float-dev", "emscripten"].map(ofDebian),
    ["pugixml", of("libraries/pugixml/LICENSE.md")],
    ["zlib", of("libraries/zlib/LICENSE")],
  ]
    .map(([name, text]) => `==== ${name} ====\n\n${text}`)
    .join("\n");
}

/// What `npm pack` takes: JavaScript with the core inside, types, documents, tests.
async function npmPackage() {
  const folder = join(here, "dist", "package");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const head = "// SPDX-License-Identifier: LGPL-3.0-or-later\n";
  writeFileSync(join(folder, "index.js"), head + (await script("core/index.ts", [compiled], "esm")) + "\n");
  const tsc = ["--declaration", "--stripInternal", "--emitDeclarationOnly", "--noEmit", "false", "--outDir", folder, "--target", "es2022"];
  const sources = ["core/index.ts", "src/modules.d.ts"].map((name) => join(here, name));
  execFileSync(join(here, "node_modules", ".bin", "tsc"), [...tsc, ...sources], { stdio: "inherit" });
  const version = /VERSION "(.*)"/.exec(of("../include/CGAL/Spherical_parameterization/version.h"))[1];
  const manifest = { ...JSON.parse(of("core", "package.json")), version };
  writeFileSync(join(folder, "package.json"), JSON.stringify(manifest, null, 2) + "\n");
  cpSync(join(here, "core", "README.md"), join(folder, "README.md"));
  cpSync(join(here, "core", "test"), join(folder, "test"), { recursive: true });
  for (const name of ["LICENSE", "LICENSE.GPL"]) cpSync(join(here, "..", name), join(folder, name));
  writeFileSync(join(folder, "LICENSES.txt"), licences());
}

async function page() {
  const worker = await script("src/worker.ts", [compiled]);
  const js = await script("src/page.ts", [provide("worker-text", () => worker, "text")]);
  const inComment = licences().replaceAll("-->", "-- >").replaceAll("*/", "* /");
  writeFileSync(join(here, "dist", "index.html"), `${await html(js, "")}<!-- The core of the page contains:\n\n${inComment}-->\n`);
  const head = "// SPDX-License-Identifier: LGPL-3.0-or-later AND Apache-2.0\n// Part of CGAL Spherical Parameterization. ";
  const contents = `Contains:\n/*\n${inComment}\n==== oneTBB ====\n\n${of("libraries/onetbb/LICENSE.txt")}*/\n`;
  writeFileSync(join(here, "dist", "threads.js"), head + contents + of("build/threads/core.js"));
  writeFileSync(join(here, "dist", "threads.worker.js"), `${head}Licences: see threads.js.\n${of("build/threads/core.worker.js")}`);
}

await viewer();
if (!process.argv.includes("--viewer")) {
  compile(core);
  compile(threads, "-DTHREADS=ON");
  await npmPackage();
  await page();
}
