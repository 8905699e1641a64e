#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares bytes of our scripts and states of every component with RoboTool's published scripts for the same models:
# builds our command in release form (docs/benchmarks.md). The scripts' folder: ROBOCHART_SHARED/suite/robotool-csp.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/compare_scripts.py --program build/release/app/robochart-verify \
  --scripts "${ROBOCHART_SHARED:-../shared}/suite/robotool-csp" "$@"
