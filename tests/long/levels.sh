#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Decides the assertions of all CSPM scripts in folders with the level search: with 1, 2, 3, 4 and 8 ranks, and with
# states on disk and very little memory. Answers, figures and counterexamples must be equal (docs/search.md, "Out of
# core"). Arguments: folders; the default is the scripts in ROBOCHART_SHARED/suite and in tests.
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target tests_cspm
folders=("$@")
[ "${#folders[@]}" -gt 0 ] || folders=("${ROBOCHART_SHARED:-../shared}/suite" tests)
output=$(mktemp)
trap 'rm -f "$output"' EXIT
for folder in "${folders[@]}"; do
  ROBOCHART_RANKED_SCRIPTS="$folder" build/release/tests/checker/cspm/tests_cspm --gtest_filter='RankedScripts.OfAFolder*' |
    tee "$output"
  # The test program does not fail if its filter matches no test.
  grep -q '\[       OK \]' "$output" || { echo "$folder: no test has compared anything"; exit 1; }
done
