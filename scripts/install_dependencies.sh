#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install_dependencies.sh [--all] [PACKAGE...]
# Installs the Debian packages that are missing: those of the library and the tool; with --all also those of the Python
# package and of the tests; and those named. As root, or through sudo. Does nothing where all are there.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive

packages=(
  build-essential cmake
  libcgal-dev libboost-dev libeigen3-dev libgmp-dev libmpfr-dev     # the library
  libtbb-dev ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd # its parallel backends
  libcli11-dev nlohmann-json3-dev libpng-dev libsqlite3-dev libxxhash-dev libpugixml-dev # the tool
  libboost-iostreams-dev                                            # its compressed files
  libcgal-demo                                                      # its first mesh
  f3d xvfb xauth                                                    # pictures
)
if [ "${1:-}" = --all ]; then
  shift
  packages+=(
    catch2 libopenmesh-dev                                          # the tests
    doxygen doxygen-awesome-css mandoc                              # the manual, which is a test, too
    python3-dev pybind11-dev python3-numpy python3-pip python3-venv python3-setuptools python3-wheel # the Python package
    python3-pytest mypy python3-numpydoc python3-tqdm python3-nibabel python3-meshio python3-matplotlib python3-scipy # its tests
    python3-distributed python3-nbclient python3-nbformat python3-ipykernel python3-matplotlib-inline
    assimp-utils                                                    # a test reads GLB files with it
    python3-vtk9                                                    # another reads and writes VTK files with it
    file patchelf                                                   # packages: which libraries are needed, and where they are
  )
fi
packages+=("$@")

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

as_root=()
become_root() {
  [ "$(id -u)" -ne 0 ] || return 0
  if ! command -v sudo >/dev/null || ! sudo true; then
    echo "install_dependencies.sh: packages can be installed by root or through sudo only; missing are $*" >&2
    exit 1
  fi
  as_root=(sudo env DEBIAN_FRONTEND=noninteractive)
}

# Mirrors fail now and then.
apt_get() {
  local attempt
  for attempt in 1 2 3 4 5; do
    "${as_root[@]}" apt-get -q -o DPkg::Lock::Timeout=300 "$@" </dev/null && return
    echo "install_dependencies.sh: attempt $attempt failed: apt-get $*" >&2
    [ "$attempt" -eq 5 ] || sleep $((5 * attempt))
  done
  return 1
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "Installing ${missing[*]}"
  become_root "${missing[@]}"
  apt_get update
  apt_get install -y --no-install-recommends "${missing[@]}"
fi

# Container images often tell dpkg to leave out /usr/share/doc, which is where libcgal-demo has its meshes.
if [ ! -e /usr/share/doc/libcgal-dev/data.tar.gz ] && [ ! -e /usr/share/doc/libcgal-demo/data.tar.gz ]; then
  become_root libcgal-demo
  apt_get update
  apt_get install -y --no-install-recommends --reinstall \
    -o 'Dpkg::Options::=--path-include=/usr/share/doc/libcgal-*' libcgal-demo
fi
