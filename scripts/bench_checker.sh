#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The checker's benchmark: builds the command in release form, explores the models of benchmarks/models and prints the
# figures with those of other tools. The latter are recorded; a tool is also measured if it is installed and
# ROBOCHART_SHARED/bench/models has the models in its language (docs/benchmarks.md). Arguments are passed on: --quick,
# models.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
foreign="${ROBOCHART_SHARED:-../shared}/bench/models"
[ ! -d "$foreign" ] || set -- --foreign "$foreign" "$@"
exec python3 benchmarks/compare_checkers.py --program build/release/app/robochart-verify "$@"
