#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Deadlock, divergence and determinism of every component of RoboTool's scripts: builds our command in release form,
# decides all assertions and prints time and memory (docs/benchmarks.md). Arguments are passed on: parts of names of
# scripts. The scripts' folder: ROBOCHART_SHARED/suite/robotool-csp; the script of the case study in bench/hvc is also
# type checked.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
shared="${ROBOCHART_SHARED:-../shared}"
exec python3 benchmarks/decide_components.py --program build/release/app/robochart-verify \
  --scripts "$shared/suite/robotool-csp" --typecheck "$shared/bench/hvc/robotool-csp/properties_assertions.csp" "$@"
