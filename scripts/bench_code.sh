#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Compares generated code with hand-written nested switches on four machines (docs/cpp.md, "Speed and size"): equality
# of hashes, then sizes, compile time, and nanoseconds per step over random and repeating events, in several layouts of
# the program.
# Usage: scripts/bench_code.sh [LAYOUTS [COMPILER [STRATEGY]]]. The command is that of build/release or build/dev, or
# VERIFY=PATH.
set -eu
cd "$(dirname "$0")/.."
verify=${VERIFY:-build/release/app/robochart-verify}
[ -x "$verify" ] || verify=build/dev/app/robochart-verify
[ -x "$verify" ] || { echo "build it first: cmake --preset release && cmake --build --preset release --target robochart-verify" >&2; exit 1; }
exec python3 benchmarks/bench_code.py "$verify" "${1:-60}" "${2:-g++}" "${3:-auto}"
