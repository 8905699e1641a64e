#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The completion for bash, sourced as users do, offers verbs, their options, the choices of options, and files.
# Argument: the program.
set -euo pipefail
program="$1"
folder="$(cd "$(dirname "$0")/../.." && pwd)"
# shellcheck source=/dev/null
source <("$program" help --generate bash)
failures=0

# The offers for the last of the words, sorted, on one line.
offered() {
  COMP_WORDS=(robochart-verify "$@")
  COMP_CWORD="$#"
  _robochart_verify
  printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' ' | sed 's/ $//'
}

expect() {
  local expected="$1"
  shift
  local found
  found="$(offered "$@")"
  if [ "$found" != "$expected" ]; then
    echo "after '$*': offered '$found', expected '$expected'" >&2
    failures=$((failures + 1))
  fi
}

# The long options in the help of a verb.
options_of() {
  "$program" "$@" --help | sed -n 's/^  \(-[a-z], \|    \)\(--[a-z-]*\).*/\2/p' | sort | tr '\n' ' ' | sed 's/ $//'
}

cd "$folder/corpus"
for verb in verify validate check conform cspm simulate explain format 'emit csp' 'emit cpp' 'emit monitor' 'emit tests'; do
  read -ra words <<<"$verb"
  options="$(options_of "${words[@]}")"
  [ "$(wc -w <<<"$options")" -ge 2 ] || { echo "$verb has no options" >&2; exit 1; }
  expect "$options" "${words[@]}" --
done
expect "$(options_of verify)" aggregation --  # a model as the first word means `verify`
expect "--help --version" --
expect "emit explain" e
expect "aggregation" check agg
expect "aggregation" agg
expect "cpp csp monitor prism rst tests" emit ""
expect "aggregation alpha best_of_n false_claims foraging moving_beacon swarm_taxis" emit cpp ""
expect "check conform cspm draw emit explain format help init lsp prism rules simulate step tune validate verify version" help ""
expect "always auto never" check --color ""
expect "json" check --format js
expect "json" check --format = js
expect "aut csp dot" cspm --export ""
expect "timed-script" check aggregation --print t
expect "" check --timeout ""
expect "aggregation alpha best_of_n false_claims foraging moving_beacon swarm_taxis" check aggregation --out ""
expect "aggregation alpha best_of_n false_claims foraging moving_beacon swarm_taxis" check aggregation -o ""
[ "$failures" -eq 0 ] || { echo "$failures failures" >&2; exit 1; }
complete -p robochart-verify | grep -q _robochart_verify
echo "the completion offers what --help lists"
