#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The probabilities of the UVC case study (docs/benchmarks.md): builds our command in release form, decides them and
# compares with the reference. Arguments are passed on: --jobs N. The folder: ROBOCHART_SHARED/suite/prism/uvc.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/decide_uvc.py --program build/release/app/robochart-verify \
  --folder "${ROBOCHART_SHARED:-../shared}/suite/prism/uvc" "$@"
