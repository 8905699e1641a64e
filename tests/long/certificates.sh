#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Attacks on robochart-certify, dropped conditions of it, faults planted in the checker, and random campaigns.
# Argument: the number of trials of the attack (300; a trial has some 650 attacks). Each of 123 conditions of the extracted
# program is dropped in a copy, and each of 44 faults is planted in a copy of the checker. If coqc is found, the proofs
# are checked, too. First builds the command and the tests in release form.
set -euo pipefail
cd "$(dirname "$0")/../.."
trials=${1:-300}
cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target robochart-verify robochart_certifier tests_certify tests_certify_attack
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
tests=build/release/tests/checker/certify
for ((seed = 1; seed <= (trials + 99) / 100; ++seed)); do "$tests/attack" "$seed" 100; done
python3 tests/checker/certify/dropped_conditions.py "$work/dropped"
python3 tests/checker/certify/planted_faults.py build/release "$work/faults"
ROBOCHART_RANDOM_CHECKS=20000 "$tests/tests_certify" --gtest_filter='*Random*'
if command -v coqc > /dev/null; then sh checker/certify/coq/check.sh; fi
