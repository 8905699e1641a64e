#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Mutation analysis of the C++ generator: every kind of seeded fault at every place of every model of the tests, each compared
# with its model; prints one line for each kind and each model (mutants, killed, shown equivalent, variants the model
# allows), what killed them, and how long the shortest differences are. Builds the tests of the component in release form first.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target tests_conformance > /dev/null
ROBOCHART_MUTANTS=all exec build/release/tests/conformance/tests_conformance --gtest_filter='Mutants.*'
