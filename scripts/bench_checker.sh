#!/usr/bin/env bash
# The checker's benchmark: builds the command in release form and nothing else, explores the benchmark models and prints the
# figures with those of other tools: recorded ones and, where a tool is installed, measured ones (docs/benchmarks.md).
# Arguments are passed on: --quick, names of models. The models' folder: ROBOCHART_SHARED/bench/models.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/compare_checkers.py --program build/release/app/robochart-verify \
  --models "${ROBOCHART_SHARED:-../shared}/bench/models" "$@"
