#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs missing packages, builds the command and runs the aggregation case study: ten trials, bands, pictures.
# Arguments: another scenario, options of `robochart-verify simulate`.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh build
cmake --preset release -DROBOCHART_TESTS=OFF >/dev/null
cmake --build --preset release --target robochart-verify
[ "$#" -gt 0 ] || set -- corpus/aggregation/aggregation.scenario
exec build/release/app/robochart-verify simulate "$@"
