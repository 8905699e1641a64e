#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Generates C++ for random models, compiles it with warnings as errors, explores it over all inputs and compares it with
# the model's semantics. Prints the outcomes, and each cause of a disagreement with a small model. First builds the
# tests of the component in release form.
# Arguments: the number of models (default 100000), the first seed (default 0), the compiler (default c++).
# ROBOCHART_MODELS selects the models: widened (default), core, toolkits, hostile
# (tests/conformance/random/random_shapes.hpp). ROBOCHART_JOBS is the number of processes (default: one for each
# processor). Seeds are processed in ranges of 500; results are stored below build/random_conformance for the current
# program, so that an interrupted run continues where it stopped. A single model that disagrees is shrunk
# (`tests/long.sh conformance 1 SEED`).
set -euo pipefail
cd "$(dirname "$0")/../.."
models="${1:-100000}"
first="${2:-0}"
export ROBOCHART_COMPILER="${3:-c++}"
export ROBOCHART_MODELS="${ROBOCHART_MODELS:-widened}"
jobs="${ROBOCHART_JOBS:-$(nproc)}"
range=500

cmake --preset release -DROBOCHART_TESTS=ON > /dev/null
cmake --build --preset release --target tests_conformance > /dev/null
built=build/release/tests/conformance/tests_conformance
version="$(sha256sum "$built" | cut -c1-12)"
export results="build/random_conformance/$ROBOCHART_MODELS-$(basename "$ROBOCHART_COMPILER")-$version"
mkdir -p "$results"
export program="$results/program"  # later builds do not affect this run
[ -x "$program" ] || cp "$built" "$program"

# One range; its report gets its final name when it is complete.
one_range() {
  local from="$1" count="$2" report="$results/$1-$2.report"
  [ ! -f "$report" ] || return 0
  rm -f "$report.part"
  ROBOCHART_SEEDS="$count" ROBOCHART_FIRST_SEED="$from" ROBOCHART_REPORT="$report.part" nice "$program" \
    --gtest_filter='RandomModels.Campaign' > "$report.log" 2>&1 || true
  if [ -f "$report.part" ] && grep -q '^whole$' "$report.part"; then
    mv "$report.part" "$report" && rm -f "$report.log"
  else
    echo "seeds $from to $((from + count - 1)): the program ended early, see $report.log" >&2
  fi
}
export -f one_range

ranges() {
  local from="$first" end=$((first + models)) count
  while [ "$from" -lt "$end" ]; do
    count=$((end - from < range ? end - from : range))
    echo "$from $count"
    from=$((from + count))
  done
}
ranges | xargs -P "$jobs" -L 1 bash -c 'one_range "$0" "$1"'

wanted=()
missing=0
while read -r from count; do
  if [ -f "$results/$from-$count.report" ]; then wanted+=("$results/$from-$count.report"); else missing=$((missing + 1)); fi
done < <(ranges)
if [ "${#wanted[@]}" -eq 0 ]; then
  echo "nothing was done" >&2
  exit 1
fi

cat "${wanted[@]}" | awk '
  $1 == "models" || $1 == "conforming" || $1 == "cycles" { sum[$1] += $2 }
  $1 == "outcome" || $1 == "construct" { count = $2; kind = $1; $1 = ""; $2 = ""; sub(/^ +/, ""); each[kind, $0] += count; names[kind, $0] = $0; kinds[kind, $0] = kind }
  END {
    printf "%d models, %d conform in %d cycles\n", sum["models"], sum["conforming"], sum["cycles"]
    for (i in each) if (kinds[i] == "outcome") printf "%8d %s\n", each[i], names[i] | "sort -k2"
    close("sort -k2")
    for (i in each) if (kinds[i] == "construct") printf "%8d conforming models with: %s\n", each[i], names[i] | "sort -k5"
    close("sort -k5")
  }'

# Disagreements, and a small model for each cause. A cause is the report without names and numbers.
found="$(cat "${wanted[@]}" | grep '^disagreement ' || true)"
[ -z "$found" ] || echo "$found"
one_of_each() { awk '{ cause = $0; gsub(/[0-9]/, "", cause); cause = substr(cause, 1, 75) } !seen[cause]++ { print $2 }'; }
for seed in $(echo "$found" | one_of_each); do
  report="$results/$seed-1.report"
  [ -f "$report" ] || one_range "$seed" 1
  echo && sed '1,/^disagreement /d; /^whole$/d' "$report"
done
disagreements="$(echo "$found" | grep -c . || true)"
echo "$disagreements disagreements; $missing ranges are not done"
[ "$disagreements" -eq 0 ] && [ "$missing" -eq 0 ]
