#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# coverage.sh
# Builds the tests with little optimization, runs them, and prints which share of the lines of include/ and src/ they
# have executed. The details are in BUILD/coverage.html. Left out are the tests of the installation, and those of full
# disks and the like, which would damage the files of the counters.
# Environment: BUILD (folder, default build-coverage), JOBS; TARGETS and TESTS (a regular expression of CTest), for a part
# of the tests
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build-coverage}
jobs=${JOBS:-$(nproc)}

if ! command -v gcovr >/dev/null; then
  echo "coverage.sh: gcovr is missing: apt-get install gcovr" >&2
  exit 1
fi
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="--coverage -fprofile-update=atomic" \
  -DCMAKE_CXX_FLAGS_DEBUG=-O1 -DCGAL_SP_WITH_BENCHMARKS=OFF
read -ra targets <<<"${TARGETS:-all}"
cmake --build "$build" --parallel "$jobs" --target "${targets[@]}"
find "$build" -name '*.gcda' -delete
export GCOV_ERROR_FILE=$build/libgcov.log # not among the messages of the tool, which are tested
(cd "$build" && ctest --output-on-failure --no-tests=error -j "$jobs" -R "${TESTS:-.}" -E '^install/|^test_tool/faults' \
  </dev/null)
# Of an inline function each object file has its own counters: gcovr adds them up.
gcovr --root "$root" --object-directory "$build" --filter "$root/include/" --filter "$root/src/" \
  --exclude-unreachable-branches --exclude-throw-branches --html-details "$build/coverage.html" --txt "$build/coverage.txt" \
  -j "$jobs" "$build"
grep '^TOTAL' "$build/coverage.txt"
