#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the verdicts of random claims about random models with processes that are written by hand (docs/testing.md):
#   tests/long.sh claims [MODELS]   default: 1000 models with five claims each
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON
export ROBOCHART_SEEDS="${1:-1000}"
cmake --build --preset release --target tests_claims
build/release/tests/claims/tests_claims --gtest_filter='ClaimProcesses.DecideRandomModelsAsTheLibrary'
