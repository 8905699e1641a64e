#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Generates scripts from random models: every script must parse to the same tree and pass the type checker
# (docs/testing.md):
#   tests/long.sh scripts [MODELS [FIRST_SEED]]     default: 1000 models of each shape from seed 0
set -euo pipefail
cd "$(dirname "$0")/../.."
export ROBOCHART_SEEDS="${1:-1000}"
export ROBOCHART_FIRST_SEED="${2:-0}"
cmake --preset release -DROBOCHART_TESTS=ON
cmake --build --preset release --target tests_random_models
build/release/tests/random_models/tests/tests_random_models --gtest_filter='Semantics.*'
