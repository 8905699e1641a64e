#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks the Markov models of random RoboChart models (docs/testing.md). The decision process of the timed semantics is
# branching bisimilar to the process that is checked for refinement, the values of restricted schedulers are within the
# bounds for all schedulers, and RoboTool's chain is between the schedulers of its text. First builds the tests of the
# component in release form.
# Arguments: the number of models (default 1000), the first seed (default 0).
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target tests_probability
export ROBOCHART_SEEDS="${1:-1000}" ROBOCHART_FIRST_SEED="${2:-0}"
exec build/release/tests/prism/assertions/tests_probability \
  --gtest_filter='Agreement.OfRandomModels:Agreement.TheChainLiesBetweenTheSchedulers'
