#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The cost that a monitor for every controller adds to a robot's step, in both case studies, with 20 and with 100
# robots. Both variants run in one process and one thread, in alternating blocks of steps; CPU time
# (benchmarks/monitor_benchmark.cpp).
# Usage: scripts/bench_monitor.sh [ROUNDS]
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -DROBOCHART_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target benchmark_monitor
exec build/release/benchmarks/benchmark_monitor "${1:-25}" corpus/aggregation/aggregation.scenario corpus/swarm_taxis/swarm_taxis.scenario
