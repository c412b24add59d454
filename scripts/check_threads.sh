#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the tests of what runs on several threads with the thread sanitizer, and runs them: the backend, the methods, all
# that is done with maps, and the tool on several meshes at the same time. No suppressions: a stand-in of plain threads
# takes the place of TBB's loop (test/thread_sanitizer), so that all synchronization is seen.
# Usage: check_threads.sh [BUILD_FOLDER]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build-threads}

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1 -DNDEBUG" \
  -DCMAKE_CXX_FLAGS="-fsanitize=thread -I$root/test/thread_sanitizer" \
  -DCGAL_SP_WITH_TBB=ON -DCGAL_SP_WITH_OPENCL=OFF -DCGAL_SP_WITH_PYTHON=OFF -DCGAL_SP_WITH_EXAMPLES=OFF
uses=(test_analysis test_harmonics test_registration test_segmentation test_signature test_statistics)
cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target test_backends test_maps test_tool "${uses[@]}"
export TSAN_OPTIONS=halt_on_error=1
"$build/test/test_backends" </dev/null
"$build/test/test_maps" --policy tbb '[isometric][each_policy],[density][each_policy],[landmarks][each_policy]' -w NoTests </dev/null
for test in "${uses[@]}"; do
  "$build/test/$test" '*on several threads*' -w NoTests </dev/null
done
"$build/test/test_tool" '*neither threads nor runs make a difference' -w NoTests </dev/null
