#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares searches by ranks with the ordinary search (docs/scale.md):
#   tests/long.sh ranks           threads as 1, 2, 3, 4 and 8 ranks, and as two and three programs of two ranks each, on
#                                    the scripts of the tests and of ROBOCHART_SHARED
#   tests/long.sh ranks --mpirun  2 and 4 real programs, and 2 with two threads each, on ten scripts; searches with
#                                    checkpoints that are ended and resumed; and every documented way to end ranks
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
if [[ "${1:-}" == --mpirun ]]; then
  cmake --build --preset release --target robochart-verify robochart-verify-mpi faulty_ranks
  programs=build/release/app
  python3 tests/app/mpi/compare_ranks.py $programs/robochart-verify $programs/mpi/robochart-verify-mpi mpirun tests/app/mpi/scripts
  python3 tests/app/mpi/keep_ranks.py $programs/robochart-verify mpirun $programs/mpi/robochart-verify-mpi \
    build/release/tests/app/mpi/faulty_ranks
  exec python3 tests/app/mpi/end_ranks.py mpirun $programs/mpi/robochart-verify-mpi build/release/tests/app/mpi/faulty_ranks
fi
cmake --build --preset release --target tests_cspm
failed=0
compared=0
output=$(mktemp)
trap 'rm -f "$output"' EXIT
suite="${ROBOCHART_SHARED:-../shared}/suite"
for folder in tests/app/mpi/scripts tests/app/phases "$suite"/cspm/{evaluator,typechecker}/should_pass "$suite/findings/cspm" "$suite/sleec/expected"; do
  [ -d "$folder" ] || { echo "$folder is not there"; continue; }
  echo "$folder"
  [[ "$folder" != "$suite"/* ]] || compared=$((compared + 1))
  # The test program does not fail if its filter matches no test.
  ROBOCHART_RANKED_SCRIPTS=$folder build/release/tests/checker/cspm/tests_cspm \
    --gtest_filter='RankedScripts.OfAFolder*' | tee "$output" || failed=1
  grep -q '\[       OK \]' "$output" || { echo "$folder: no test has compared anything"; failed=1; }
done
[ "$compared" -gt 0 ] || { echo "none of the folders of $suite is there"; failed=1; }
exit $failed
