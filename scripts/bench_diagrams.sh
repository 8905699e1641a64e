#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The time to draw diagrams, and the number of crossings compared with ELK's layered layout on the same boxes: fetches
# the npm package elkjs into a temporary folder, builds benchmark_diagrams, prints both (docs/benchmarks.md,
# "Diagrams").
# Usage: scripts/bench_diagrams.sh [MODEL...]. The default is the corpus, the models of the tests, and those of
# ROBOCHART_SHARED/suite and bench if this folder exists. Each file is loaded alone.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -DROBOCHART_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target benchmark_diagrams
benchmark=build/release/benchmarks/benchmark_diagrams
shared="${ROBOCHART_SHARED:-../shared}"
models=("$@")
if [ "$#" -eq 0 ]; then
  folders=(corpus tests)
  for each in "$shared/suite" "$shared/bench"; do [ ! -d "$each" ] || folders+=("$each"); done
  mapfile -d '' -t models < <(find "${folders[@]}" -name '*.rct' -print0 | sort -z)
fi
"$benchmark" "${models[@]}"
fetched="$(mktemp -d)"
trap 'rm -rf "$fetched"' EXIT
npm install --silent --no-audit --no-fund --prefix "$fetched" elkjs@0.12.1
"$benchmark" --pictures "${models[@]}" |
  node benchmarks/compare_layouts.mjs "$fetched/node_modules/elkjs/lib/elk.bundled.js"
