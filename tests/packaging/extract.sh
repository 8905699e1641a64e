#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes the files of a page that shows a program: blocks whose first line names a file (`// file: NAME`), and the block
# of kind `text` as `expected`. Arguments: the page, a new folder.
set -euo pipefail
mkdir "$2"
awk -v folder="$2" '
  /^```/ && inside { inside = 0; if (file != "") close(file); next }
  /^```text$/ { inside = 1; first = 0; file = folder "/expected"; printf "" > file; next }
  /^```/ { inside = 1; file = ""; first = 1; next }
  inside && first { first = 0; if (match($0, /^(\/\/|#) file: /)) file = folder "/" substr($0, RLENGTH + 1) }
  inside && file != "" { print > file }' "$1"
