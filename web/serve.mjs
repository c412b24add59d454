// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// node serve.mjs [PORT]: serves dist/ on this machine, compressed. Any other static server does, too; with the same two headers the
// page may share memory between threads, and uses all cores.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const dist = join(dirname(fileURLToPath(import.meta.url)), "dist");
const isolated = { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" };

/// Resolves to the server, which listens on `port`, or on any that is free for 0.
export function serve(port, headers = isolated) {
  const files = new Map(
    ["index.html", "threads.js", "threads.worker.js"].map((name) => {
      const type = name.endsWith(".html") ? "text/html" : "text/javascript";
      const body = gzipSync(readFileSync(join(dist, name)), { level: 9 });
      return [`/${name}`, { body, headers: { "Content-Type": type, "Content-Encoding": "gzip", ...headers } }];
    }),
  );
  files.set("/", files.get("/index.html"));
  const server = createServer((request, response) => {
    const found = request.method === "GET" && files.get(request.url.replace(/\?.*/, ""));
    response.writeHead(found ? 200 : 404, found?.headers);
    response.end(found?.body);
  });
  return new Promise((done, fail) => server.on("error", fail).listen(port, "127.0.0.1", () => done(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const remedies = { ENOENT: "build it by: node web/build.mjs", EADDRINUSE: "choose another port: node web/serve.mjs PORT" };
  try {
    const server = await serve(Number(process.argv[2] ?? 8080));
    console.log(`http://localhost:${server.address().port}/`);
  } catch (error) {
    if (!(error.code in remedies)) throw error;
    console.error(`serve.mjs: ${error.message}; ${remedies[error.code]}`);
    process.exitCode = 1;
  }
}
