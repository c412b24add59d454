#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_versions.sh [--list] [ROW...]
# Builds and runs the tests with each ROW: a version of CGAL, a compiler, a C++ standard and a configuration. Without
# rows, a covering set: every pair of any two values occurs in one of them. Prints a table, and fails if a row has.
#
#   CGAL       installed: libcgal-dev of this machine, 5.5 on Debian 12; or the name of a newer Debian release, whose
#              libcgal-dev is unpacked in the build folder. Nothing is installed.
#   compiler   g++, clang++
#   standard   17, 20
#   Release    -DNDEBUG; with -O1, since what run_tests.sh builds has -O3
#   Debug      the assertions of the standard library, of CGAL and ours
#
# The tests are those that instantiate the whole library with every kind of mesh, and the examples. The tool and the
# kernels of OpenCL are not (the one is built on the library, the other compiled by the driver): TARGETS=all has
# everything. Warnings are errors. JOBS: processes at a time.
# Environment: BUILD (folder, default build-versions), TARGETS, JOBS
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build-versions}
read -ra targets <<<"${TARGETS:-test_maps test_concepts test_analysis test_signature test_segmentation examples}"
jobs=${JOBS:-$(nproc)}

rows=(
  'installed,g++,17,Release'
  'installed,clang++,20,Debug'
  'trixie,g++,20,Debug'
  'trixie,clang++,17,Release'
  'sid,g++,20,Release'
  'sid,clang++,17,Debug'
)
case ${1:-} in
--list)
  printf '%s\n' "${rows[@]}"
  exit
  ;;
-*)
  sed -n '3,5p' "${BASH_SOURCE[0]}" >&2
  exit 2
  ;;
esac
[ $# -eq 0 ] || rows=("$@")

"$root/scripts/install_dependencies.sh" --all clang

# cgal_of RELEASE: unpacks libcgal-dev of that release of Debian, from where this machine gets its packages, with lists
# of apt of its own; prints the folder of its CGALConfig.cmake
cgal_of() {
  local release=$1 folder=$build/cgal-$1 codename mirror options
  if [ ! -d "$folder/usr" ]; then
    # shellcheck source=/dev/null
    codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
    # shellcheck disable=SC2016  # the names are apt's
    mirror=$(apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
      awk -v release="$codename" '$1 == release && $2 == "main" { print $3; exit }')
    mkdir -p "$folder/apt/lists/partial" "$folder/apt/archives/partial"
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $release main" >"$folder/apt/sources"
    options=(-q -o Dir::Etc::sourcelist="$folder/apt/sources" -o Dir::Etc::sourceparts=/dev/null
      -o Dir::Etc::preferences=/dev/null -o Dir::Etc::preferencesparts=/dev/null -o APT::Default-Release=
      -o Dir::State::lists="$folder/apt/lists" -o Dir::Cache="$folder/apt"
      -o APT::Sandbox::User=root -o Acquire::Languages=none)
    # `set -e` does not hold here: bash ignores it below an `if` or an `||`
    apt-get "${options[@]}" update >&2 &&
      (cd "$folder/apt" && apt-get "${options[@]}" download libcgal-dev) >&2 &&
      dpkg-deb -x "$folder"/apt/libcgal-dev_*.deb "$folder/new" && mv "$folder/new/usr" "$folder" || return 1
  fi
  find "$folder/usr" -name CGALConfig.cmake -printf '%h\n' -quit | grep . # or fails
}

# tests_of TARGETS: the regular expression of their names
tests_of() {
  local target result=
  for target; do
    case $target in
    all) result+='|.' ;;
    examples) result+='|example\.' ;;
    *) result+="|$target/" ;;
    esac
  done
  echo "^(${result#|})"
}

# check CGAL COMPILER STANDARD CONFIGURATION: builds and tests; sets the columns of the table
check() {
  local folder=$build/$1-$2-$3-$4 cgal_folder='' options=() release='-O1 -DNDEBUG' start=$SECONDS
  [ "$2" != g++ ] || release+=' -Wno-maybe-uninitialized' # it is wrong about boost::optional, which CGAL 5.5 uses
  cgal='' tests='' build_seconds='' test_seconds=''
  if [ "$1" != installed ]; then
    cgal_folder=$(cgal_of "$1") || return 1
    options=(-DCGAL_DIR="$cgal_folder")
  fi
  cgal=$(printf '#include <CGAL/version.h>\nCGAL_VERSION\n' |
    "$2" -x c++ -E -P ${cgal_folder:+-I "$build/cgal-$1/usr/include"} - | tail -n 1) || return 1
  mkdir -p "$folder"
  cmake -S "$root" -B "$folder" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_STANDARD="$3" -DCMAKE_BUILD_TYPE="$4" \
    -DCMAKE_CXX_FLAGS_RELEASE="$release" -DCMAKE_COMPILE_WARNING_AS_ERROR=ON \
    -DCGAL_SP_WITH_BENCHMARKS=OFF "${options[@]}" >"$folder/log" 2>&1 || return 1
  cmake --build "$folder" --parallel "$jobs" --target "${targets[@]}" -- --keep-going >>"$folder/log" 2>&1 || return 1
  build_seconds=$((SECONDS - start))
  start=$SECONDS
  (cd "$folder" && ctest --output-on-failure --no-tests=error -j "$jobs" -R "$(tests_of "${targets[@]}")" \
    -E '/opencl/') >>"$folder/log" 2>&1 </dev/null || status=1
  test_seconds=$((SECONDS - start))
  tests=$(grep -E 'tests passed,' "$folder/log" | tail -n 1)
  return "${status:-0}"
}

mkdir -p "$build"
table=$build/table.md
{
  echo "| CGAL | version | compiler | C++ | configuration | build [s] | test [s] | verdict |"
  echo "|---|---|---|---|---|---|---|---|"
} >"$table"
failed=0
for row in "${rows[@]}"; do
  IFS=, read -r source compiler standard configuration <<<"$row"
  echo "== $row"
  status=0
  verdict=passed
  if ! check "$source" "$compiler" "$standard" "$configuration"; then
    verdict=FAILED
    failed=1
    grep -E 'error|FAILED|\*\*\*' "$build/${row//,/-}/log" | head -n 20 || true
  fi
  echo "| $source | $cgal | $compiler $("$compiler" -dumpversion) | $standard | $configuration |" \
    "${build_seconds:-} | ${test_seconds:-} | $verdict${tests:+: $tests} |" >>"$table"
  tail -n 1 "$table"
done
echo
cat "$table"
exit "$failed"
