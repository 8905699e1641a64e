#!/bin/sh
# What a monitor beside every controller costs: CPU time of the trials of both case studies with and without, one thread,
# runs in turn, medians. Usage: scripts/bench_monitor.sh [ROUNDS]; the command is build/release's, or VERIFY=PATH.
set -eu
cd "$(dirname "$0")/.."
verify=${VERIFY:-build/release/app/robochart-verify}
rounds=${1:-5}
[ -x "$verify" ] || { echo "build it first: cmake --preset release && cmake --build --preset release --target robochart-verify" >&2; exit 1; }

cpu() { # scenario, option
    "$verify" simulate "$1" --no-pictures --threads 1 --format json ${2:-} 2>/dev/null |
        sed 's/.*"cpuSeconds": *\([0-9.]*\).*/\1/;q'
}
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

for study in aggregation swarm_taxis; do
    scenario=corpus/$study/$study.scenario
    plain='' watched=''
    for _ in $(seq "$rounds"); do
        plain="$plain $(cpu "$scenario")"
        watched="$watched $(cpu "$scenario" --monitor)"
    done
    a=$(printf '%s\n' $plain | median)
    b=$(printf '%s\n' $watched | median)
    echo "$study: $a s without, $b s with monitors: $(awk "BEGIN { printf \"%.1f\", ($b / $a - 1) * 100 }") % of the step's cost"
done
