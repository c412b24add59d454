#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every kernel in the simulator Oclgrind (Debian package oclgrind) and fails if it reports anything: accesses out of
# bounds, data races, misuse of the OpenCL API. Not: uninitialized values, since Oclgrind 21.10 takes what
# clEnqueueFillBuffer has written for that.
# Usage: check_opencl_memory.sh [BUILD_FOLDER]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build}

if ! command -v oclgrind >/dev/null; then
  echo "check_opencl_memory.sh: oclgrind is missing; install the Debian package oclgrind" >&2
  exit 1
fi
cmake -S "$root" -B "$build" -DCGAL_SP_WITH_OPENCL=ON
cmake --build "$build" --target test_backends --parallel "${JOBS:-$(nproc)}"

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
# The simulator is slow: two blocks and a piece of a third one take every branch of a sum. It hides all other devices.
# Reports go to the standard error: Oclgrind 21.10 leaves the file of its option --log empty.
LARGEST_GRAPH=2100 \
  oclgrind --data-races --check-api \
  "$build/test/test_backends" '[verbs]' </dev/null 2>"$scratch/log" | tee "$scratch/out" ||
  { cat "$scratch/log" >&2; exit 1; }
if grep -q SKIPPED "$scratch/out"; then
  echo "check_opencl_memory.sh: nothing was checked" >&2
  exit 1
fi
if [ -s "$scratch/log" ]; then
  cat "$scratch/log" >&2
  echo "check_opencl_memory.sh: Oclgrind has found errors" >&2
  exit 1
fi
echo "check_opencl_memory.sh: no errors"
