#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures level searches with threads as ranks, on wide state spaces and on the narrow state space of the high-voltage
# controller (docs/scale.md): critical path, bytes, messages and memory, with one or several ranks per program. Also
# prints the times that a model predicts. benchmarks/run.py calls it: benchmarks/ranks.sh PROGRAM BENCHMARK FOLDER
set -euo pipefail
program="$1"
benchmark="$2"
bench="$3"
if [ ! -d "$bench/models" ]; then
  echo "$bench/models does not exist: nothing to measure"
  exit 77
fi
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
for model in milner15 cbuf10; do
  echo "## $model"
  grep -v '^assert' "$bench/models/$model.csp" > "$made/$model.csp"
  echo 'assert SYSTEM :[deadlock free [F]]' >> "$made/$model.csp"
  "$benchmark" "$made/$model.csp" 1 5 1 2 4 8 16 32 1x8 2x4 4x2
done
echo "## the high-voltage controller's P4, from our own script"
"$program" emit csp "$bench/hvc" --out "$made" --quiet || true
"$benchmark" "$made"/csp-gen/timed/*_assertions.csp 17 1 1 2 4 8 2x4
