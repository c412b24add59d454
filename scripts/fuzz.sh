#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the fuzzers (fuzz/) with clang++, libFuzzer and the address and undefined-behaviour sanitizers, and runs each of
# them for so many seconds, from the kept inputs on. Exits with 1 if one of them finds something: the input is then in
# BUILD_FOLDER/findings/TARGET. What they learn goes to BUILD_FOLDER/corpus/TARGET, from where a later run goes on.
# Usage: fuzz.sh SECONDS [BUILD_FOLDER [TARGET...]]
# Debian packages: clang, libclang-rt-dev (before Debian 13: libclang-rt-14-dev and the like)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
seconds=${1:?usage: fuzz.sh SECONDS [BUILD_FOLDER [TARGET...]]}
build=${2:-$root/build-fuzz}
targets=("${@:3}")
[ ${#targets[@]} -gt 0 ] || targets=(read_meshes read_formats read_data read_indices map_meshes use_maps)

cmake -S "$root" -B "$build" -DCMAKE_CXX_COMPILER="${CXX:-clang++}" -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_CXX_FLAGS="-O1 -g1 -D_GLIBCXX_ASSERTIONS" -DCGAL_SP_WITH_FUZZING=ON -DCGAL_SP_WITH_OPENCL=OFF \
  -DCGAL_SP_BUILD_TESTING=OFF -DCGAL_SP_WITH_EXAMPLES=OFF -DCGAL_SP_WITH_BENCHMARKS=OFF >/dev/null
cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target "${targets[@]/#/fuzz_}"

failed=0
for target in "${targets[@]}"; do
  corpus=$build/corpus/$target findings=$build/findings/$target log=$build/$target.log
  mkdir -p "$corpus" "$findings"
  known=("$corpus")
  for folder in "$root/fuzz/corpus/$target" "$root/fuzz/found/$target"; do
    [ ! -d "$folder" ] || known+=("$folder")
  done
  if "$build/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=512 \
    -print_final_stats=1 -artifact_prefix="$findings/" "${known[@]}" >"$log" 2>&1; then
    verdict="no finding"
  else
    verdict="FINDING, see $log"
    failed=1
  fi
  echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") executions, $verdict"
done
exit "$failed"
