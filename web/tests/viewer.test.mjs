// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// viewer/view.html, which is in the tree so that the tool needs no npm, is what the sources make.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { web } from "./helpers.mjs";

test("viewer/view.html is built from the sources", () => {
  const file = join(web, "viewer", "view.html");
  const before = readFileSync(file, "utf8");
  try {
    execFileSync("node", [join(web, "build.mjs"), "--viewer"]);
    assert.ok(readFileSync(file, "utf8") === before, "it is another one: run node web/build.mjs --viewer, and commit it");
  } finally {
    writeFileSync(file, before);
  }
});
