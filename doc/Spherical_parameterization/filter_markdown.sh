#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# filter_markdown.sh FILE.md: the page for doxygen. Its title gets the name of the file as label; of links into the
# source tree only the text is left; GitHub's tables escape bars in formulas, doxygen's need not.
sed -E -e "1s/\$/ {#$(basename "$1" .md)}/" -e 's/\[([^]]*)\]\(\.\.\/[^)]*\)/\1/g' "$1"
