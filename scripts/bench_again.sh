#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The high-voltage controller checked again after small edits, with what earlier runs have kept: builds our command in
# release form and nothing else (docs/benchmarks.md). --compare: each edit also from scratch, and the answers compared.
# The model: ROBOCHART_SHARED/bench/hvc.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/check_again.py --program build/release/app/robochart-verify \
  --folder "${ROBOCHART_SHARED:-../shared}/bench/hvc" "$@"
