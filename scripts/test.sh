#!/usr/bin/env bash
# Installs missing packages, builds, runs the aggregation case study and the tests. Without arguments: all tests with g++ in
# release form, then, with clang, AddressSanitizer and UndefinedBehaviorSanitizer, those of the components that read foreign
# text and that decide. Arguments: presets to test completely (`scripts/test.sh asan`).
set -euo pipefail
cd "$(dirname "$0")/.."
sanitized=(diagnostics frontend process lts machine refine cspm)

configure() { # preset
  cmake --preset "$1" -DROBOCHART_TESTS=ON
}
whole() { # preset
  configure "$1"
  cmake --build --preset "$1"
  "build/$1/app/robochart-verify" corpus/aggregation --out out
  ctest --preset "$1" -j "$(nproc)"
}
components() { # preset, components
  configure "$1"
  cmake --build --preset "$1" --target "${@:2}"
  local names
  names=$(IFS='|'; echo "${*:2}")
  ctest --preset "$1" -j "$(nproc)" -R "^(${names//tests_/})\\."
}

scripts/setup.sh
if [ "$#" -gt 0 ]; then
  for preset in "$@"; do whole "$preset"; done
else
  whole release
  components asan "${sanitized[@]/#/tests_}"
fi
