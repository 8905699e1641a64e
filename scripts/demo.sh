#!/usr/bin/env bash
# Installs missing packages, builds, and runs all steps on the aggregation case study.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release -DROBOCHART_TESTS=OFF >/dev/null
cmake --build --preset release --target robochart-verify
exec build/release/app/robochart-verify corpus/aggregation --out out "$@"
