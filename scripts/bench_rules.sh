#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A SLEEC rule about a model, with `rules` and in SLEEC-TK's published encoding (docs/benchmarks.md): builds our command
# in release form. Arguments are passed on: --values N, --limit STATES.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release > /dev/null
cmake --build --preset release --target robochart-verify
exec python3 benchmarks/decide_rules.py --program build/release/app/robochart-verify "$@"
