#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install_dependencies.sh
# Installs what the page and its tests need besides the tool: emscripten, chromium, node, the npm packages of
# package-lock.json, and the sources of Expat and zlib, which Debian has compiled for other machines only. As root, or
# through sudo. Does nothing where all are there.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)

packages=(emscripten node-acorn libfast-float-dev chromium dpkg-dev)
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
"$here/../scripts/install_dependencies.sh" "${packages[@]}"

if ! cmp -s "$here/package-lock.json" "$here/node_modules/.lock-of-the-page"; then
  (cd "$here" && npm ci --no-audit --no-fund)
  cp "$here/package-lock.json" "$here/node_modules/.lock-of-the-page"
fi

# Sources of Debian's packages, with its patches, from where its packages come from, but without a change of its lists.
sources_of() {
  local work options
  work=$(mktemp -d)
  trap 'rm -rf "$work"' RETURN
  mkdir -p "$work/lists/partial" "$work/from" "$here/libraries"
  chmod -R a+rX "$work"
  if [ -s /etc/apt/sources.list ]; then sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$work/from/of.list"; fi
  for list in /etc/apt/sources.list.d/*.sources; do
    [ ! -e "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/from/$(basename "$list")"
  done
  options=(-q -o Acquire::Retries=5 -o "Dir::State::lists=$work/lists" -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$work/from")
  apt-get "${options[@]}" update
  local name
  for name; do
    # the release itself: what a mirror of updates lists, it does not always have
    (cd "$work" && apt-get "${options[@]}" -t "$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)" --only-source source "$name")
    rm -rf "$here/libraries/$name"
    mv "$work/$name"-*/ "$here/libraries/$name"
  done
}
if [ ! -d "$here/libraries/expat" ] || [ ! -d "$here/libraries/zlib" ]; then sources_of expat zlib; fi
