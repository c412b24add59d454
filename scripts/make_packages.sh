#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: make_packages.sh OUT
# Installs what it needs, builds in build-packages/ and build-static/, and makes in OUT what can be installed without a compiler:
# for pip, wheels for every version of Python here that has its headers, setuptools and wheel, and the source distributions; .deb
# files; the tool as one file, with the licences of all that is in it; the npm package. scripts/test_packages.sh tests them.
# A wheel is for one version of Python each: pybind11 does not know Python's stable interface.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "${1:?usage: make_packages.sh OUT}"
out=$(cd "$1" && pwd)

"$root/scripts/install_dependencies.sh" file patchelf dpkg-dev \
  python3-dev pybind11-dev python3-numpy python3-pip python3-setuptools python3-wheel libbz2-dev liblzma-dev libzstd-dev

step() { printf '\n== %s\n' "$*"; }
build() { cmake --build "$1" --parallel "$(nproc)" "${@:2}"; }

step ".deb files"
build=$root/build-packages
options=(-DCMAKE_BUILD_TYPE=Release -DCGAL_SP_BUILD_TESTING=OFF -DCGAL_SP_WITH_EXAMPLES=OFF)
# -U: with the wheels of an earlier run, the folder is that of their last Python
cmake -S "$root" -B "$build" "${options[@]}" -U '*Python3*' -U 'PYTHON*' -U 'pybind11*' -DCGAL_SP_WITH_PYTHON=ON
build "$build"
(cd "$build" && cpack -G DEB && mv ./*.deb "$out")

# pythons: the first interpreter of each version that can make wheels
pythons() {
  local name python
  for name in $(compgen -c python3. | grep -x 'python3\.[0-9]*' | sort -uV); do
    for python in $(type -aP "$name"); do
      "$python" -c 'import pathlib, sysconfig, setuptools, wheel, pip
pathlib.Path(sysconfig.get_path("include"), "Python.h").stat()' 2>/dev/null || continue
      echo "$python"
      break
    done
  done
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for python in $(pythons); do
  step "wheels for $python"
  for project in python python/preparation; do
    SPHERICAL_PARAMETERIZATION_BUILD=$build "$python" -m pip wheel --quiet --no-build-isolation --no-index --no-deps \
      --wheel-dir "$scratch" "$root/$project"
  done
done
for wheel in "$scratch"/*.whl; do
  /usr/bin/python3 "$root/scripts/repair_wheel.py" "$wheel" "$out"
done

step "source distributions"
for project in python python/preparation; do
  (cd "$root/$project" && /usr/bin/python3 setup.py --quiet sdist --dist-dir "$out")
done

step "the tool as one file"
build=$root/build-static
"$root/scripts/fetch_sources.sh" "$build" onetbb # Debian has no static one
cmake -S "$build/onetbb" -B "$build/tbb" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DTBB_TEST=OFF -DTBB_STRICT=OFF \
  -DCMAKE_INSTALL_PREFIX="$build/installed"
build "$build/tbb" --target install
cmake -S "$root" -B "$build" "${options[@]}" -DCMAKE_PROJECT_INCLUDE=cmake/static.cmake -DCMAKE_PREFIX_PATH="$build/installed" \
  -DCGAL_SP_WITH_PYTHON=OFF -DCGAL_SP_WITH_INSTALL=OFF
build "$build" --target spherical-parameterization
tool=$out/spherical-parameterization-linux-$(uname -m)
strip -o "$tool" "$build/src/spherical-parameterization"
# the licences of all that is in it
cat "$root"/LICENSE{,.GPL} "$build/onetbb/LICENSE.txt" /usr/share/common-licenses/LGPL-2.1 \
  /usr/share/doc/{lib{boost,bz2,cgal,cli11,eigen3,gmp,lzma,mpfr,png,pugixml,sqlite3,xxhash,zstd}-dev,libc6,libstdc++6,nlohmann-json3-dev,zlib1g-dev}/copyright \
  >"$tool-licences.txt"

step "the npm package"
"$root/web/install_dependencies.sh"
(cd "$root/web" && npm run package && cp dist/*.tgz "$out")

step "written to $out"
ls -l "$out"
