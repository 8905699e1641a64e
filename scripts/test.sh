#!/usr/bin/env bash
# Installs what is missing, builds, runs the aggregation case study and all tests: with g++ in release
# form, then with clang, AddressSanitizer and UndefinedBehaviorSanitizer.
# Arguments: the presets to test (default: release asan).
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
presets=("$@")
[ "${#presets[@]}" -gt 0 ] || presets=(release asan)
for preset in "${presets[@]}"; do
  cmake --preset "$preset" -DROBOCHART_TESTS=ON
  cmake --build --preset "$preset"
done
"build/${presets[0]}/app/robochart-verify" corpus/aggregation --out out
for preset in "${presets[@]}"; do
  ctest --preset "$preset" -j "$(nproc)"
done
