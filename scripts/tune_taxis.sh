#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tunes swarm taxis and compares with the values of the paper and, if it is installed, with irace at the same budget
# (docs/emergence.md, "Tuning"): builds our command in release form. Arguments are passed on: --budget N --repetitions N
# --fresh N.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/tune_taxis.py "$@"
