#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_format.sh [--fix]
# Fails if clang-format 14 would change a file of C++ or OpenCL C; with --fix it does change them. (Newer versions
# format a few constructs in another way.) Not the concepts in doc/, which are no code.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
format=clang-format-14

if ! command -v "$format" >/dev/null; then
  echo "check_format.sh: $format is missing: apt-get install clang-format-14" >&2
  exit 1
fi
options=(--dry-run --Werror)
case ${1:-} in
'') ;;
--fix) options=(-i) ;;
*)
  echo "usage: check_format.sh [--fix]" >&2
  exit 2
  ;;
esac
cd "$root"
git ls-files -z '*.h' '*.cpp' '*.cl' ':!doc/*/Concepts/*' | xargs -0 "$format" "${options[@]}" --style=file
