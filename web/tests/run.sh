#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh core|package|viewer|page TOOL
# Tests the page with the native tool TOOL. Where something is missing it says so in one line, and tests nothing.
set -euo pipefail
web=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
skip() {
  echo "SKIPPED: $1 is missing; web/install_dependencies.sh installs what the page and its tests need"
  exit 0
}
command -v node >/dev/null || skip node
[ -d "$web/node_modules/esbuild" ] || skip "web/node_modules"
if [ "$1" != viewer ]; then
  command -v emcmake >/dev/null || skip emscripten
  compiler=clang-${EM_CLANG_ADD_VERSION:-15}
  command -v "$compiler" >/dev/null || skip "$compiler"
  for library in onetbb pugixml zlib; do
    [ -d "$web/libraries/$library" ] || skip "web/libraries/$library"
  done
fi
if [ "$1" = page ] || [ "$1" = package ]; then
  command -v "${CHROMIUM:-chromium}" >/dev/null || skip chromium
  export CHROMIUM=${CHROMIUM:-$(command -v chromium)}
fi
export SPHERICAL_PARAMETERIZATION_TOOL=$2
cd "$web"
[ "$1" = viewer ] || flock build.mjs node build.mjs
node --test "tests/$1.test.mjs"
