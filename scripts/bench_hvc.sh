#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The high-voltage controller's assertions, from RoboTool's own script or, with --own, from the script that we generate
# from the model: builds our command in release form, decides them and compares with the recorded answers of FDR
# (docs/benchmarks.md). Arguments are passed on: --own, --reduction, --aims, numbers of assertions, --threads N. The
# folder: ROBOCHART_SHARED/bench/hvc.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/decide_hvc.py --program build/release/app/robochart-verify \
  --folder "${ROBOCHART_SHARED:-../shared}/bench/hvc" "$@"
