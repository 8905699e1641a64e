#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Robot steps per CPU second of the embedded world and of Enki in one run, including the generated controller
# (docs/benchmarks.md). Needs libenki-dev.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -DROBOCHART_TESTS=OFF -DROBOCHART_BENCHMARKS=ON -DROBOCHART_WITH_ENKI=ON >/dev/null
cmake --build --preset release --target benchmark_simulation
exec build/release/simulation/adapters/enki/benchmark_simulation corpus/aggregation/aggregation.scenario
