#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# draw_architecture.sh [OUTPUT.svg]
# Draws who includes whom, from the #include lines of the tree: a box per header of include/, one per folder of programs.
# Includes that follow from others are left out. Default output: doc/images/architecture.svg.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
output=$(realpath -m -- "${1:-$root/doc/images/architecture.svg}")

for program in dot tred; do
  if ! command -v "$program" >/dev/null; then
    echo "draw_architecture.sh: $program is missing: apt-get install graphviz" >&2
    exit 1
  fi
done
cd "$root"
package=CGAL/Spherical_parameterization

# node FILE: the box it is in
node() {
  case $1 in
  include/*) basename "$1" .h ;;
  kernels/*) echo kernels ;;
  *) echo "${1%%/*}" ;;
  esac
}

# "FROM TO" for every include of a header of this package
edges() {
  local file header
  while IFS= read -r file; do
    while IFS= read -r header; do
      case $header in
      */kernel_sources.h) echo "$(node "$file") kernels" ;; # written by the build, from kernels/*.cl
      CGAL/spherical_parameterization.h | $package/*) echo "$(node "$file") $(basename "$header" .h)" ;;
      esac
    done < <(sed -n 's/^#include <\(CGAL\/.*\)>.*/\1/p' "$file")
  done < <(git ls-files 'include/*.h' 'src/*' 'examples/*.cpp' 'test/*.cpp' 'test/*.h' 'benchmark/*.cpp' 'benchmark/*.h')
  for formulas in linear_algebra saddle_point spring_energy vec3; do
    echo "kernels $formulas" # embedded in one program
  done
}

# cluster NAME LABEL COLOUR NODES...
cluster() {
  local name=$1 label=$2 colour=$3 box
  shift 3
  echo "subgraph cluster_$name { label=\"$label\"; style=\"rounded,filled\"; color=\"$colour\"; fillcolor=\"$colour\";"
  for box; do echo "  \"$box\";"; done
  echo "}"
}

{
  echo 'digraph architecture {'
  echo 'rankdir=LR; ranksep=0.5; nodesep=0.08; fontname="Helvetica"; fontsize=20; newrank=true;'
  echo 'node [shape=box, style="rounded,filled", fillcolor=white, fontname="Helvetica", fontsize=12, height=0.26, margin="0.08,0.02"];'
  echo 'edge [color="#00000070", arrowsize=0.5];'
  cluster programs programs '#e8e8e8' src examples test benchmark
  mapfile -t public < <(git ls-files "include/*.h" | grep -v /internal/ | xargs -n 1 basename -s .h)
  cluster public 'public headers' '#dcebf7' "${public[@]}"
  mapfile -t internal < <(git ls-files "include/*/internal/*.h" | xargs -n 1 basename -s .h)
  cluster internal internal '#f3ecd9' "${internal[@]}"
  cluster kernels 'OpenCL C' '#e3f1dd' kernels
  edges | sort -u | awk '$1 != $2 { print "\"" $1 "\" -> \"" $2 "\";" }'
  echo '}'
} | tred | dot -Tsvg -o "$output"
echo "written: $output"
