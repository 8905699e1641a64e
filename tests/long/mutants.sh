#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Mutation analysis of the C++ generator: every kind of seeded fault at every place of every model of the tests, each
# compared with its model. Prints one line for each kind and each model (mutants, killed, shown equivalent, variants
# that the model allows), what killed them, and the lengths of the shortest differences. Then every kind of fault in three
# models against robochart-replay. First builds the tests of the component in release form.
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target tests_conformance tests_replay > /dev/null
export ROBOCHART_MUTANTS=all
build/release/tests/conformance/tests_conformance --gtest_filter='Mutants.*'
build/release/tests/conformance/replay/tests_replay --gtest_filter='*Mutants*'
