#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Mutates the models and scripts of the repository (and of ../shared, if it exists) and runs the whole command on them.
# scripts/hostile_inputs.sh [INPUTS [FIRST_SEED]], by default 30,000 from a new seed, which it prints. An input that
# violates a property is stored in build/hostile/SEED (tests/fuzz/whole_command.py lists the properties).
set -euo pipefail
cd "$(dirname "$0")/.."
inputs="${1:-30000}"
seed="${2:-$(( $(date +%s) * 1000 ))}"
if [ ! -x build/release/app/robochart-verify ]; then
  scripts/setup.sh
  cmake --preset release -DROBOCHART_TESTS=OFF
  cmake --build --preset release --target robochart-verify
fi
roots=(corpus tests)
for shared in "${ROBOCHART_SHARED:-../shared}"/suite "${ROBOCHART_SHARED:-../shared}"/bench; do
  [ -d "$shared" ] && roots+=("$shared")
done
echo "seed $seed"
exec python3 tests/fuzz/whole_command.py build/release/app/robochart-verify "${roots[@]}" --inputs "$inputs" --seed "$seed"
