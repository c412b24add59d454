#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the tests of CGAL::Parallel_tag with the thread sanitizer and runs them. No suppressions: a stand-in of plain
# threads takes the place of TBB's loop (test/thread_sanitizer), so that all synchronization is seen.
# Usage: check_threads.sh [BUILD_FOLDER]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build-threads}

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS="-fsanitize=thread -I$root/test/thread_sanitizer" \
  -DCGAL_SP_WITH_TBB=ON -DCGAL_SP_WITH_OPENCL=OFF \
  -DCGAL_SP_WITH_TOOL=OFF -DCGAL_SP_WITH_EXAMPLES=OFF -DCGAL_SP_WITH_BENCHMARKS=OFF
cmake --build "$build" --target test_backends --parallel "${JOBS:-$(nproc)}"
TSAN_OPTIONS=halt_on_error=1 "$build/test/test_backends" </dev/null
