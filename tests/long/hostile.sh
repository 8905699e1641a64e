#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Mutates the inputs of the repository (and of ../shared, if it exists) and runs the whole command on them.
# tests/long.sh hostile [--asan] [INPUTS [FIRST_SEED [OPTION...]]], by default 30,000 from a new seed, which it prints.
# --asan uses the command with AddressSanitizer and UndefinedBehaviorSanitizer. Options are passed on:
# --verbs 'rules MODEL=3,conform' (only these, with weights), --accepted 0.5 (the share that the front end must accept),
# --seconds S, --jobs N. An input that violates a property is stored in build/hostile/SEED
# (tests/fuzz/whole_command.py lists the properties).
set -euo pipefail
cd "$(dirname "$0")/../.."
preset=release
sanitized=()
if [ "${1:-}" = --asan ]; then
  preset=asan
  sanitized=(--sanitized)
  shift
fi
inputs="${1:-30000}"
seed="${2:-$(( $(date +%s) * 1000 ))}"
command="build/$preset/app/robochart-verify"
if [ ! -x "$command" ]; then
  scripts/setup.sh
  cmake --preset "$preset" -DROBOCHART_TESTS=OFF
  cmake --build --preset "$preset" --target robochart-verify
fi
roots=(corpus tests)
for shared in "${ROBOCHART_SHARED:-../shared}"/suite "${ROBOCHART_SHARED:-../shared}"/bench; do
  [ -d "$shared" ] && roots+=("$shared")
done
exec python3 tests/fuzz/whole_command.py "$command" "${roots[@]}" --inputs "$inputs" --seed "$seed" "${sanitized[@]}" "${@:3}"
