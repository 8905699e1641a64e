#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks the high-voltage controller again after small edits, with cached results of earlier runs: builds our command in
# release form (docs/benchmarks.md). --compare: also checks each edit from scratch and compares the answers.
# The model: ROBOCHART_SHARED/bench/hvc.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/check_again.py --program build/release/app/robochart-verify \
  --folder "${ROBOCHART_SHARED:-../shared}/bench/hvc" "$@"
