#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: time_tool.sh REPETITIONS OPTIONS TOOL[,TOOL...] MESH...
# How long the tool takes from a file to a certified map in a file of the same format, and how much memory, as a Markdown
# table: the median run of every program on every mesh, in turn. Reading includes all checks of the mesh, and its arrays for
# the solver. OPTIONS are those of the command map, in one word. For a
# table of before and after, give two builds of the tool:
#   scripts/time_tool.sh 5 "--policy tbb" old/src/spherical-parameterization,build/src/spherical-parameterization a.ply a.off
set -euo pipefail
: "${4:?usage: time_tool.sh REPETITIONS OPTIONS TOOL[,TOOL...] MESH...}"
repetitions=$1
read -ra options <<<"$2"
IFS=, read -ra tools <<<"$3"
meshes=("${@:4}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo "| mesh | MB | program | read s | start map + solve s | certify s | write s | total s | total / (start map + solve) | bytes per vertex |"
echo "|---|---|---|---|---|---|---|---|---|---|"
for mesh in "${meshes[@]}"; do
  for ((i = 0; i < repetitions; ++i)); do
    for tool in "${!tools[@]}"; do
      /usr/bin/time -f 'kB %M' "${tools[tool]}" map "$mesh" -o "$folder/out.${mesh##*.}" "${options[@]}" >"$folder/log" 2>&1 </dev/null ||
        { cat "$folder/log" >&2; exit 1; }
      # "... 1664002 vertices, ..." and "5.3 s: read 1.0, weights 0.8, start map 0.6, solve 1.6, certify 0.6, write 0.1"
      awk '/ vertices, /  { for(k = 2; k <= NF; ++k) if($k == "vertices,") vertices = $(k - 1) }
           / s: read /    { total = $1; for(k = 2; k < NF; ++k) { value = $(k + 1); sub(",", "", value); seconds[$k] = value } }
           $1 == "kB"     { kB = $2 }
           END { print total, seconds["read"], seconds["map"] + seconds["solve"], seconds["certify"], seconds["write"], kB * 1024 / vertices }' \
        "$folder/log" >>"$folder/$tool"
    done
  done
  for tool in "${!tools[@]}"; do
    sort -g "$folder/$tool" | sed -n "$(((repetitions + 1) / 2))p" |
      awk -v name="$(basename "$mesh")" -v tool="${tools[tool]}" -v MB="$(($(stat -c %s "$mesh") / 1000000))" \
        '{ printf "| %s | %d | %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.0f |\n", name, MB, tool, $2, $3, $4, $5, $1, $1 / $3, $6 }'
    rm "$folder/$tool"
  done
done
