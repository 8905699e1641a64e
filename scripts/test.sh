#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs missing packages, builds, runs the aggregation case study and the tests.
#   scripts/test.sh            all tests: those of the components that parse foreign text and that decide with clang,
#                              AddressSanitizer and UndefinedBehaviorSanitizer, the others with g++ in release form
#   scripts/test.sh --quick    the command, and the tests of the rules' examples and of the project's own rules
#   scripts/test.sh PRESET...  all tests with these presets, for example asan
set -euo pipefail
cd "$(dirname "$0")/.."
sanitized=(diagnostics frontend process lts machine refine cspm)

configure() { # preset, test programs that another build runs
  local elsewhere
  elsewhere=$(IFS=';'; echo "${*:2}")
  cmake --preset "$1" -DROBOCHART_TESTS=ON -DROBOCHART_TESTS_ELSEWHERE="$elsewhere"
}
case_study() { # preset
  "build/$1/app/robochart-verify" corpus/aggregation --out out
}
whole() { # preset, test programs that another build runs
  configure "$@"
  cmake --build --preset "$1"
  case_study "$1"
  ctest --preset "$1" -j "$(nproc)"
}
components() { # preset, components
  configure "$1"
  cmake --build --preset "$1" --target "${@:2}"
  local names
  names=$(IFS='|'; echo "${*:2}")
  ctest --preset "$1" -j "$(nproc)" -R "^(${names//tests_/})\\."
}

case "${1:-}" in
  --quick)
    echo "Builds the command and two test programs, and runs them: about five minutes on two cores."
    scripts/setup.sh quick
    components release tests_rules tests_sanity
    case_study release
    ;;
  "")
    echo "Builds with g++, and partly again with clang and sanitizers, and runs all tests: 15 to 25 minutes on two cores."
    scripts/setup.sh
    whole release "${sanitized[@]}"
    components asan "${sanitized[@]/#/tests_}"
    ;;
  *)
    scripts/setup.sh
    for preset in "$@"; do whole "$preset"; done
    ;;
esac
