#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the analysis of conflicts with the naive enumeration of the tests, on random sets of SLEEC rules
# (docs/testing.md):
#   tests/long.sh rules [CHECKS [SEED]]           default: 10000 sets
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON
export ROBOCHART_RANDOM_CHECKS="${1:-10000}"
export ROBOCHART_RANDOM_SEED="${2:-$(date +%s)}"
cmake --build --preset release --target tests_sleec
echo "seed $ROBOCHART_RANDOM_SEED"
exec build/release/tests/claims/sleec/tests_sleec --gtest_filter='RandomRules.*'
