#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every component of the available models, of the corpus and of bench/hvc: C++ is generated, compiled without a warning by
# g++ and by clang, explored and compared with its model; then once more with AddressSanitizer and
# UndefinedBehaviorSanitizer in the generated code. Exceptions are listed in tests/conformance/check/survey_test.cpp with their
# reasons. The folder of the models: ROBOCHART_SHARED (default ../shared). PRESET chooses the build (default release).
set -euo pipefail
cd "$(dirname "$0")/.."
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
# The sanitizers' libraries have to come before all others in the program that loads the code; it has none of its own.
libraries="$(g++ -print-file-name=libasan.so):$(g++ -print-file-name=libubsan.so)"
run "g++ with both sanitizers" ROBOCHART_COMPILER=g++ LD_PRELOAD="$libraries" ASAN_OPTIONS=detect_leaks=0 \
  ROBOCHART_FLAGS="-fsanitize=address,undefined -fno-sanitize-recover=all"
exit "$status"
