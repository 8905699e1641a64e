#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the time to draw diagrams, and compares the crossings with those of ELK's layered layout on the same boxes.
# Fetches the npm package elkjs into a temporary folder (docs/benchmarks.md, "Diagrams"). benchmarks/run.py calls it:
# benchmarks/diagrams.sh BENCHMARK SHARED [MODEL...]. The default is the corpus, the models of the tests, and those of
# SHARED/suite and SHARED/bench if these folders exist. Each file is loaded alone.
set -euo pipefail
benchmark="$1"
shared="$2"
models=("${@:3}")
if [ "${#models[@]}" -eq 0 ]; then
  folders=(corpus tests)
  for folder in "$shared/suite" "$shared/bench"; do [ ! -d "$folder" ] || folders+=("$folder"); done
  mapfile -d '' -t models < <(find "${folders[@]}" -name '*.rct' -print0 | sort -z)
fi
"$benchmark" "${models[@]}"
fetched="$(mktemp -d)"
trap 'rm -rf "$fetched"' EXIT
npm install --silent --no-audit --no-fund --prefix "$fetched" elkjs@0.12.1
"$benchmark" --pictures "${models[@]}" |
  node benchmarks/compare_layouts.mjs "$fetched/node_modules/elkjs/lib/elk.bundled.js"
