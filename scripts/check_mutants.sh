#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_mutants.sh [--list] [PATCH...]
# Whether the tests notice small defects: applies each PATCH (default: all of test/mutants), builds the tests that it
# names, runs them, and expects one to fail. Prints a table; fails if a mutant survives, does not apply or does not
# build, or if its tests fail without it.
#
# A patch begins with the lines
#   # tests: TARGET [FILTER]
# each a program of the tests and the test cases to run of it (a test specification of Catch), or `python FILTER`:
# pytest's -k. A program that does not end within LIMIT seconds has failed.
#
# Works on a copy of the tree, with all that is not committed, in BUILD: the tree itself is not touched. ccache, if there
# is one, saves a quarter of the time.
# Environment: BUILD (folder, default build-mutants), JOBS (processes at a time), LIMIT (default 300), OPTIONS (of cmake:
# with `-DCGAL_SP_WITH_TBB=OFF -DCGAL_SP_WITH_OPENCL=OFF` the core compiles in a third of the time, but kernels_* need it)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=$(realpath -m -- "${BUILD:-$root/build-mutants}")
jobs=${JOBS:-$(nproc)}
limit=${LIMIT:-300}
read -ra options <<<"${OPTIONS:-}"

is_list=
case ${1:-} in
--list)
  is_list=1
  shift
  ;;
-*)
  sed -n '3,6p' "${BASH_SOURCE[0]}" >&2
  exit 2
  ;;
esac
[ $# -gt 0 ] || set -- "$root"/test/mutants/*.patch
patches=()
for patch; do
  [ -f "$patch" ] || {
    echo "check_mutants.sh: $patch: no such file" >&2
    exit 2
  }
  patches+=("$(realpath -- "$patch")")
done

# tests_of PATCH: its programs with their filters, a line each
tests_of() { sed -n '/^diff/q; s/^# tests: //p' "$1"; }

if [ -n "$is_list" ]; then
  for patch in "${patches[@]}"; do
    printf '%s\t%s\n' "$(basename -- "$patch" .patch)" "$(tests_of "$patch" | paste -sd ',')"
  done
  exit
fi

# The copy: what git knows or would add. Files that are the same keep their times, so that nothing is built twice.
tree=$build/tree
mkdir -p "$tree"
export GIT_CEILING_DIRECTORIES=$build # to git apply, the copy is no part of a repository
GIT_CEILING_DIRECTORIES='' git -C "$root" ls-files -z --cached --others --exclude-standard |
  (cd "$root" && while IFS= read -r -d '' file; do
    [ ! -f "$file" ] || cmp -s -- "$file" "$tree/$file" || printf '%s\0' "$file"
  done) >"$build/changed"
(cd "$root" && xargs -0 -r -a "$build/changed" cp --parents -t "$tree" --)
(cd "$tree" && find . -type f -printf '%P\0') | while IFS= read -r -d '' file; do
  [ -e "$root/$file" ] || rm -- "$tree/$file"
done

generator=()
! command -v ninja >/dev/null || generator=(-G Ninja)
launcher=()
! command -v ccache >/dev/null || launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$tree" -B "$build" "${generator[@]}" "${launcher[@]}" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' -DCGAL_SP_BUILD_TESTING=ON \
  -DCGAL_SP_WITH_EXAMPLES=OFF -DCGAL_SP_WITH_INSTALL=OFF "${options[@]}" >"$build/configure.log"

# make TEST...: builds what the tests need
make_tests() {
  local target targets=()
  for target; do
    target=${target%% *}
    [ "$target" != python ] || target=spherical_parameterization_core
    targets+=("$target")
  done
  cmake --build "$build" --parallel "$jobs" --target "${targets[@]}"
}

# run_tests TEST...: whether all of them pass
run_tests() {
  local test target filter
  for test; do
    target=${test%% *}
    filter=${test#"$target"}
    filter=${filter# }
    if [ "$target" = python ]; then
      PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1 SPHERICAL_PARAMETERIZATION_BUILD=$build timeout "$limit" \
        /usr/bin/python3 -m pytest -q -x "$tree/python/tests" -k "$filter" </dev/null || return 1
    else
      timeout "$limit" "$build/test/$target" --abort ${filter:+"$filter"} </dev/null || return 1
    fi
  done
}

log=$build/log
: >"$log"
table=$build/table.md
printf '| mutant | tests | verdict | seconds |\n|---|---|---|---|\n' | tee "$table"
declare -A is_good=()
failed=0
for patch in "${patches[@]}"; do
  name=$(basename -- "$patch" .patch)
  start=$SECONDS
  mapfile -t tests < <(tests_of "$patch")
  key=$(printf '%s|' "${tests[@]}")
  {
    if [ ${#tests[@]} -eq 0 ]; then
      verdict='names no tests'
    elif ! git -C "$tree" apply --check "$patch"; then
      verdict='does not apply'
    elif [ -z "${is_good[$key]:-}" ] && ! make_tests "${tests[@]}"; then
      verdict='does not build without it'
    elif [ -z "${is_good[$key]:-}" ] && ! run_tests "${tests[@]}"; then
      verdict='its tests fail without it'
    else
      is_good[$key]=1
      git -C "$tree" apply "$patch"
      if ! make_tests "${tests[@]}"; then
        verdict='does not build'
      elif run_tests "${tests[@]}"; then
        verdict=survives
      else
        verdict=killed
      fi
      git -C "$tree" apply --reverse "$patch"
    fi
  } >>"$log" 2>&1
  [ "$verdict" = killed ] || failed=1
  echo "| $name | $(printf '%s, ' "${tests[@]}" | sed 's/, $//; s/|/\\|/g') | $verdict | $((SECONDS - start)) |" |
    tee -a "$table"
done
exit "$failed"
