// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// node serve.mjs [PORT]: serves dist/ on this machine, compressed. Any other static server does, too.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const file = join(dirname(fileURLToPath(import.meta.url)), "dist", "index.html");

/// Resolves to the server, which listens on `port`, or on any that is free for 0.
export function serve(port) {
  const page = gzipSync(readFileSync(file), { level: 9 });
  const server = createServer((request, response) => {
    const found = request.method === "GET" && /^\/(index\.html)?(\?.*)?$/.test(request.url);
    response.writeHead(found ? 200 : 404, found ? { "Content-Type": "text/html", "Content-Encoding": "gzip" } : {});
    response.end(found ? page : undefined);
  });
  return new Promise((done) => server.listen(port, "127.0.0.1", () => done(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(Number(process.argv[2] ?? 8080));
  console.log(`http://localhost:${server.address().port}/`);
}
