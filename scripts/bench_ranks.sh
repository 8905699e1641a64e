#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Level searches with threads as ranks on wide state spaces and on the high-voltage controller's narrow one
# (docs/scale.md): critical path, bytes and messages, memory, with one or several ranks per program, and the prediction
# of the model. Needs ROBOCHART_SHARED/bench.
set -euo pipefail
cd "$(dirname "$0")/.."
bench="${ROBOCHART_SHARED:-../shared}/bench"
if [ ! -d "$bench/models" ]; then
  echo "$bench/models is not there: nothing to measure"
  exit 77
fi
cmake --preset release -DROBOCHART_BENCHMARKS=ON > /dev/null
cmake --build --preset release --target benchmark_ranks robochart-verify
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
for model in milner15 cbuf10; do
  echo "## $model"
  grep -v '^assert' "$bench/models/$model.csp" > "$made/$model.csp"
  echo 'assert SYSTEM :[deadlock free [F]]' >> "$made/$model.csp"
  build/release/benchmarks/benchmark_ranks "$made/$model.csp" 1 5 1 2 4 8 16 32 1x8 2x4 4x2
done
echo "## the high-voltage controller's P4, from our own script"
build/release/app/robochart-verify emit csp "$bench/hvc" --out "$made" --quiet || true
build/release/benchmarks/benchmark_ranks "$made"/csp-gen/timed/*_assertions.csp 17 1 1 2 4 8 2x4
