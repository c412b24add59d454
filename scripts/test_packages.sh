#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: test_packages.sh OUT [TOOL]
# Installs each product of make_packages.sh in OUT into a Debian 12 of its own without compilers, made by debootstrap, maps CGAL's
# armadillo there and mends its elephant, where it can, and compares the results bit for bit with those of TOOL (default: the tool
# that make_packages.sh has built). As root.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
out=$(cd "${1:?usage: test_packages.sh OUT [TOOL]}" && pwd)
tool=${2:-$root/build-packages/src/spherical-parameterization}
packages=(debootstrap)
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
"$root/scripts/install_dependencies.sh" "${packages[@]}"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
meshes=/usr/share/doc/libcgal-dev/data.tar.gz
[ -e "$meshes" ] || meshes=/usr/share/doc/libcgal-demo/data.tar.gz
tar -xzf "$meshes" -C "$scratch" --strip-components=2 data/meshes/{armadillo,elephant-with-holes}.off
"$tool" map "$scratch/armadillo.off" -o "$scratch/sphere.off"
"$tool" prepare "$scratch/elephant-with-holes.off" -o "$scratch/mended.off"

debootstrap --variant=minbase bookworm "$scratch/debian" http://deb.debian.org/debian >"$scratch/log" || { cat "$scratch/log"; exit 1; }

# clean_place PACKAGES...: a Debian with the meshes, what has been made, and these packages of Debian
clean_place() {
  place=$scratch/place
  rm -rf "$place"
  cp -a "$scratch/debian" "$place"
  mkdir "$place/work"
  cp "$scratch"/*.off "$out"/* "$place/work"
  there apt-get update
  [ $# -eq 0 ] || there apt-get install -y --no-install-recommends "$@"
}
there() {
  unshare --mount --pid --fork --mount-proc --root="$place" --wd=/work \
    env -i PATH=/venv/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@" \
    </dev/null >"$scratch/log" 2>&1 || { cat "$scratch/log"; echo "test_packages.sh: FAILED: $*" >&2; exit 1; }
}
without_compiler() {
  if chroot "$place" sh -c 'which cc c++ gcc g++ clang cmake make | grep .'; then
    echo "test_packages.sh: there is a compiler"
    exit 1
  fi
}
# same FILE REFERENCE: written there
same() { cmp "$place/work/$1" "$scratch/$2"; }
try_tool() {
  there "$1" map armadillo.off -o out.off
  same out.off sphere.off
  there "$1" prepare elephant-with-holes.off -o out.off
  same out.off mended.off
}
passed() { without_compiler; echo "passed: $*"; }

clean_place
try_tool "./spherical-parameterization-linux-$(uname -m)"
passed "the static tool"

version=$(sed -n 's/.*_VERSION "\(.*\)"/\1/p' "$root/include/CGAL/Spherical_parameterization/version.h")
clean_place python3 python3-numpy python3-venv
there python3 -m venv --system-site-packages /venv
there pip install --no-index --find-links . "spherical-parameterization==$version"
there python3 -c 'import numpy, spherical_parameterization as sp
assert numpy.array_equal(sp.parameterize(*sp.read_mesh("armadillo.off")).sphere, sp.read_mesh("sphere.off")[0])'
passed "the wheel"
there pip install --no-index --find-links . "spherical-parameterization-preparation==$version"
try_tool spherical-parameterization
there python3 -c 'import numpy, spherical_parameterization as sp
mended, known = sp.prepare(*sp.read_mesh("elephant-with-holes.off")), sp.read_mesh("mended.off")
assert numpy.array_equal(mended.points, known[0]) and numpy.array_equal(mended.triangles, known[1])'
passed "the wheel with preparation and tool"

clean_place
there sh -c 'apt-get install -y --no-install-recommends ./*.deb'
try_tool spherical-parameterization
there python3 -c 'import numpy, spherical_parameterization as sp
assert numpy.array_equal(sp.parameterize(*sp.read_mesh("armadillo.off")).sphere, sp.read_mesh("sphere.off")[0])
sp.prepare(*sp.read_mesh("elephant-with-holes.off"))'
passed "the .deb files"

mkdir "$scratch/npm"
cd "$scratch/npm"
npm install --silent --offline --no-audit --no-fund "$out"/*.tgz
cat >map.mjs <<'END'
import { readFileSync } from "node:fs";
import assert from "node:assert";
import { load } from "spherical-parameterization";
const sp = await load();
const read = name => sp.readMesh(name, new Uint8Array(readFileSync(`../${name}`)));
const { points, triangles } = read("armadillo.off");
assert.deepEqual(sp.parameterize(points, triangles).sphere, read("sphere.off").points);
END
node map.mjs
echo "passed: the npm package"
