#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install_dependencies.sh
# Installs what the page and its tests need besides the tool: emscripten, clang 15, chromium, node, the npm packages of
# package-lock.json, and the sources of oneTBB, pugixml and zlib, which Debian has compiled for other machines only. As root, or
# through sudo. Does nothing where all are there.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)

packages=(emscripten clang-15 node-acorn libfast-float-dev chromium dpkg-dev)
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
"$here/../scripts/install_dependencies.sh" "${packages[@]}"

if ! cmp -s "$here/package-lock.json" "$here/node_modules/.lock-of-the-page"; then
  (cd "$here" && npm ci --no-audit --no-fund)
  cp "$here/package-lock.json" "$here/node_modules/.lock-of-the-page"
fi

"$here/../scripts/fetch_sources.sh" "$here/libraries" onetbb pugixml zlib
