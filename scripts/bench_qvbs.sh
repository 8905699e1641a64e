#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Quantitative Verification Benchmark Set (docs/benchmarks.md): builds our command in release form, decides its
# properties and compares with its values. Arguments are passed on: --jobs N, --only TEXT, --exact STATES. The folder:
# ROBOCHART_SHARED/suite/prism/qvbs.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/decide_qvbs.py --program build/release/app/robochart-verify \
  --folder "${ROBOCHART_SHARED:-../shared}/suite/prism/qvbs" "$@"
