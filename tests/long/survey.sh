#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Generates C++ for every component of the available models, of the corpus and of bench/hvc, compiles it without
# warnings with g++ and with clang, explores it and compares it with its model. Then repeats this with AddressSanitizer
# and UndefinedBehaviorSanitizer in the generated code. tests/conformance/check/survey_test.cpp lists exceptions with
# their reasons. The folder of the models: ROBOCHART_SHARED (default ../shared). PRESET selects the build (default
# release).
set -euo pipefail
cd "$(dirname "$0")/../.."
preset="${PRESET:-release}"
cmake --preset "$preset" -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset "$preset" --target tests_conformance > /dev/null
export ROBOCHART_SHARED="${ROBOCHART_SHARED:-$PWD/../shared}"
export ROBOCHART_SURVEY_SECONDS="${ROBOCHART_SURVEY_SECONDS:-120}"
status=0

run() {
  echo "== $1"
  shift
  env "$@" "build/$preset/tests/conformance/tests_conformance" --gtest_filter='Survey.*' --gtest_brief=1 || status=1
}

run "g++" ROBOCHART_COMPILER=g++
if command -v clang++ > /dev/null; then run "clang++" ROBOCHART_COMPILER=clang++; else echo "== no clang++ here"; fi
# The sanitizers' libraries must be loaded before all others by the program that loads the code, which is built without
# them.
libraries="$(g++ -print-file-name=libasan.so):$(g++ -print-file-name=libubsan.so)"
run "g++ with both sanitizers" ROBOCHART_COMPILER=g++ LD_PRELOAD="$libraries" ASAN_OPTIONS=detect_leaks=0 \
  ROBOCHART_FLAGS="-fsanitize=address,undefined -fno-sanitize-recover=all"
exit "$status"
