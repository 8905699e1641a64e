#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fuzzes with libFuzzer, AddressSanitizer and UndefinedBehaviorSanitizer, and prints a summary.
# Arguments: CPU seconds per target (default 600), then the targets (default: all). Failing inputs are stored in
# build/fuzz/found/TARGET, and inputs that reach new code in build/fuzz/corpus/TARGET.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds="${1:-600}"
shift || true
targets=("$@")
[ "${#targets[@]}" -gt 0 ] || targets=(model assertions script semantics editor stream)

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}" random_models_tool
seeds=build/fuzz/seeds
rm -rf "$seeds"

# Copies files below the named folders under names that contain their origin.
gather() {
  local target="$1" extension="$2"
  shift 2
  mkdir -p "$seeds/$target"
  find "$@" -name "*.$extension" -type f -size -200k -print0 | while IFS= read -r -d '' file; do
    cp "$file" "$seeds/$target/$(tr / - <<<"$file")"
  done
}

# The examples in the pages of rules.
examples() {
  awk -v out="$seeds/model/rule" '
    /^```robochart/ { file = sprintf("%s-%04d.rct", out, ++count); next }
    /^```/ { file = "" }
    file != "" { print > file }' docs/rules/*.md
}

# Models that use every construct, and the scripts of the corpus.
generated() {
  local random=build/fuzz/random
  rm -rf "$random"
  for seed in $(seq 1 40); do
    build/fuzz/tests/random_models/random_models_tool --out "$random/$seed" --seed "$seed" >/dev/null
  done
  gather model rct "$random"
  gather semantics rct "$random"
  gather assertions assertions "$random"
  local program
  for program in build/{release,clang,dev,asan}/app/robochart-verify; do
    [ -x "$program" ] || continue
    for model in aggregation swarm_taxis; do
      "$program" emit csp "corpus/$model" --out "build/fuzz/emitted/$model" --quiet >/dev/null
    done
    gather script csp build/fuzz/emitted
    return
  done
  echo "no robochart-verify is built: the scripts of the corpus are left out" >&2
}

# Sessions with an editor: models after a first line with requests and changes, alone and followed by a form feed and
# files that use them (tests/fuzz/targets/editor.cpp).
sessions() {
  local steps=tests/fuzz/regressions/editor/while_typed.txt file
  mkdir -p "$seeds/editor"
  for file in "$seeds"/model/*; do
    { head -n 1 "$steps" && cat "$file"; } >"$seeds/editor/$(basename "$file")"
  done
  for file in corpus/*/*.rct; do
    {
      head -n 1 "$steps"
      cat "$file"
      printf '\finterface Other { var other : nat }\n\f'
      cat "${file%.rct}.assertions"
    } >"$seeds/editor/project-$(basename "$file")"
  done
}

gather model rct corpus tests/frontend/fixtures frontend/toolkits/library
gather semantics rct corpus tests/app/agreeing tests/conformance/models tests/cpp_emit/models
gather assertions assertions corpus tests/frontend/fixtures
gather script csp editors/vscode/tests
for target in "${targets[@]}"; do
  mkdir -p "$seeds/$target"
  find "tests/fuzz/regressions/$target" -type f -exec cp {} "$seeds/$target/" \; 2>/dev/null || true
done
examples
generated
sessions

# One run with a limit in seconds; adds its CPU seconds and executions to `spent` and `executions`.
run() {
  local target="$1" limit="$2" log="build/fuzz/$1.log" dictionary="tests/fuzz/robochart.dict" code=0
  [ "$target" != script ] || dictionary="tests/fuzz/cspm.dict"
  [ "$target" != stream ] || dictionary="tests/fuzz/protocol.dict"
  TIMEFORMAT=%0U
  local cpu
  cpu="$({ time nice -n 10 "build/fuzz/tests/fuzz/targets/fuzz_$target" -max_len=20000 -timeout=60 -rss_limit_mb=2048 \
    -dict="$dictionary" -max_total_time="$limit" -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target/" \
    "build/fuzz/corpus/$target" "$seeds/$target" >"$log" 2>&1; } 2>&1)" || code=$?
  spent=$((spent + cpu))
  executions=$((executions + $(grep -oP 'stat::number_of_executed_units: *\K[0-9]+' "$log" || echo 0)))
  return "$code"
}

# On a shared machine a run gets less CPU time than its duration, so it is run again for the rest.
status=0
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz/corpus/$target" "build/fuzz/found/$target"
  spent=0
  executions=0
  while [ "$((seconds - spent))" -gt 5 ]; do
    if ! run "$target" "$((seconds - spent))"; then
      echo "$target: NOT WELL: see the end of build/fuzz/$target.log, and the input in build/fuzz/found/$target" >&2
      status=1
      break
    fi
    echo "$target: $spent of $seconds CPU seconds, $executions executions" >&2
  done
  echo "$target: $executions executions in $spent CPU seconds," \
    "$(grep -oE 'cov: [0-9]+ ft: [0-9]+ corp: [0-9]+' "build/fuzz/$target.log" | tail -1)"
done
exit "$status"
