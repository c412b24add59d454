#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# filter_markdown.sh FILE.md: the page for doxygen. Its title gets the name of the file as label, and a table of contents; of links into the
# source tree and within the page only the text is left.
sed -E -e "1s/\$/ {#$(basename "$1" .md)}\n\n\\\\tableofcontents{HTML:1}/" -e 's/\[([^]]*)\]\((\.\.\/|#|(benchmark|cmake|examples|include|kernels|scripts|src|test)\/)[^)]*\)/\1/g' "$1"
