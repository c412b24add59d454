#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run_benchmark.sh [OUTPUT [MESH|FOLDER]...]
# Installs the packages, builds the benchmark in build/ and makes all of its tables, as Markdown and CSV, in OUTPUT
# (default: benchmark_results/). Without meshes: those of CGAL's demos that the paper's figures or ours show.
# FOREIGN="SOURCE SPHERE ..." adds the table about spheres of other programs, MAXIMUM_VERTICES=5000000 enlarges that
# about scaling, whose mesh is the first one.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
output=${1:-$root/benchmark_results}
[ $# -eq 0 ] || shift

"$root/scripts/install_dependencies.sh" gnuplot-nox libmeshoptimizer-dev valgrind
cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_SP_WITH_BENCHMARKS=ON
cmake --build "$root/build" --parallel "$(nproc)" --target benchmark
benchmark=$root/build/benchmark/benchmark
mkdir -p "$output"

if [ $# -eq 0 ]; then
  tarball=/usr/share/doc/libcgal-dev/data.tar.gz
  [ -e "$tarball" ] || tarball=/usr/share/doc/libcgal-demo/data.tar.gz
  meshes=$root/build/benchmark/meshes
  mkdir -p "$meshes"
  tar -xzf "$tarball" -C "$meshes" --strip-components=2 \
    data/meshes/camel.off data/meshes/diplodocus.off data/meshes/armadillo.off
  set -- "$meshes/camel.off" "$meshes/diplodocus.off" "$meshes/armadillo.off"
fi

# run COMMAND ARGUMENTS...
run() {
  echo
  "$benchmark" "$1" --output "$output" "${@:2}" </dev/null
}

run models "$@"
run levels "$@"
run backends "$@"
run published "$@"
run order "$@"
run checks "$@"
run scaling --maximum-vertices "${MAXIMUM_VERTICES:-500000}" "$1"
if [ -n "${FOREIGN:-}" ]; then
  # shellcheck disable=SC2086  # several files, without blanks in their names
  run foreign $FOREIGN
fi
gnuplot -e "csv='$output/scaling.csv'; svg='$output/scaling.svg'" "$root/benchmark/plot_scaling.gp"

echo
echo "Written to $output:"
ls "$output"
