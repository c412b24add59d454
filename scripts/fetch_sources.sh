#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: fetch_sources.sh FOLDER NAME...
# Sources of Debian's packages, with its patches, as FOLDER/NAME: from where its packages come from, but without a change of apt's
# lists. Does nothing where they are there.
set -euo pipefail
folder=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/from" "$folder"
chmod -R a+rX "$work"
if [ -s /etc/apt/sources.list ]; then sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$work/from/of.list"; fi
for list in /etc/apt/sources.list.d/*.sources; do
  [ ! -e "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/from/$(basename "$list")"
done
options=(-q -o Acquire::Retries=5 -o "Dir::State::lists=$work/lists" -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$work/from")
for name; do
  [ ! -d "$folder/$name" ] || continue
  [ -e "$work/lists/lock" ] || apt-get "${options[@]}" update
  # the release itself: what a mirror of updates lists, it does not always have
  (cd "$work" && apt-get "${options[@]}" -t "$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)" --only-source source "$name")
  mv "$work/$name"-*/ "$folder/$name"
done
