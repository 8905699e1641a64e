#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares searches with checkpoints and with states on disk with the ordinary one: builds our command in release form
# (docs/search.md, "Out of core"). Arguments: SCRIPT:NUMBER of assertions; the default is phils8 and milner18.
# The models: ROBOCHART_SHARED/bench.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
bench="${ROBOCHART_SHARED:-../shared}/bench"
models=("$@")
[ "${#models[@]}" -gt 0 ] || models=("$bench/models/phils8.csp:1" "$bench/models/milner18.csp:1")
exec python3 benchmarks/search_on_disk.py --program build/release/app/robochart-verify "${models[@]}"
