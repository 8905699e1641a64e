#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs all tests with all rounds of their random parts; an ordinary run has a third of them (tests/rounds.hpp). Arguments:
# options of ctest, such as -R '^markov\.'.
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release
RC_PARAMS=max_success=300 build/release/tests/checker/refine/tests_refine --gtest_filter='Laws.*'
ROBOCHART_ALL_ROUNDS=1 ctest --preset release -j "$(nproc)" "$@"
