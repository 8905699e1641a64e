#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the page with the counterexample of the high-voltage controller, 1,375 steps of four machines: its size, its
# loading time in Chromium and the time per step. Checks that each step highlights the states of its data
# (docs/benchmarks.md, "Diagrams"). Then takes 10,000 random steps of the semantics by hand. benchmarks/run.py calls it:
# benchmarks/pages.sh PROGRAM MODEL
set -euo pipefail
verify="$1"
model="$2"
made="$(mktemp -d)"
trap 'rm -rf "$made"' EXIT
"$verify" check "$model" --assertion P1_fail --format json --html "$made/page.html" >"$made/report.json" 2>/dev/null ||
  [ "$?" -eq 1 ]
node tests/browser/tour.mjs "$made/page.html" "$made/report.json"
begin=$(date +%s%N)
printf 'internal\nrandom 10000\n' | "$verify" step "$model" mod_sys >/dev/null 2>&1
echo "10,000 steps by hand: $(( ($(date +%s%N) - begin) / 1000000 )) ms, reading the model included"
