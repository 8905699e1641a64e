#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the refinement checker with the naive one of the tests, on random processes (docs/testing.md):
#   tests/long.sh checks [CHECKS [SEED]]           default: 10000 checks with random options, and as many with scripts
#   tests/long.sh checks --command [SCRIPTS [SEED]]  default: 10000 scripts through the whole command
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON
if [[ "${1:-}" == --command ]]; then
  export ROBOCHART_RANDOM_SCRIPTS="${2:-10000}"
  export ROBOCHART_RANDOM_SEED="${3:-$(date +%s)}"
  cmake --build --preset release --target tests_random_scripts
  echo "seed $ROBOCHART_RANDOM_SEED"
  exec build/release/tests/app/tests_random_scripts
fi
export ROBOCHART_RANDOM_CHECKS="${1:-10000}"
export ROBOCHART_RANDOM_SEED="${2:-$(date +%s)}"
cmake --build --preset release --target tests_refine tests_cspm
echo "seed $ROBOCHART_RANDOM_SEED"
build/release/tests/checker/refine/tests_refine --gtest_filter='Agreement.*:Compressions.*'
build/release/tests/checker/cspm/tests_cspm --gtest_filter='RandomScripts*'
