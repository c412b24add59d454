#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: time_compilation.sh [REPETITIONS]
# What the compiler needs for the program of README.md, with its command line, and for the same program without this
# package: user seconds, in turn, medians, and their ratio. CXX is the compiler. Needs Debian's time and bc.
set -euo pipefail
repetitions=${1:-3}
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

sed -n '/^## A program/,/^## /p' README.md | sed '1,/^```cpp/d' | sed '/^```/,$d' >"$folder/with.cpp"
sed '/spherical_parameterization\.h\|result/d' "$folder/with.cpp" >"$folder/without.cpp"
for ((i = 0; i < repetitions; ++i)); do
  for program in without with; do
    /usr/bin/time -f %U -a -o "$folder/$program" "${CXX:-g++}" -std=c++17 -O2 -DNDEBUG -ffp-contract=off -I include \
      -I /usr/include/eigen3 -c "$folder/$program.cpp" -o "$folder/program.o"
  done
done
median() { sort -g "$folder/$1" | sed -n "$(((repetitions + 1) / 2))p"; }
echo "with $(median with) s, without $(median without) s, ratio $(echo "scale=2; $(median with) / $(median without)" | bc)"
