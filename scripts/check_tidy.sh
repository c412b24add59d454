#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_tidy.sh [FILE...]
# Fails if clang-tidy 14 finds anything, with the checks of .clang-tidy, in the FILEs (of C++ that is compiled) or the
# headers that they include. Without files: all that is compiled, which together includes every header; that takes an hour
# of a core.
# Environment: BUILD (folder, default build-tidy), JOBS
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build-tidy}
tidy=clang-tidy-14

if ! command -v "$tidy" >/dev/null || ! command -v clang++ >/dev/null; then
  echo "check_tidy.sh: $tidy or clang++ is missing: apt-get install clang-tidy-14 clang" >&2
  exit 1
fi
# Nothing is built, so no precompiled headers, which the commands would name.
cmake -S "$root" -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug -DCGAL_SP_WITH_BENCHMARKS=ON \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
cd "$root"
files=("$@")
if [ $# -eq 0 ]; then # those of this configuration: not what needs a library that is missing
  mapfile -t files < <(git ls-files '*.cpp' |
    while IFS= read -r file; do
      ! grep -q "\"file\": \"$root/$file\"" "$build/compile_commands.json" || echo "$file"
    done)
fi
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "${JOBS:-$(nproc)}" "$tidy" -p "$build" --quiet
echo "check_tidy.sh: no findings in ${#files[@]} files"
