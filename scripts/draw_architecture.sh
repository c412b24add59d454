#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# draw_architecture.sh [--list | OUTPUT.svg]
# Draws which room includes which, from the #include lines of the tree: a box per folder of internal/, per group of
# public headers and per folder of programs. Includes that follow from others are left out; those against the order of
# the rooms are red. Default output: doc/images/architecture.svg.
# --list: prints the includes against the order, file by file, and lines that name internals outside the package, and
# fails if there are any. It does not need graphviz.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
package=include/CGAL/Spherical_parameterization

# From the bottom up: level, group, room, subject. A room may include rooms of lower levels. A folder that is not here is
# an error, so that the picture is complete.
rooms='
1|public|values|errors, results, methods, options, coefficients
0|core|api|named parameters, preconditions, compiled or not
1|core|loops|loops on the host, arrays
0|core|algebra|vectors, rotations, small dense and sparse systems
1|core|text|numbers in sentences
2|core|context|time limit, callback, progress
2|core|predicates|exact orientation, degree, certificate
3|core|surface|corner table, checks of the input, numbering
4|public|inputs|edge_weights.h, Indexed_triangle_mesh.h, ...
2|core|backend|formulas; the verbs, on one core and with TBB
5|core|backend/opencl|the same verbs on an OpenCL device
4|kernels|kernels|OpenCL C: one kernel per verb
9|public|devices|OpenCL_device.h: the policy
4|core|multigrid|coarsening, V-cycle, conjugate gradients
3|core|moebius|Moebius transformations: centring, alignment
4|core|relaxation|stars: moving single vertices, exactly checked
5|core|problem|Problem, Solution, Method_solver
6|core|balanced|Balanced: start map and descent
7|core|saddle_point|Saddle_point: the published method
6|core|isometric|Isometric: decimation, insertion, relaxation
7|core|automatic|Automatic: several methods in turn
8|core|driver|read_problem, solve, write_solution
5|beside|distortion|stretch and angles per face
5|beside|locate|kd-tree, barycentric coordinates
5|beside|signature|conformal factor, intrinsic Laplacian
5|beside|spectrum|eigenfunctions of the Laplacian
5|beside|statistics|Procrustes alignment, principal components
6|beside|segmentation|girths, creases, light inside, regions
6|beside|spherical_harmonics|transforms, least squares, rotations
6|beside|texture|charts, poles, grid of coordinates
7|beside|correspondence|features, deformation, the best rotation
9|public|parameterize|parameterize.h: the two front doors
10|public|applications|what is done with a map: a header each
11|programs|compiled|the core, compiled once
11|programs|src|the tool: commands, options, input, ...
11|programs|examples|one idea each
12|programs|test|tests, in the same rooms
12|programs|benchmark|measurements
12|programs|fuzz|fuzzers'

# "FROM TO FILE HEADER" for every include of a header of this package that is in another room
includes() {
  git ls-files 'include/*.h' compiled src examples test benchmark fuzz | grep -E '\.(h|cpp)$' |
    xargs grep -HoE '^#include <CGAL/[Ss]pherical_parameterization[^>]*>' |
    sed -E 's/:#include <(.*)>/ include\/\1/' |
    awk -v package="$package/" '
      function room(file,    name) {
        if(file ~ /kernel_sources\.h$/)
          return "kernels"
        if(index(file, package "internal/") == 1) {
          name = substr(file, length(package "internal/") + 1)
          sub(/\/[^\/]*$/, "", name)
          return name ~ /^backend\/formulas/ ? "backend" : name
        }
        if(index(file, package) != 1)
          return file ~ /^include/ ? "applications" : substr(file, 1, index(file, "/") - 1)
        name = substr(file, length(package) + 1)
        if(name ~ /^values\// || name == "version.h")
          return "values"
        if(name ~ /^(edge_weights|Indexed_triangle_mesh)\.h$/)
          return "inputs"
        if(name ~ /^OpenCL_/)
          return "devices"
        return name == "parameterize.h" ? "parameterize" : "applications"
      }
      room($1) != room($2) && $1 !~ /spherical_parameterization\.h$/ { print room($1), room($2), $1, $2 }'
  echo "kernels backend kernels $package/internal/backend/vertex_formulas.h" # embedded in one program
}

# Splits the includes: mode "down" prints those that go down, "against" the others.
by_direction() {
  awk -v mode="$1" -v rooms="$rooms" '
    BEGIN {
      n = split(rooms, line, "\n")
      for(k = 1; k <= n; ++k)
        if(split(line[k], field, "|") == 4)
          level[field[3]] = field[1]
    }
    {
      for(k = 1; k <= 2; ++k)
        if(!($k in level)) {
          print "draw_architecture.sh: " $k " has no level and no subject here" > "/dev/stderr"
          exit 1
        }
      if((level[$2] < level[$1]) == (mode == "down"))
        print
    }'
}

if [ "${1:-}" = --list ]; then
  against=$(includes | by_direction against)
  [ -z "$against" ] || { echo "$against" | awk '{ print $1 " -> " $2 ": " $3 " includes " $4 }' | sort; exit 1; }
  if git ls-files src python examples web fuzz | grep -E '\.(h|cpp)$' | xargs grep -Hn 'internal::'; then exit 1; fi
  exit 0
fi
output=$(realpath -m -- "${1:-$root/doc/images/architecture.svg}")
for program in dot tred; do
  if ! command -v "$program" >/dev/null; then
    echo "draw_architecture.sh: $program is missing: apt-get install graphviz" >&2
    exit 1
  fi
done

# The boxes of a group, in a frame of its colour
group() {
  echo "subgraph cluster_$1 { label=<<b>$2</b>>; style=\"rounded,filled\"; color=\"$3\"; fillcolor=\"$3\";"
  awk -F'|' -v group="$1" '$2 == group {
    print "\"" $3 "\" [label=<<b>" $3 "</b><br/><font point-size=\"11\">" $4 "</font>>];"
  }' <<<"$rooms"
  echo "}"
}

{
  echo 'digraph architecture {'
  echo 'rankdir=TB; ranksep=0.42; nodesep=0.18; fontname="Helvetica"; fontsize=16; newrank=true;'
  echo 'node [shape=box, style="rounded,filled", fillcolor=white, fontname="Helvetica", fontsize=14, margin="0.1,0.05"];'
  echo 'edge [color="#00000090", arrowsize=0.6];'
  group programs 'programs' '#e8e8e8'
  group public 'public headers' '#dcebf7'
  group beside 'internal/: what is done with a map' '#efe6f3'
  group core 'internal/: the map' '#f3ecd9'
  group kernels 'kernels/' '#e3f1dd'
  includes | by_direction down | awk '{ print "\"" $1 "\" -> \"" $2 "\";" }' | sort -u
  echo '}'
} | tred | sed '$d' >"$output.dot"
{
  cat "$output.dot"
  includes | by_direction against |
    awk '{ print "\"" $1 "\" -> \"" $2 "\" [color=\"#d02020\", constraint=false];" }' | sort -u
  echo '}'
} | dot -Tsvg -o "$output"
rm -f "$output.dot"
echo "written: $output"
