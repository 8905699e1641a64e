#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The CMake function adds tests that pass or fail with the verdicts. The script of the GitHub action passes words
# unchanged and keeps the exit code. The hooks of pre-commit run. Arguments: the sources, the build tree.
set -euo pipefail
sources="$1"
build="$2"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }
export XDG_CACHE_HOME="$folder/cache"
mkdir -p "$folder/usr/bin" "$folder/usr/share/robochart-verify"
ln -s "$build/app/robochart-verify" "$folder/usr/bin/robochart-verify"
ln -s "$sources/scripts/cmake" "$folder/usr/share/robochart-verify/cmake"
export PATH="$folder/usr/bin:$PATH"

# Models whose names a shell would split.
project="$folder/a project"
mkdir -p "$project/it holds" "$project/it; fails"
model='stm S { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger e } }'
echo "$model" > "$project/it holds/m.rct"
echo "$model" > "$project/it; fails/m.rct"
mkdir -p "$project/it; says"
echo "$model" > "$project/it; says/m.rct"
echo 'claim Never : never e' > "$project/it; says/m.claims"
echo 'untimed assertion Wrong : S is not deadlock-free' > "$project/it; fails/m.assertions"

cat > "$project/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(robot NONE)
enable_testing()
find_package(robochart-verify REQUIRED)
robochart_verify(MODEL "it holds" NAME holds VERB check OPTIONS --untimed)
robochart_verify(MODEL "it holds/m.rct")
robochart_verify(MODEL "it; fails" NAME fails VERB check)
robochart_verify(MODEL "it; says" NAME claimed VERB check)
robochart_verify(MODEL "it; says/m.claims" NAME valid VERB validate)
END
cmake -S "$project" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/usr" > "$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
status=0
ctest --test-dir "$folder/build" > "$folder/log" 2>&1 || status=$?
[ "$status" -ne 0 ] || fail "a claim that does not hold passes under CTest"
grep -q '2 tests failed out of 5' "$folder/log" || { cat "$folder/log" >&2; exit 1; }
grep -q 'fails (Failed)' "$folder/log" || fail "another test failed than the false claim's"
grep -q 'claimed (Failed)' "$folder/log" || fail "a claim in a claims file is not decided under CTest"
[ -d "$folder/build/robochart.verify.m/csp-gen" ] || fail "what verify writes is not below the build tree"
for wrong in 'MODEL nowhere' 'VERB check' 'MODEL "it holds" VERB remove' 'MODEL "it holds" MODE check'; do
  printf 'cmake_minimum_required(VERSION 3.22)\nproject(r NONE)\nenable_testing()\nfind_package(robochart-verify REQUIRED)\nrobochart_verify(%s)\n' "$wrong" > "$project/CMakeLists.txt"
  if cmake -S "$project" -B "$folder/wrong" -DCMAKE_PREFIX_PATH="$folder/usr" > "$folder/log" 2>&1; then fail "robochart_verify($wrong) is accepted"; fi
  grep -q 'robochart_verify' "$folder/log" || fail "the cause is not named for $wrong"
done

# Tests the action's script.
cd "$project"
script="$sources/scripts/verify_models.sh"
code() { "$@" > "$folder/log" 2>&1 && echo 0 || echo $?; }
[ "$(MODEL='it holds' VERB=check code bash "$script")" = 0 ] || fail "the action fails where all holds"
[ "$(MODEL=$'it holds\n\nit; fails\n' VERB=check OPTIONS=$'--untimed\n' JUNIT="$folder/report.xml" code bash "$script")" = 1 ] || fail "the action does not fail"
grep -q '<failure' "$folder/report.xml" || fail "the report of the action has no failure"
[ "$(MODEL='it; says' VERB=check JUNIT="$folder/report.xml" code bash "$script")" = 1 ] || fail "the action does not fail for a claim"
grep -q 'testcase.*Never.*never e' "$folder/report.xml" || fail "the report of the action does not name the claim"
[ "$(MODEL='$(touch x)' VERB=check code bash "$script")" = 2 ] || fail "a model that is not there is no error"
[ "$(MODEL='--help' VERB=check code bash "$script")" = 2 ] || fail "a model's name is taken for an option"
[ "$(MODEL='it holds' VERB='check; touch x' code bash "$script")" = 4 ] || fail "any verb is accepted"
[ ! -e x ] || fail "text of a workflow was run"

# The hooks get the files of a commit.
hooks=0
while read -r entry; do
  hooks=$((hooks + 1))
  # shellcheck disable=SC2086  # the shell must split the entry into words
  $entry "it holds/m.rct" > "$folder/log" 2>&1 || { cat "$folder/log" >&2; fail "the hook '$entry' fails"; }
done < <(sed -n 's/^  entry: //p' "$sources/.pre-commit-hooks.yaml")
[ "$hooks" -eq 2 ] || fail "two hooks were expected, found $hooks"
echo "the CMake function, the action's script and the hooks work"
