#!/usr/bin/env bash
# Random models from a seed on: C++ is generated for each, compiled with warnings as errors, explored over all inputs and
# compared with the model's semantics; prints what came of them. Builds the tests of the room in release form first.
# Arguments: how many models (default 100000), the first seed (default 0), the compiler (default c++).
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target tests_conformance > /dev/null
ROBOCHART_SEEDS="${1:-100000}" ROBOCHART_FIRST_SEED="${2:-0}" ROBOCHART_COMPILER="${3:-c++}" \
  exec build/release/tests/conformance/tests_conformance --gtest_filter='RandomModels.Conform'
