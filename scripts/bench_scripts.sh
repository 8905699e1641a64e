#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bytes of our scripts and states of every component against RoboTool's published scripts for the same models: builds our
# command in release form and nothing else (docs/benchmarks.md). The scripts' folder: ROBOCHART_SHARED/suite/robotool-csp.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/compare_scripts.py --program build/release/app/robochart-verify \
  --scripts "${ROBOCHART_SHARED:-../shared}/suite/robotool-csp" "$@"
